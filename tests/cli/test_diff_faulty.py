"""`diff` of models that cannot exist, or cannot be read."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from report_schema import read_report
from ur5check import diff
from urdf_examples import GOOD, spoiled

if TYPE_CHECKING:
    from .conftest import Command

LOST_POINT = ('ixx="0.02"', 'ixx="20.02"')


@pytest.fixture
def good(tmp_path: Path) -> Path:
    path = tmp_path / "good.urdf"
    path.write_text(GOOD)
    return path


def beside(good: Path, old: str, new: str) -> Path:
    path = good.with_name("faulty.urdf")
    path.write_bytes(spoiled(old, new))
    return path


@pytest.mark.parametrize("swapped", [False, True])
def test_an_impossible_model_is_compared_and_its_faults_are_said(
    ur5check: Command, good: Path, swapped: bool
) -> None:
    faulty = beside(good, *LOST_POINT)
    pair = (faulty, good) if swapped else (good, faulty)
    said = ur5check("diff", *pair, "--samples", 20, "--quick", "--format", "json")
    comparison = read_report(said.out)["comparison"]
    assert said.code == 1
    sound, unsound = ("b", "a") if swapped else ("a", "b")
    assert comparison[f"faults_{sound}"] == []
    (fault,) = comparison[f"faults_{unsound}"]
    assert fault["rule"] == "INE103"
    (place,) = fault["places"]
    assert (place["file"], place["line"]) == (str(faulty), 15)
    text = ur5check("diff", *pair, "--samples", 20, "--quick").out
    assert "faulty.urdf:15" in "".join(text.split())
    assert comparison["torques"][1]["max"] == pytest.approx(0.0, abs=1e-9)


def test_equal_models_that_cannot_exist_do_not_pass(ur5check: Command, good: Path) -> None:
    faulty = beside(good, *LOST_POINT)
    assert diff(faulty, faulty, samples=20).agrees
    assert ur5check("diff", faulty, faulty, "--samples", 20, "--quick").code == 1
    assert ur5check("diff", good, good, "--samples", 20, "--quick").code == 0


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ('izz="0.04"', 'izz="0,04"', 15),
        ('<mass value="2.0"/>', "", 12),
        ("</robot>", "</robo>", 37),
    ],
)
def test_a_number_that_cannot_be_read_is_a_fault_of_the_model(
    ur5check: Command, good: Path, old: str, new: str, line: int
) -> None:
    faulty = beside(good, old, new)
    code, out, err = ur5check("diff", good, faulty)
    assert (code, out) == (1, "")
    assert err.splitlines()[-1].startswith(f"ur5check: error: {faulty}:{line}: ")


def test_a_file_that_is_not_there_is_wrong_usage(ur5check: Command, good: Path) -> None:
    assert ur5check("diff", good, good.with_name("no.urdf")).code == 2
    assert ur5check("diff", good, good, "--tip-b", "nowhere").code == 2
