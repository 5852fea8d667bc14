"""JSON reports: strict, as the schema says, and every field on the docs page."""

from __future__ import annotations

import hashlib
import math
import re
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

import ur5check
from report_schema import FILE, SCHEMA, VALIDATOR, read_report
from repository import REPOSITORY
from ur5check._comparison.attribution_detail import by_parameter
from ur5check._comparison.difference import Difference
from ur5check._comparison.explanation import Explanation
from ur5check._reports.diff_json import diff_json
from ur5check._reports.json_report import Report, json_text
from ur5check._reports.json_schema import REPORTS, schema_text
from ur5check._reports.show_json import show_json
from ur5check._reports.validate_json import validate_json
from ur5check._validation.validation import Validation

DOCS = REPOSITORY / "docs"


def read_back(report: Report) -> dict[str, Any]:
    """Through its text, the schema and the report's type."""
    return read_report(json_text(report))


def test_the_schema_is_one() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


def test_the_schema_that_ships_is_that_of_the_types() -> None:
    assert FILE.read_text(encoding="utf-8") == schema_text()  # python docs/generate_schema.py


def test_every_command_has_its_type_and_one_version_rule() -> None:
    tags = [report.__struct_config__.tag for report in REPORTS]
    assert len(set(tags)) == len(tags)
    assert all(re.fullmatch(r"ur5check\.[a-z-]+/\d+", str(tag)) for tag in tags)
    for report in REPORTS:
        assert {"tool", "command", "inputs", "seed", "samples"} <= set(report.__struct_fields__)


def test_the_schema_refuses_a_wrong_report(validation: Validation) -> None:
    report = read_back(validate_json(validation))
    report["checks"][0]["value"] = "small"
    assert not VALIDATOR.is_valid(report)


def test_the_schema_accepts_a_field_that_is_added(validation: Validation) -> None:
    report = read_back(validate_json(validation))
    report["checks"][0]["new"] = 1
    VALIDATOR.validate(report)


def test_validation(validation: Validation) -> None:
    report = read_back(validate_json(validation, command="ur5check validate"))
    assert report["schema"] == "ur5check.validate/2"
    judged = dict.fromkeys(("files", "agreement"))  # of files, not of arms
    assert report["verdict"] == dict.fromkeys(report["verdict"], True) | judged
    assert len(report["checks"]) == len(validation.outcomes)
    assert report["command"] == "ur5check validate"
    assert {check["id"] for check in report["checks"] if check["bound"] == "above"} == {
        "mass-positive"
    }


def test_failure(failing: Validation) -> None:
    report = read_back(validate_json(failing))
    assert not report["passed"]
    assert False in report["verdict"].values()
    failed = [check for check in report["checks"] if check["status"] == "fail"]
    assert all(check["value"] > check["tolerance"] for check in failed)
    assert all(len(check["worst_state"]["q"]) == 6 for check in failed)


def test_difference_keeps_every_digit(difference: Difference) -> None:
    report = read_back(diff_json(difference))["comparison"]
    assert [row["max"] for row in report["torques"]] == difference.torques.maximum.tolist()
    shares = [contribution["share"] for contribution in report["attribution"]["contributions"]]
    assert sum(shares) == pytest.approx(1.0)
    limits = [row["effort_limit"] for row in report["torques"]]
    assert limits == [None if math.isnan(x) else x for x in difference.torques.effort]


def test_the_worst_state_makes_the_maximum_again(difference: Difference) -> None:
    report = read_back(diff_json(difference))["comparison"]
    for i, row in enumerate(report["torques"]):
        q, qd, qdd = (np.array(row["worst_state"][key]) for key in ("q", "qd", "qdd"))
        tau_a, tau_b = (
            ur5check.rnea(arm, q, qd, qdd) for arm in (difference.pair.a, difference.pair.b)
        )
        assert abs(tau_a - tau_b)[i] == pytest.approx(row["max"], rel=1e-12, abs=1e-12)


def test_a_quick_report_leaves_the_explanation_out(difference: Difference) -> None:
    report = read_back(diff_json(difference))
    assert report["explanation"] is None
    assert report["by_parameter"] is None


def test_the_explanation_comes_whole(explanation: Explanation) -> None:
    report = read_back(diff_json(explanation.difference, explanation))
    for key in report["explanation"]:
        part = {name: value for name, value in report["explanation"].items() if name != key}
        assert not VALIDATOR.is_valid(report | {"explanation": part}), key


def test_contributions_and_terms_add_up(explanation: Explanation) -> None:
    report = read_back(diff_json(explanation.difference, explanation))
    contributions = report["comparison"]["attribution"]["contributions"]
    assert sum(contribution["weight"] for contribution in contributions) == pytest.approx(1.0)
    assert sum(contribution["share"] for contribution in contributions) == pytest.approx(1.0)
    # Of three parts, none can be more than the whole and the two others.
    whole = np.array(report["explanation"]["error_budget"]["total"])
    gravity, coriolis, inertial = (
        np.array(part) for part in report["explanation"]["terms"].values()
    )
    assert (whole <= gravity + coriolis + inertial + 1e-9).all()


