"""`diff` finds what was planted in a file, and --repair takes it out again."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from ur5check._cli.repaired_model import repair
from ur5check._comparison.diagnosis.diagnosis import diagnose
from ur5check._comparison.difference import diff

if TYPE_CHECKING:
    from .conftest import Command

FEW = ("--samples", 50)


@pytest.fixture
def good(ur5check: Command, tmp_path: Path) -> Path:
    """The appendix as a URDF."""
    path = tmp_path / "good.urdf"
    assert ur5check("expand", "appendix", "-o", path).code == 0
    return path


@pytest.fixture
def planted(good: Path) -> Path:
    """Its upper arm's centre of mass with the wrong sign, its forearm's tensor ten times itself."""
    text = good.read_text()
    for right, wrong in (
        ('xyz="0.0 0.0 0.28"', 'xyz="0.0 0.0 -0.28"'),
        ('ixx="0.03121679102890359"', 'ixx="0.3121679102890359"'),
        ('iyy="0.03121679102890359"', 'iyy="0.3121679102890359"'),
        ('izz="0.004095"', 'izz="0.04095"'),
    ):
        assert text.count(right) == 1
        text = text.replace(right, wrong)
    path = good.with_name("planted.urdf")
    path.write_text(text)
    return path


def test_what_was_planted_is_found_and_mended(
    ur5check: Command, planted: Path, tmp_path: Path
) -> None:
    repaired, report = tmp_path / "repaired.urdf", tmp_path / "report.json"
    code, _, err = ur5check(
        "diff", "appendix", planted, *FEW, "--repair", repaired, "-o", report, "--acceleration", 5
    )
    assert code == 1, err
    found = json.loads(report.read_text(encoding="utf-8"))
    explained = found["explanation"]
    findings = {f["id"]: (f["side"], f["where"]) for f in explained["diagnosis"]}
    assert findings["centre-sign"] == ("b", [2])
    assert findings["tensor-scaled"][1] == [3]
    assert explained["unexplained"] == []
    assert explained["diagnosis"][-1]["after"] == pytest.approx(0.0, abs=1e-9)
    assert max(abs(x) for case in explained["worst_case"] for x in case["state"]["qdd"]) == 5.0
    assert found["command"].endswith("--acceleration 5.0")
    said = [line for line in err.splitlines() if "repaired: " in line]
    assert any("Link 2 of " in line and "centre of mass" in line for line in said)
    assert any("Link 3 of " in line and "tensor" in line for line in said)
    assert err.endswith(f"wrote {repaired}\n")
    assert ur5check("diff", "appendix", repaired, *FEW, "--quick").code == 0
    before, after = (file.read_text().splitlines() for file in (planted, repaired))
    changed = [(x, y) for x, y in zip(before, after, strict=True) if x != y]
    assert len(changed) == 2  # the line of the centre, and that of the tensor
    assert f"{planted}:" in next(line for line in err.splitlines() if "-0.28 → " in line)


def test_a_mistake_in_a_is_not_mended_in_b(
    ur5check: Command, planted: Path, tmp_path: Path
) -> None:
    repaired = tmp_path / "repaired.urdf"
    code, _, err = ur5check("diff", planted, "appendix", *FEW, "--repair", repaired)
    assert code == 1
    assert re.search(r"not repaired: Link 2 of \w+: .*; A is the one to repair: swap the", err)
    assert not re.search(r": repaired: Link 2 ", err)


def test_the_listing_is_mended(tmp_path: Path) -> None:
    """The paper's listing against its own tables, either way round; its gravity stays unsaid."""
    file = tmp_path / "repaired.urdf"
    said: list[str] = []
    for a, b in (("paper", "paper-listing"), ("paper-listing", "paper")):
        difference = diff(a, b, samples=50)
        found = diagnose(difference.pair, difference.states)
        repair(difference, found, str(file), said.append)
        if b == "paper-listing":
            assert said[-1] == f"wrote {file}: a new URDF, since paper-listing is no URDF"
            assert diff(a, file, samples=50).agrees
            assert any("a URDF carries no gravity: give --gravity X Y Z" in line for line in said)
            file.unlink()
        else:
            assert said[-1] == f"{file} is not written: nothing to repair in paper"
            assert not file.exists()


def test_no_input_is_overwritten(ur5check: Command, good: Path, planted: Path) -> None:
    before = planted.read_bytes()
    for file in (good, planted):
        code, out, err = ur5check("diff", good, planted, *FEW, "--repair", file)
        assert (code, out) == (2, ""), err
        assert err.endswith(f"--repair {file}: is one of the inputs; name another file\n")
    assert planted.read_bytes() == before


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (
            ("--repair", "b.urdf", "--quick"),
            "--repair needs the explanation that --quick leaves out",
        ),
        (("--acceleration", 5, "--quick"), "--acceleration needs the explanation"),
        (("--repair", "b.xml"), "end its name in .urdf"),
        (("--repair", "b.urdf", "-o", "b.urdf"), "the report goes there"),
        (("--repair", "no/such/b.urdf"), "--repair no/such/b.urdf: there is no folder"),
        (("--acceleration", -1), "acceleration must be a positive finite number"),
    ],
)
def test_options_without_meaning(
    ur5check: Command, options: tuple[object, ...], said: str, monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    code, out, err = ur5check("diff", "paper", "paper", *FEW, *options)
    assert (code, out) == (2, "")
    assert said in err
    assert list(tmp_path.iterdir()) == []


def test_quick_says_what_without_why(ur5check: Command) -> None:
    code, out, err = ur5check("diff", "paper", "appendix", *FEW, "--quick", "--by-parameter")
    assert code == 1
    assert "── The numbers ──" in out
    assert "── Mistakes found ──" not in out
    assert "\nParameter by parameter\n" in out
    assert "looking for known mistakes" not in err
    assert "--samples 50 --seed 0 --quick --by-parameter\n" in out


def test_the_explanation_in_markdown_writes_combinations_out(ur5check: Command) -> None:
    out = ur5check("diff", "paper", "paper", *FEW, "--format", "markdown").out
    assert "\n### Identifiable combinations\n" in out
    assert "\n## Mistakes found\n\nNothing: there is no difference to explain.\n" in out
