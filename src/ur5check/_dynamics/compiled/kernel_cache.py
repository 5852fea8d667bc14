"""The cache of generated code on disk.

A file is named after a hash of the arm's numbers, the quantity and the generating code.  Its first
line is the SHA-256 of the rest; a file that does not match is generated again.  A folder that
others may write to is refused, since its code would be executed.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
from pathlib import Path

from ..._errors import UsageError
from ..._files import write_whole

__all__ = ["cache_folder", "kept"]

_VARIABLE = "UR5CHECK_CACHE"
_MARK = b"# SHA-256 of what follows: "


def cache_folder() -> Path:
    """The folder of generated code, created for this user only.

    $UR5CHECK_CACHE, or `ur5check` under $XDG_CACHE_HOME or ~/.cache.

    Raises UsageError if it cannot be created, or others own it or may write to it.
    """
    given = os.environ.get(_VARIABLE)
    root = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(given) if given else Path(root) / "ur5check"
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        state = folder.stat()
    except OSError as error:
        raise UsageError(
            f"{folder}: cannot store generated code there ({error.strerror}); set {_VARIABLE} to "
            "a folder of your own"
        ) from None
    if hasattr(os, "getuid") and (state.st_uid != os.getuid() or state.st_mode & 0o022):
        raise UsageError(
            f"{folder}: others may write there; chmod 700 it, or set {_VARIABLE} to "
            "a folder of your own"
        )
    return folder


def kept(name: str, make: Callable[[], bytes]) -> bytes:
    """The code of that name, read from disk, or generated and stored.

    name : of the file, with the hash;  make : called only if the file is missing or damaged
    """
    file = cache_folder() / name
    code = _whole(file)
    if code is None:
        code = make()
        write_whole(file, b"%b%b\n%b" % (_MARK, _digest(code), code))
    return code


def _whole(file: Path) -> bytes | None:
    try:
        head, _, code = file.read_bytes().partition(b"\n")
    except OSError:
        return None
    return code if head == _MARK + _digest(code) else None


def _digest(code: bytes) -> bytes:
    return hashlib.sha256(code).hexdigest().encode()