def test_every_parameter_has_one_label(explanation: Explanation) -> None:
    report = read_back(diff_json(explanation.difference, explanation))
    seen = report["explanation"]["identifiability"]
    labelled = [*seen["identifiable"], *seen["in_combination"], *seen["unidentifiable"]]
    assert (seen["columns"], seen["rank"]) == (60, 36)
    assert len(set(labelled)) == len(labelled) == 60
    assert len(seen["combinations"]) == 36
    assert not seen["equivalent"]


def test_findings_are_evidence(explanation: Explanation) -> None:
    report = read_back(diff_json(explanation.difference, explanation))
    found = report["explanation"]["diagnosis"]
    assert [finding["before"] for finding in found[1:]] == [f["after"] for f in found[:-1]]
    assert sum(f["removes"] for f in found) == pytest.approx(1.0, abs=0.15)
    lost = [f for f in found if f["id"] == "length-sign"]
    if explanation.difference.pair.a.name == "paper-listing":
        assert [(f["side"], f["where"]) for f in lost] == [("a", [2, 3, 5])]
        assert report["explanation"]["unexplained"] == []
    else:
        assert lost == []
        assert {(u["link"], u["quantity"]) for u in report["explanation"]["unexplained"]} == {
            (3, "tensor"),
            (6, "tensor"),
        }


def test_the_worst_case_makes_its_value_again(explanation: Explanation) -> None:
    d = explanation.difference
    names = [joint.name for joint in d.pair.a.joints]
    cases = read_back(diff_json(d, explanation))["explanation"]["worst_case"]
    assert len(cases) == 2 * (len(names) + 1)
    for case in cases:
        if case["joint"] is None:
            continue
        q, qd, qdd = (np.array(case["state"][key]) for key in ("q", "qd", "qdd"))
        tau_a, tau_b = (ur5check.rnea(arm, q, qd, qdd) for arm in (d.pair.a, d.pair.b))
        assert abs(tau_a - tau_b)[names.index(case["joint"])] == pytest.approx(
            case["value"], rel=1e-9, abs=1e-9
        )
        assert case["static"] is not bool(np.any(qd) or np.any(qdd))


def test_parameters_on_demand(difference: Difference) -> None:
    parameters = by_parameter(difference.pair, difference.states)
    report = read_back(diff_json(difference, parameters=parameters))
    assert len(report["by_parameter"]) == 63
    assert sum(contribution["share"] for contribution in report["by_parameter"]) == pytest.approx(
        1.0
    )


MJCF = """<mujoco model="m"><worldbody><body name="one">
<joint name="j" axis="0 0 1"/><inertial pos="0 0 1" mass="1" diaginertia="1 1 1"/>
</body></worldbody></mujoco>"""
SDF = """<sdf version="1.9"><model name="s"><link name="base"/><link name="one"><inertial>
<pose>0 0 1 0 0 0</pose><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz>
<ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial></link>
<joint name="foot" type="fixed"><parent>world</parent><child>base</child></joint>
<joint name="j" type="revolute"><parent>base</parent><child>one</child>
<axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"""


@pytest.mark.parametrize(("file", "text", "kind"), [("m.xml", MJCF, "mjcf"), ("s.sdf", SDF, "sdf")])
def test_models_of_other_formats(tmp_path: Path, file: str, text: str, kind: str) -> None:
    (tmp_path / file).write_text(text)
    arm = ur5check.load(tmp_path / file)
    assert read_back(show_json(arm))["model"]["kind"] == kind
    report = read_back(diff_json(ur5check.diff(arm, arm, samples=5)))
    assert {report["comparison"][side]["kind"] for side in "ab"} == {kind}
    report = read_back(validate_json(ur5check.validate(arm, samples=5)))
    assert report["models"][0]["model"]["kind"] == kind
    (given,) = report["inputs"]
    assert given["sha256"] == hashlib.sha256(text.encode()).hexdigest()


@pytest.mark.parametrize("name", ["paper", "appendix"])
def test_arm(name: str) -> None:
    report = read_back(show_json(ur5check.load(name)))
    assert report["model"]["name"] == report["model"]["label"] == name
    assert len(report["joints"]) == len(report["links"]) == 6


def test_every_field_is_documented() -> None:
    page = (DOCS / "json.md").read_text(encoding="utf-8")

    def names(node: Any) -> set[str]:
        if isinstance(node, list):
            return set().union(*map(names, node)) if node else set()
        if not isinstance(node, dict):
            return set()
        own = set(node["properties"]) if isinstance(node.get("properties"), dict) else set()
        return own | names(list(node.values()))

    assert [name for name in names(SCHEMA) if not re.search(rf"[`.]{name}\b", page)] == []
