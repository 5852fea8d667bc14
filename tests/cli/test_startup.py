"""`--help` is instant because it imports nothing; `python -m ur5check` is the command."""

from __future__ import annotations

import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from ur5check._cli.main import COMMANDS

if TYPE_CHECKING:
    from .conftest import Command

HEAVY = (
    "numpy", "pinocchio", "mujoco", "pydrake", "dartpy", "idyntree", "rich", "lxml", "yourdfpy",
    "xacro", "hypothesis", "numba", "llvmlite", "jax", "distributed", "pyarrow", "sympy",
    "matplotlib", "scipy",
)  # fmt: skip


@pytest.mark.parametrize(
    "arguments", [("--help",), ("--version",), *((name, "--help") for name in COMMANDS)]
)
def test_help_imports_nothing_heavy(arguments: tuple[str, ...]) -> None:
    program = (
        "import sys; from ur5check._cli.main import main; code = main(sys.argv[1:]); "
        f"print([name for name in {HEAVY} if name in sys.modules], file=sys.stderr); sys.exit(code)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, *arguments], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "[]\n")
    assert done.stdout


def test_only_the_chosen_command_is_imported() -> None:
    program = (
        "import sys; from ur5check._cli.main import main; main(['show', '--help']); "
        "print(sorted(n for n in sys.modules if n.startswith('ur5check.')), file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert "ur5check._cli.show" in done.stderr
    assert "ur5check._cli.diff" not in done.stderr
    assert "ur5check._reports" not in done.stderr


def test_as_a_module(process: Command) -> None:
    said = process("diff", "paper", "appendix", "--quick", "--samples", 50)
    assert said.code == 1
    assert "DIFFER: " in said.out
    assert process("diff", "paper").code == 2


def test_piped_text_has_no_colour_and_100_columns(process: Command) -> None:
    said = process("validate", "--samples", 50, "--quiet")
    assert (said.code, said.err) == (0, "")
    assert "\x1b" not in said.out
    lines = [line for line in said.out.splitlines() if not line.startswith("read: ")]
    assert max(map(len, lines)) == 100
