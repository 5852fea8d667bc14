"""`ur5check COMMAND …`: run the command and return its exit code.

    0    models pass or agree; the command has done its work
    1    they do not
    2    wrong usage or input; one line on stderr says what is wrong and what to do
    130  interrupted (SIGINT);  141  the reader of stdout has closed it (SIGPIPE)

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

from .._errors import Ur5checkError, UsageError
from .._version import __version__
from .parser import Parser

__all__ = ["main"]

COMMANDS = {
    "validate": "check models: inertias, laws of dynamics, agreement with Pinocchio",
    "diff": "compare two models: torque difference, wrong parameters, mistakes",
    "engines": "compare what Pinocchio, MuJoCo, Drake, DART and iDynTree import",
    "log": "compare a model with a recording of the robot",
    "rules": "the rules that validate applies; ur5check rules ID explains one",
    "show": "print a model's joints, geometry and inertias",
    "sweep": "compare two models at millions of states",
    "expand": "expand a xacro to URDF, without ROS",
    "convert": "write a model as URDF, MJCF or DH table",
    "export": "write a model as packages for Gazebo",
    "derive": "derive torques, M, C or g in closed form: Python, C, SymPy, LaTeX",
    "paper": "reproduce the paper (SSRN 3939013) and judge its claims",
    "simulate": "hold an arm with the gravity torques of a model",
}

_DESCRIPTION = """\
Checks dynamics models of robot arms: finds the parameters that are wrong, and
their effect on the joint torques in newton metres.

commands:
{commands}

`ur5check COMMAND --help` describes the options of a command.
Exit code 0: models pass or agree, 1: they do not, 2: wrong usage or input.
"""

_EXAMPLES = """\
examples:
  ur5check validate my_arm.urdf
  ur5check diff vendor.urdf mine.urdf
  ur5check validate              (the models of the paper)
"""


_GREETING = """\
ur5check finds the wrong numbers in a robot arm's dynamics model.

  ur5check validate my_arm.urdf         what is wrong in a model, and where
  ur5check diff vendor.urdf mine.urdf   which numbers differ, in newton metres
  ur5check engines my_arm.urdf          what physics engines import from it
  ur5check show my_arm.urdf             joints, geometry, inertias as read
  ur5check rules                        what validate asks of a model

`ur5check --help` lists all commands, `ur5check COMMAND --help` its options.
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
        return _fail("not enough memory; use fewer --samples")
    except OSError as error:
        return _fail(f"{error.strerror or error}{f': {error.filename}' if error.filename else ''}")
    except Exception:  # noqa: BLE001 - a crash must not exit with 1, which means "they differ"
        traceback.print_exc()
        return _fail("this is a defect of ur5check; please report it with the lines above")
    return code


def _run(argv: list[str]) -> int:
    if not argv:
        print(_GREETING, end="")  # noqa: T201
        return 0
    if argv[0] == "--completion":
        return _completion(argv[1:])
    if not argv[0].startswith("-") and argv[0] not in COMMANDS:
        from .._io.suggestions import did_you_mean

        raise UsageError(f"no command is called {argv[0]!r}; {did_you_mean(argv[0], COMMANDS)}")
    command = _parser().parse_args(argv[:1]).command
    module = import_module(f".{command}", __package__)
    own = Parser(
        prog=f"ur5check {command}",
        description=module.__doc__,
        epilog=module.EXAMPLES,
    )
    module.add_options(own)
    code: int = module.run(own.parse_args(argv[1:]))
    return code


def _completion(words: list[str]) -> int:
    from .completion import SHELLS, completion_script

    if len(words) != 1 or words[0] not in SHELLS:
        raise UsageError(f"--completion takes one of {', '.join(SHELLS)}")
    print(completion_script(words[0], COMMANDS))  # noqa: T201
    return 0


def _parser() -> argparse.ArgumentParser:
    listed = "\n".join(f"  {name:10}{text}" for name, text in COMMANDS.items())
    parser = Parser(
        prog="ur5check",
        usage="ur5check [--help] [--version] [--completion SHELL] COMMAND …",
        description=_DESCRIPTION.format(commands=listed),
        epilog=_EXAMPLES,
    )
    parser.add_argument("command", choices=COMMANDS, metavar="COMMAND", help=argparse.SUPPRESS)
    parser.add_argument("--version", action="version", version=f"ur5check {__version__}")
    parser.add_argument(
        "--completion",
        metavar="SHELL",
        help="print a script that completes commands in bash, zsh or tcsh",
    )
    return parser


def _fail(message: str, code: int = 2) -> int:
    """Print an error as one line, whatever a file's name or text contains."""
    print(f"ur5check: error: {' '.join(message.split())}", file=sys.stderr)  # noqa: T201
    return code


def _abandon_stdout() -> None:
    """Discard what Python flushes to stdout when it ends."""
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except (OSError, ValueError):  # not a real file: nothing to flush
        return
