"""`ur5check --completion SHELL`: a script that completes commands, options and files in a shell."""

from __future__ import annotations

import argparse
from importlib import import_module

from .._errors import UsageError

__all__ = ["SHELLS", "completion_script"]

SHELLS = ("bash", "zsh", "tcsh")


def completion_script(shell: str, commands: dict[str, str]) -> str:
    """The script.  commands : name and one line on each.  Raises UsageError without shtab."""
    try:
        import shtab
    except ImportError:
        raise UsageError("completion needs shtab; pip install 'ur5check[completion]'") from None
    parser = argparse.ArgumentParser(prog="ur5check")
    parser.add_argument("--version", action="store_true", help="show the version")
    below = parser.add_subparsers()
    for name, text in commands.items():
        command = below.add_parser(name, help=text, description=text)
        import_module(f".{name}", __package__).add_options(command)
        for action in command._actions:
            if action.metavar in ("FILE", "MODEL", "A", "B"):
                action.complete = shtab.FILE  # type: ignore[attr-defined]
    script: str = shtab.complete(parser, shell)
    return script
