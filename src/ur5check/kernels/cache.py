"""Where generated code is kept between runs, and why it can be trusted.

A module is kept by the name of what it was made from: the numbers of the arm, the quantity, and the
versions that made it.  Its first line carries the SHA-256 of the rest; a file that does not match
is made again.  Code found in a folder that others may write would be other people's code, so such a
folder is refused.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import secrets
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ..errors import UsageError

__all__ = ["cache_folder", "generated_module"]

_VARIABLE = "UR5CHECK_CACHE"
#: A thread must not be handed the module that another is still compiling.
_ONE_AT_A_TIME = threading.Lock()
_MARK = "# SHA-256 of what follows: "


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


def generated_module(key: str, source: Callable[[], str]) -> Any:
    """The module of that key: imported, read from disk, or made.

    key : what the source is made from, hashed;  source : makes its text, called only when needed
    """
    with _ONE_AT_A_TIME:
        return _found(f"ur5check_kernel_{key}", source)


def _found(name: str, source: Callable[[], str]) -> Any:
    if name in sys.modules:
        return sys.modules[name]
    file = cache_folder() / f"{name}.py"
    if not _whole(file):
        _write(file, source())
    spec = importlib.util.spec_from_file_location(name, file)
    assert spec is not None and spec.loader is not None  # noqa: S101 - a .py file has a loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    try:
        spec.loader.exec_module(module)
    except BaseException:
        del sys.modules[name]
        raise
    return module


def _whole(file: Path) -> bool:
    try:
        head, _, rest = file.read_text("utf-8").partition("\n")
    except (OSError, UnicodeDecodeError):
        return False
    return head == _MARK + _digest(rest)


def _write(file: Path, source: str) -> None:
    draft = file.with_name(f".{file.name}.{secrets.token_hex(4)}.tmp")
    draft.write_text(f"{_MARK}{_digest(source)}\n{source}", "utf-8")
    draft.replace(file)


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode("utf-8")).hexdigest()
