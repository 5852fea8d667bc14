"""Warnings of a compiled library while it reads a model, captured for the report.

Engines written in C++ print to the process's own stdout and stderr, past Python, or log.  A report
goes to stdout, so nothing else may.
"""

from __future__ import annotations

import logging
import os
import re
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager

__all__ = ["captured_log", "captured_output"]

_COLOUR = re.compile(r"\x1b\[[0-9;]*m")


@contextmanager
def captured_output() -> Iterator[list[str]]:
    """The lines that compiled code prints during the block; filled when the block ends.

    For short blocks in one thread: file descriptors belong to the whole process.
    """
    lines: list[str] = []
    sys.stdout.flush()
    sys.stderr.flush()
    originals = os.dup(1), os.dup(2)
    with tempfile.TemporaryFile() as output:
        try:
            for descriptor in (1, 2):
                os.dup2(output.fileno(), descriptor)
            yield lines
        finally:
            for descriptor, original in zip((1, 2), originals, strict=True):
                os.dup2(original, descriptor)
                os.close(original)
            output.seek(0)
            text = _COLOUR.sub("", output.read().decode("utf-8", "replace"))
            lines += [line.strip() for line in text.splitlines() if line.strip()]


@contextmanager
def captured_log(name: str) -> Iterator[list[str]]:
    """The messages of a logger during the block, kept from the terminal."""
    lines: list[str] = []
    logger = logging.getLogger(name)

    class Keep(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            lines.append(" ".join(record.getMessage().split()))

    handler, propagated = Keep(), logger.propagate
    logger.addHandler(handler)
    logger.propagate = False
    try:
        yield lines
    finally:
        logger.removeHandler(handler)
        logger.propagate = propagated
