"""Where generated code is kept between runs, and why it can be trusted.

Code is kept by the name of what it was made from: the numbers of the arm, the quantity, and what
made it.  A file's first line carries the SHA-256 of the rest; a file that does not match is made
again.  Code found in a folder that others may write would be other people's code, so such a folder
is refused.
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
    """The folder of generated code, made if it is not there, for this user only.

    $UR5CHECK_CACHE, or `ur5check` under $XDG_CACHE_HOME or ~/.cache.

    Raises UsageError if it cannot be made, or others own it or may write into it.
    """
    given = os.environ.get(_VARIABLE)
    root = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(given) if given else Path(root) / "ur5check"
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        state = folder.stat()
    except OSError as error:
        raise UsageError(
            f"{folder}: generated code cannot be kept there ({error.strerror}); set {_VARIABLE} to "
            "a folder of your own"
        ) from None
    if hasattr(os, "getuid") and (state.st_uid != os.getuid() or state.st_mode & 0o022):
        raise UsageError(
            f"{folder}: others may write generated code there; chmod 700 it, or set {_VARIABLE} to "
            "a folder of your own"
        )
    return folder


def kept(name: str, make: Callable[[], bytes]) -> bytes:
    """The code of that name: read from disk, or made and left there.

    name : of a file, and of what the code is made from, hashed;  make : called only when needed
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
