"""`ur5check COMMAND …`: find the command, run it, turn what happens into an exit code.

    0    it agrees, it passes, it is done
    1    it does not
    2    bad input or usage; one line on stderr says what is wrong and what to do
    130  interrupted;  141  the reader of our output went away (as a shell reports SIGINT, SIGPIPE)

Nothing heavy is imported before a command runs: `ur5check --help` is as fast as Python.
"""

from __future__ import annotations

import argparse
import io
import os
import sys
import traceback
from collections.abc import Sequence
from importlib import import_module

from .._errors import Ur5checkError
from .._version import __version__
from .parser import Parser

__all__ = ["main"]

COMMANDS = {
    "validate": "do the laws hold, do the engines agree, are differences accounted for",
    "diff": "what differs between two models, by how many newton metres, and why",
    "sweep": "the same at millions of states: how often, how much, where in the reach",
    "paper": "the paper's nine cases, and what came of each of its claims",
    "simulate": "the paper's test 9: does an arm stand under a model's torques, or move",
    "engines": "do Pinocchio, MuJoCo, Drake, DART, … mean the same robot; who is here",
    "derive": "torques, M, C or g in closed form, as Python, C, SymPy or LaTeX",
    "show": "a model as ur5check understands it",
    "expand": "a xacro as the URDF that it stands for",
    "convert": "a model written as URDF, MJCF or DH table",
    "export": "a package that hands an arm to Gazebo, torque-driven",
}

_EXAMPLES = """\
examples:
  ur5check validate
  ur5check diff paper appendix
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit code."""
    for stream in (sys.stdout, sys.stderr):
        # Reports are UTF-8 whatever the locale says; a file name that is not is escaped.
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="backslashreplace")
    try:
        code = _run(sys.argv[1:] if argv is None else list(argv))
        sys.stdout.flush()
    except SystemExit as request:  # --help and --version
        return request.code if isinstance(request.code, int) else 0
    except BrokenPipeError:
        _abandon_stdout()
        return 141
    except KeyboardInterrupt:
        return _fail("interrupted", 130)
    except Ur5checkError as error:
        return _fail(str(error))
    except MemoryError:
        return _fail("there is not enough memory for this; take fewer --samples")
    except OSError as error:
        return _fail(f"{error.strerror or error}{f': {error.filename}' if error.filename else ''}")
    except Exception:  # noqa: BLE001 - a crash must not exit with 1, which means "they differ"
        traceback.print_exc()
        return _fail("this is a defect of ur5check; please report it with the lines above")
    return code


def _run(argv: list[str]) -> int:
    parser = _parser()
    command = parser.parse_args(argv[:1]).command
    module = import_module(f".{command}", __package__)
    own = Parser(
        prog=f"ur5check {command}",
        description=module.__doc__,
        epilog=module.EXAMPLES,
    )
    module.add_options(own)
    code: int = module.run(own.parse_args(argv[1:]))
    return code


def _parser() -> argparse.ArgumentParser:
    listed = "\n".join(f"  {name:10}{text}" for name, text in COMMANDS.items())
    parser = Parser(
        prog="ur5check",
        usage="ur5check [--help] [--version] COMMAND …",
        description="Says which number of a robot arm's dynamics model is wrong, by how many "
        f"newton metres, and where it matters.\n\ncommands:\n{listed}\n\n"
        "`ur5check COMMAND --help` tells more.  Exit code 0: agrees, 1: does not, 2: bad input.",
        epilog=_EXAMPLES,
    )
    parser.add_argument("command", choices=COMMANDS, metavar="COMMAND", help=argparse.SUPPRESS)
    parser.add_argument("--version", action="version", version=f"ur5check {__version__}")
    return parser


def _fail(message: str, code: int = 2) -> int:
    """Say it in one line, whatever a file's name or text held."""
    print(f"ur5check: error: {' '.join(message.split())}", file=sys.stderr)  # noqa: T201
    return code


def _abandon_stdout() -> None:
    """Python flushes stdout once more at its end; let that go nowhere."""
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except (OSError, ValueError):  # not a real file: nothing to flush
        return
