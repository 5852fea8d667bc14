"""A baseline: what is there today is known, what is new fails."""

from __future__ import annotations

import json

import pytest

from judged_files import SPOILED, SPOILED_NAME, judged
from ur5check._cli.main import main
from ur5check._errors import UsageError
from ur5check._validation.baseline import Baseline, baseline_of, read_baseline, with_baseline

FEW = ("--samples", "5", "--quiet")
HEAVY = SPOILED.replace('<link name="base"/>', '<link name="base"/>\n<link name="lost"/>')


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "arm.urdf").write_text(SPOILED)
    return tmp_path


def rules(verdicts) -> list[str]:
    return [f.rule for f in verdicts.models[0].findings.open]


def test_known_findings_count_for_nothing_and_new_ones_do(here):
    verdicts, _ = judged(here)
    baseline = baseline_of(verdicts, Baseline(here))
    (here / "b.json").write_text(baseline.text())
    assert read_baseline(here / "b.json") == baseline
    assert [entry.rule for entry in baseline.entries if entry.file == SPOILED_NAME] == ["INE101"]

    again = with_baseline(verdicts, baseline)
    assert rules(again) == []
    assert again.passed
    moved = SPOILED.replace("<robot", "<!--\n-->\n<robot").replace('value="-1"', 'value="-3"')
    assert with_baseline(judged(here, moved)[0], baseline).passed
    worse, _ = judged(here, HEAVY)
    assert rules(with_baseline(worse, baseline)) == [r for r in rules(worse) if r != "INE101"] != []


def test_what_was_repaired_is_gone(here):
    baseline = baseline_of(judged(here)[0], Baseline(here))
    repaired, _ = judged(here, SPOILED.replace('value="-1"', 'value="2"'))
    assert "INE101" in {entry.rule for entry in baseline.gone(repaired)}
    assert "INE101" not in {entry.rule for entry in baseline_of(repaired, baseline).entries}


def test_the_command_writes_it_only_when_asked(here, capsys):
    assert main(["validate", "arm.urdf", "--baseline", "b.json", *FEW]) == 2
    assert not (here / "b.json").exists()
    assert main(["validate", "arm.urdf", "--update-baseline", *FEW]) == 2
    update = ["--baseline", "b.json", "--update-baseline"]
    assert main(["validate", "arm.urdf", *update, *FEW]) == 0
    assert main(["validate", "arm.urdf", "--baseline", "b.json", *FEW]) == 0
    (here / "arm.urdf").write_text(HEAVY)
    assert main(["validate", "arm.urdf", "--baseline", "b.json", *FEW]) == 1
    capsys.readouterr()
    (here / "second.urdf").write_text(SPOILED)
    assert main(["validate", "second.urdf", *update, *FEW]) == 0
    entries = json.loads((here / "b.json").read_text())["findings"]
    assert {entry["file"] for entry in entries} == {"arm.urdf", "second.urdf"}


def test_it_is_valid_from_another_folder(here, monkeypatch, capsys):
    update = ["--baseline", "b.json", "--update-baseline"]
    assert main(["validate", "arm.urdf", *update, *FEW]) == 0
    (here / "sub").mkdir()
    monkeypatch.chdir(here / "sub")
    assert main(["validate", "../arm.urdf", "--baseline", "../b.json", *FEW]) == 0


def test_sarif_says_what_is_new(here, capsys):
    update = ["--baseline", "b.json", "--update-baseline"]
    assert main(["validate", "arm.urdf", *update, *FEW]) == 0
    (here / "arm.urdf").write_text(HEAVY)
    main(["validate", "arm.urdf", "--baseline", "b.json", *FEW, "-o", "r.sarif"])
    (run,) = json.loads((here / "r.sarif").read_text())["runs"]
    states = {result["ruleId"]: result["baselineState"] for result in run["results"]}
    prints = {r["ruleId"]: r["partialFingerprints"]["ur5check/v1"] for r in run["results"]}
    assert states.pop("INE101") == states.pop("JNT103") == "unchanged"
    assert set(states.values()) == {"new"}
    entries = json.loads((here / "b.json").read_text())["findings"]
    known = {entry["rule"]: entry["fingerprint"] for entry in entries}
    assert known["INE101"] == prints["INE101"]


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"schema": "ur5check.baseline/1"}', "{"])
def test_what_is_no_baseline_is_refused(here, text):
    (here / "b.json").write_text(text)
    with pytest.raises(UsageError):
        read_baseline(here / "b.json")
    (here / "b.json").write_text('{"schema": "ur5check.baseline/1", "findings": [{"rule": 1}]}')
    with pytest.raises(UsageError):
        read_baseline(here / "b.json")
