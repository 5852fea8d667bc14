"""Atomic writing: after any interruption a file is the old one or the new one, whole.

The content is written beside the target and then takes its place in one step.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import shutil
from collections.abc import Iterator
from pathlib import Path

__all__ = ["draft_of", "write_whole"]


def write_whole(path: Path, data: bytes) -> None:
    """Write a file, keeping the permissions of the one that it replaces.  Raises OSError."""
    target = path.resolve()  # a link stays a link
    with draft_of(target) as draft:
        with draft.open("xb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        if target.exists():
            shutil.copymode(target, draft)


@contextlib.contextmanager
def draft_of(target: Path) -> Iterator[Path]:
    """A path beside `target` for a file or folder that takes its place when the block ends.

    After an exception the target is untouched, and the draft is removed.
    """
    draft = target.with_name(f".{target.name}.{secrets.token_hex(4)}.tmp")
    try:
        yield draft
        draft.replace(target)
    except BaseException:
        with contextlib.suppress(OSError):
            if draft.is_dir():
                shutil.rmtree(draft)
            else:
                draft.unlink()
        raise
