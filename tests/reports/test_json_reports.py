"""JSON reports: strict, as the schema says, and every field on the docs page."""

from __future__ import annotations

import json
import math
import re
from typing import Any

import jsonschema
import numpy as np
import pytest

import ur5check
from repository import REPOSITORY
from ur5check._comparison.attribution_detail import by_parameter
from ur5check._comparison.difference import Difference
from ur5check._comparison.explanation import Explanation
from ur5check._reports.diff_json import diff_json, validate_json
from ur5check._reports.json_values import json_text
from ur5check._reports.show_json import show_json
from ur5check._validation.validation import Validation

DOCS = REPOSITORY / "docs"
SCHEMA = json.loads((DOCS / "schemas" / "report-1.schema.json").read_text(encoding="utf-8"))


def read_back(report: dict[str, Any]) -> dict[str, Any]:
    """Through text and the schema, refusing what strict JSON does not have."""

    def refuse(name: str) -> None:
        raise AssertionError(f"{name} is not JSON")

    value = json.loads(json_text(report), parse_constant=refuse)
    jsonschema.Draft202012Validator(SCHEMA).validate(value)
    return dict(value)


def test_the_schema_is_one() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


def test_the_schema_refuses_a_wrong_report(validation: Validation) -> None:
    report = validate_json(validation)
    report["checks"][0]["value"] = "small"
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.Draft202012Validator(SCHEMA).validate(report)


def test_validation(validation: Validation) -> None:
    report = read_back(validate_json(validation, command="ur5check validate"))
    assert report["schema"] == "ur5check.validation/1"
    assert report["verdict"] == dict.fromkeys(report["verdict"], True)
    assert len(report["checks"]) == len(validation.outcomes)
    assert report["command"] == "ur5check validate"
    assert {check["id"] for check in report["checks"] if check["bound"] == "above"} == {
        "mass-positive"
    }


def test_failure(failing: Validation) -> None:
    report = read_back(validate_json(failing))
    assert not report["verdict"]["passed"]
    failed = [check for check in report["checks"] if check["status"] == "fail"]
    assert all(check["value"] > check["tolerance"] for check in failed)
    assert all(len(check["worst_state"]["q"]) == 6 for check in failed)


def test_difference_keeps_every_digit(difference: Difference) -> None:
    report = read_back(diff_json(difference))
    assert [row["max"] for row in report["torques"]] == difference.torques.maximum.tolist()
    shares = [contribution["share"] for contribution in report["account"]["contributions"]]
    assert sum(shares) == pytest.approx(1.0)
    limits = [row["effort_limit"] for row in report["torques"]]
    assert limits == [None if math.isnan(x) else x for x in difference.torques.effort]


def test_the_worst_state_makes_the_maximum_again(difference: Difference) -> None:
    report = read_back(diff_json(difference))
    for i, row in enumerate(report["torques"]):
        q, qd, qdd = (np.array(row["worst_state"][key]) for key in ("q", "qd", "qdd"))
        tau_a, tau_b = (
            ur5check.rnea(arm, q, qd, qdd) for arm in (difference.pair.a, difference.pair.b)
        )
        assert abs(tau_a - tau_b)[i] == pytest.approx(row["max"], rel=1e-12, abs=1e-12)


EXPLAINED = {
    "attribution",
    "terms",
    "identifiability",
    "error_budget",
    "worst_case",
    "diagnosis",
    "unexplained",
    "plausibility",
}


def test_a_quick_report_leaves_the_explanation_out(difference: Difference) -> None:
    assert not EXPLAINED & set(diff_json(difference))


def test_the_explanation_comes_whole(explanation: Explanation) -> None:
    report = read_back(diff_json(explanation.difference, explanation))
    assert set(report) >= EXPLAINED
    for key in EXPLAINED:
        part = {name: value for name, value in report.items() if name != key}
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.Draft202012Validator(SCHEMA).validate(part)


def test_owners_and_terms_add_up(explanation: Explanation) -> None:
    report = read_back(diff_json(explanation.difference, explanation))
    contributions = report["attribution"]
    assert sum(contribution["weight"] for contribution in contributions) == pytest.approx(1.0)
    assert sum(contribution["share"] for contribution in contributions) == pytest.approx(1.0)
    # Of three parts, none can be more than the whole and the two others.
    whole = np.array(report["error_budget"]["total"])
    gravity, coriolis, inertial = (np.array(part) for part in report["terms"].values())
    assert (whole <= gravity + coriolis + inertial + 1e-9).all()


def test_every_parameter_has_one_label(explanation: Explanation) -> None:
    seen = read_back(diff_json(explanation.difference, explanation))["identifiability"]
    labelled = [*seen["identifiable"], *seen["in_combination"], *seen["invisible"]]
    assert (seen["columns"], seen["rank"]) == (60, 36)
    assert len(set(labelled)) == len(labelled) == 60
    assert len(seen["combinations"]) == 36
    assert not seen["equivalent"]


def test_findings_are_evidence(explanation: Explanation) -> None:
    report = read_back(diff_json(explanation.difference, explanation))
    found = report["diagnosis"]
    assert [finding["before"] for finding in found[1:]] == [f["after"] for f in found[:-1]]
    assert sum(f["removes"] for f in found) == pytest.approx(1.0, abs=0.15)
    lost = [f for f in found if f["id"] == "length-sign"]
    if explanation.difference.pair.a.name == "paper-listing":
        assert [(f["side"], f["where"]) for f in lost] == [("a", [2, 3, 5])]
        assert report["unexplained"] == []
    else:
        assert lost == []
        assert {(u["link"], u["quantity"]) for u in report["unexplained"]} == {
            (3, "tensor"),
            (6, "tensor"),
        }


def test_the_worst_case_makes_its_value_again(explanation: Explanation) -> None:
    d = explanation.difference
    names = [joint.name for joint in d.pair.a.joints]
    cases = read_back(diff_json(d, explanation))["worst_case"]
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


@pytest.mark.parametrize("name", ["paper", "appendix"])
def test_arm(name: str) -> None:
    report = read_back(show_json(ur5check.load(name)))
    assert report["name"] == name
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
