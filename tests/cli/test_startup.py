"""`--help` is instant because it imports nothing; `python -m ur5check` is the command."""

from __future__ import annotations

import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

import ur5check
from ur5check._cli.main import COMMANDS
from ur5check._io.urdf.urdf_writer import urdf_of

if TYPE_CHECKING:
    from pathlib import Path

    from .conftest import Command

HEAVY = (
    "numpy", "pinocchio", "mujoco", "pydrake", "dartpy", "idyntree", "rich", "lxml", "yourdfpy",
    "xacro", "hypothesis", "llvmlite", "jax", "distributed", "pyarrow", "sympy",
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
    assert "ur5check._reports.document" not in done.stderr
    assert "ur5check._reports.json_report" not in done.stderr


#: Each takes longer to import than the command needs for its work.
_NOT_FOR_A_URDF = ("scipy", "trimesh", "collada", "networkx", "sympy", "yourdfpy", "xacro", "numba",
                   "llvmlite", "matplotlib")  # fmt: skip


@pytest.mark.parametrize(
    ("arguments", "also"),
    [
        (("show",), ("pinocchio",)),
        (("show", "--format", "json"), ("pinocchio", "rich")),
        (("validate", "--samples", "20"), ()),
        (("diff", "--samples", "20"), ("pinocchio", "rich", "msgspec")),
        (("diff", "--quick", "--full", "--samples", "20"), ()),
    ],
)
def test_a_urdf_without_meshes_needs_no_heavy_library(
    arguments: tuple[str, ...], also: tuple[str, ...], tmp_path: Path
) -> None:
    models = []
    for name in ("paper", "appendix")[: 2 if arguments[0] == "diff" else 1]:
        file = tmp_path / f"{name}.urdf"
        file.write_text(urdf_of(ur5check.load(name)), encoding="utf-8")
        models.append(str(file))
    program = (
        "import sys; from ur5check._cli.main import main; main(sys.argv[1:]); "
        f"print([m for m in {(*_NOT_FOR_A_URDF, *also)} if m in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, *arguments, *models, "--quiet"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stdout
    assert done.stderr == "[]\n"


def test_as_a_module(process: Command) -> None:
    said = process("diff", "paper", "appendix", "--quick", "--samples", 50)
    assert said.code == 1
    assert said.out.startswith("DIFFER ")
    assert process("diff", "paper").code == 2


def test_piped_text_has_no_colour_and_100_columns(process: Command) -> None:
    said = process("validate", "--samples", 50, "--quiet", "--full")
    assert (said.code, said.err) == (0, "")
    assert "\x1b" not in said.out
    lines = [line for line in said.out.splitlines() if not line.startswith("read: ")]
    assert max(map(len, lines)) == 100
