"""Writing a package's folder: all of its files, or none."""

from __future__ import annotations

from collections.abc import Mapping
from collections.abc import Set as AbstractSet
from pathlib import Path

from ..._errors import UsageError
from ..._files import draft_of

__all__ = ["check_folder", "write_folder"]


def check_folder(folder: str) -> None:
    """Refuse, before any work is done, a folder that may not be written.

    Raises UsageError if it is there and holds something, is no folder, or has none above it.
    """
    target = Path(folder)
    if target.exists() and not target.is_dir():
        raise UsageError(f"{folder}: is a file; name a folder that is not there yet")
    if target.is_dir() and any(target.iterdir()):
        raise UsageError(
            f"{folder}: is not empty; name a folder that is not there yet, or clear it"
        )
    if not target.absolute().parent.is_dir():
        raise UsageError(f"{folder}: there is no folder {str(target.parent)!r}; make it first")


def write_folder(
    folder: str, files: Mapping[str, bytes], programs: AbstractSet[str] = frozenset()
) -> None:
    """Write the files beside the folder, then put them in its place in one step.

    files : content by path inside the folder;  programs : paths of those that may be executed

    Raises UsageError as `check_folder` does, and if writing fails.
    """
    check_folder(folder)
    target = Path(folder).absolute()
    try:
        with draft_of(target) as draft:
            for path, content in files.items():
                file = draft / path
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(content)
                if path in programs:
                    file.chmod(0o755)
    except OSError as error:
        raise UsageError(f"{folder}: cannot be written: {error.strerror}") from None
