"""argparse, with errors as one line and help laid out as it was written."""

from __future__ import annotations

import argparse
from typing import NoReturn

from .._errors import UsageError

__all__ = ["Parser"]


class Parser(argparse.ArgumentParser):
    """An ArgumentParser whose errors are UsageErrors, which end like all others."""

    def __init__(self, *, prog: str, description: str | None, epilog: str, usage: str = "") -> None:
        super().__init__(
            prog=prog,
            usage=usage or None,
            description=description,
            epilog=epilog,
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
        )

    def error(self, message: str) -> NoReturn:
        """Raise UsageError, with where to look."""
        raise UsageError(f"{message}; see `{self.prog} --help`")
