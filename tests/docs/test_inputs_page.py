"""Every bad input of docs/inputs.md is fed to `ur5check.load`, and the printed error comes out.

A table belongs to the last fenced file above it, `pendulum.urdf` say.  Each row spoils that file:
the text of its second cell is replaced by that of its third.  A row of a table with two cells is
a call, and what it raises.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import pytest

import ur5check
from repository import REPOSITORY
from ur5check._errors import Ur5checkError

PAGE = REPOSITORY / "docs" / "inputs.md"
NOTHING = "nothing"


@dataclass(frozen=True)
class Spoiled:
    file: str
    text: str
    fault: str
    old: str
    new: str
    error: str

    def spoiled_text(self) -> str:
        if self.old == "the whole file":
            return self.new
        assert self.text.count(self.old) == 1, f"{self.old!r} must stand in {self.file} once"
        return self.text.replace(self.old, self.new)


@dataclass(frozen=True)
class Call:
    code: str
    error: str


def examples() -> tuple[dict[str, str], list[Spoiled], list[Call]]:
    """The page's good files, its faults, its calls."""
    files: dict[str, str] = {}
    faults: list[Spoiled] = []
    calls: list[Call] = []
    file = ""
    text = PAGE.read_text(encoding="utf-8")
    block = re.compile(r"^`([\w.]+)`:\n\n```\w+\n((?:.*\n)*?)```\n|^\| (.*) \|$", re.M)
    for found in block.finditer(text):
        if found[1]:
            file = found[1]
            files[file] = found[2]
            continue
        cells = [cell.strip() for cell in found[3].split(" | ")]
        if len(cells) == 4 and cells[3].startswith("`"):
            old, new, error = (code(cell) for cell in cells[1:])
            faults.append(Spoiled(file, files[file], cells[0], old, new, error))
        elif len(cells) == 2 and cells[0].startswith("`ur5check."):
            calls.append(Call(code(cells[0]), code(cells[1])))
    return files, faults, calls


def code(cell: str) -> str:
    """What stands between a cell's backticks; a cell without them is words of our own."""
    found = re.fullmatch(r"`(.*)`", cell)
    if found:
        return found[1].replace("\\n", "\n")
    return "" if cell == NOTHING else cell


FILES, FAULTS, CALLS = examples()


def test_page_has_its_examples() -> None:
    assert set(FILES) == {
        "pendulum.urdf", "pendulum.xacro", "pendulum.xml", "pendulum.sdf", "pendulum.toml",
    }  # fmt: skip
    assert len(FAULTS) >= 80
    assert len(CALLS) >= 8


@pytest.mark.parametrize("name", FILES)
def test_good_file_is_read(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path(name).write_text(FILES[name], encoding="utf-8")
    assert ur5check.load(name).n == 1


@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: f"{fault.file}: {fault.fault}")
def test_bad_file_meets_the_printed_error(
    fault: Spoiled, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path(fault.file).write_text(fault.spoiled_text(), encoding="utf-8")
    with pytest.raises(Ur5checkError) as raised:
        ur5check.load(fault.file)
    assert str(raised.value) == fault.error


@pytest.mark.parametrize("call", CALLS, ids=lambda call: call.code)
def test_bad_call_meets_the_printed_error(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    arm = ur5check.load("paper")
    with pytest.raises(Ur5checkError) as raised:
        eval(call.code, {"ur5check": ur5check, "arm": arm})  # noqa: S307 - our own page
    assert str(raised.value) == call.error
