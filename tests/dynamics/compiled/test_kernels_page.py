"""docs/kernels.md: its code prints what it says, in a process of its own."""

from __future__ import annotations

import re
import subprocess
import sys

from repository import REPOSITORY
from ur5check._dynamics.compiled.kernel import Kernel
from ur5check._dynamics.compiled.machine_code import BLOCK as LLVM_BLOCK
from ur5check._dynamics.compiled.numpy_source import BLOCK as NUMPY_BLOCK

PAGE = (REPOSITORY / "docs" / "kernels.md").read_text(encoding="utf-8")


def blocks(language: str) -> str:
    return "".join(re.findall(rf"^```{language}\n(.*?)^```", PAGE, re.M | re.S))


def test_code_prints_what_the_page_says() -> None:
    # JAX's 64 bits are switched on for a whole process.
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", blocks("python")],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stdout == blocks("text")


def test_every_function_is_on_the_page() -> None:
    functions = {name for name in vars(Kernel) if not name.startswith("_")}
    said = set(re.findall(r"^\| `(\w+)\(", PAGE, re.M))
    assert said == functions - {"arm", "threads", "path"}


def test_blocks_are_as_long_as_the_page_says() -> None:
    assert f"{LLVM_BLOCK} states at a time" in PAGE
    assert f"{NUMPY_BLOCK:,} states at a time" in PAGE
