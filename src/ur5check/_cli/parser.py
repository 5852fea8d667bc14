"""argparse with errors as UsageError and descriptions laid out as they are written."""

from __future__ import annotations

import argparse
import textwrap
from typing import NoReturn

from .._errors import UsageError

__all__ = ["Parser"]


class Parser(argparse.ArgumentParser):
    """An ArgumentParser that raises UsageError instead of exiting."""

    def __init__(self, *, prog: str, description: str | None, epilog: str, usage: str = "") -> None:
        super().__init__(
            prog=prog,
            usage=usage or None,
            description=_filled(description or ""),
            epilog=_filled(epilog),
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
        )

    def error(self, message: str) -> NoReturn:
        """Raise UsageError that names the help of the command."""
        raise UsageError(f"{message}; see `{self.prog} --help`")


def _filled(text: str) -> str:
    """Paragraphs filled to 79 columns; those with indented lines (lists, examples) unchanged."""
    paragraphs = text.strip().split("\n\n")
    return "\n\n".join(
        paragraph if "\n  " in paragraph else textwrap.fill(" ".join(paragraph.split()), 79)
        for paragraph in paragraphs
    )
