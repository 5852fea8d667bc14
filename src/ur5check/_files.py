"""Whole files: written in one step, and read only where they are files of a bounded size.

After any interruption a file is the old or the new one: the content is written beside the target
and then takes its place.  A device or a pipe in the place of a description would be read for ever.
"""

from __future__ import annotations

import contextlib
import errno
import os
import secrets
import shutil
import stat
from collections.abc import Iterator
from pathlib import Path

__all__ = ["LARGEST_INPUT", "draft_of", "read_regular", "write_whole"]

#: Larger than any description of a robot (meshes are files of their own) [bytes].
LARGEST_INPUT = 64 * 2**20


def read_regular(path: str | os.PathLike[str], most: int = LARGEST_INPUT) -> bytes:
    """The bytes of a regular file.

    Raises OSError for a device, a pipe or a folder, and for a file of more than `most` bytes.
    """
    found = os.stat(path)  # noqa: PTH116 - links are followed, nothing is opened
    if not stat.S_ISREG(found.st_mode):
        raise OSError(errno.EINVAL, "is no regular file", str(path))
    if found.st_size > most:
        raise OSError(errno.EFBIG, f"has more than {most:,} bytes", str(path))
    with open(path, "rb") as file:  # noqa: PTH123 - also where pathlib would list folders
        data = file.read(most + 1)
    if len(data) > most:
        raise OSError(errno.EFBIG, f"has more than {most:,} bytes", str(path))
    return data


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
