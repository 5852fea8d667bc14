"""What a compiled library prints while it reads a model, caught instead of printed.

Engines written in C++ warn on the process's own stdout and stderr, past Python.  A report goes to
stdout, so nothing else may; and what an engine says of a model belongs into the report.
"""

from __future__ import annotations

import os
import re
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager

__all__ = ["capturing"]

_COLOUR = re.compile(r"\x1b\[[0-9;]*m")


@contextmanager
def capturing() -> Iterator[list[str]]:
    """The lines that compiled code prints meanwhile; filled when the block ends.

    For short blocks in one thread: file descriptors belong to the whole process.
    """
    lines: list[str] = []
    sys.stdout.flush()
    sys.stderr.flush()
    kept = os.dup(1), os.dup(2)
    with tempfile.TemporaryFile() as caught:
        try:
            for descriptor in (1, 2):
                os.dup2(caught.fileno(), descriptor)
            yield lines
        finally:
            for descriptor, original in zip((1, 2), kept, strict=True):
                os.dup2(original, descriptor)
                os.close(original)
            caught.seek(0)
            text = _COLOUR.sub("", caught.read().decode("utf-8", "replace"))
            lines += [line.strip() for line in text.splitlines() if line.strip()]
