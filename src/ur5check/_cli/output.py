"""Writing of results: to stdout, or to files, which are written completely or not at all."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

from .._errors import UsageError
from .._files import write_whole

__all__ = ["check_folder", "check_output", "emit", "emit_files"]


def check_output(output: str | None, inputs: Iterable[Path], *, option: str = "-o") -> None:
    """Refuse, before any work, an output that cannot or must not be written.

    option : the one that named the file, for messages

    Raises UsageError.
    """
    if output is None:
        return
    target = Path(output)
    if target.is_dir():
        raise UsageError(f"{option} {output}: is a folder; name a file in it")
    folder = target.resolve().parent
    if not folder.is_dir():
        raise UsageError(f"{option} {output}: there is no folder {str(folder)!r}; make it first")
    if not os.access(target if target.exists() else folder, os.W_OK):
        raise UsageError(f"{option} {output}: may not be written; check the permissions")
    for file in inputs:
        if target.exists() and file.exists() and target.samefile(file):
            raise UsageError(f"{option} {output}: is one of the inputs; name another file")


def check_folder(folder: str, *, option: str) -> None:
    """Refuse, before any work is done, a folder that files cannot be put into.

    It may be there, with other files in it, or be made in a folder that is.  Raises UsageError.
    """
    target = Path(folder)
    if target.exists() and not target.is_dir():
        raise UsageError(f"{option} {folder}: is no folder; name one")
    above = target.resolve().parent
    if not above.is_dir():
        raise UsageError(f"{option} {folder}: there is no folder {str(above)!r}; make it first")
    if not os.access(target if target.exists() else above, os.W_OK):
        raise UsageError(f"{option} {folder}: may not be written; check the permissions")


def emit_files(files: Mapping[str, bytes], folder: str, *, option: str) -> None:
    """Put files into a folder, in the place of older ones of their names.

    files : content by name.  Raises UsageError if one cannot be written.
    """
    target = Path(folder).resolve()
    try:
        target.mkdir(exist_ok=True)
        for name, content in files.items():
            write_whole(target / name, content)
    except OSError as error:
        raise UsageError(f"{option} {folder}: cannot be written: {error.strerror}") from None


def emit(text: str, output: str | None, *, option: str = "-o") -> None:
    """Write the result, whole.  Raises UsageError if it cannot be written."""
    if output is None:
        try:
            sys.stdout.write(text)
            sys.stdout.flush()
        except BrokenPipeError:
            raise
        except OSError as error:
            raise UsageError(f"stdout cannot be written: {error.strerror}") from None
        return
    data = text.encode("utf-8", "backslashreplace")
    target = Path(output).resolve()  # a link stays a link
    try:
        if target.exists() and not target.is_file():
            target.write_bytes(data)  # /dev/null, a pipe: nothing to put in its place
        else:
            write_whole(target, data)
    except OSError as error:
        raise UsageError(f"{option} {output}: cannot be written: {error.strerror}") from None
