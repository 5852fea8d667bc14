"""Two versions of one file, whose robots have the same name, are told apart in every report."""

from __future__ import annotations

from pathlib import Path

import pytest

import ur5check
from report_schema import read_report
from ur5check import SerialArm
from ur5check._io.shipped_models import SHIPPED_MODELS
from ur5check._reports.diff_document import diff_document
from ur5check._reports.diff_json import diff_json
from ur5check._reports.json_report import json_text
from ur5check._reports.simulate_document import simulate_document
from ur5check._reports.sweep_document import sweep_document
from ur5check._reports.terminal import render_text
from ur5check._reports.validate_document import validate_document
from ur5check._simulation.static_hold import stand


@pytest.fixture(params=[("old.toml", "new.toml"), ("old/ur5.toml", "new/ur5.toml")])
def versions(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[SerialArm, SerialArm]:
    """The paper's model and one whose last link is heavier, both named "paper"."""
    text = SHIPPED_MODELS["paper"].path().read_text(encoding="utf-8")
    arms = []
    for file, mass in zip(request.param, ("0.1879", "0.3"), strict=True):
        path = tmp_path / file
        path.parent.mkdir(exist_ok=True)
        assert "0.1879" in text
        path.write_text(text.replace("0.1879", mass), encoding="utf-8")
        arms.append(ur5check.load(path))
    a, b = arms
    assert a.name == b.name
    return a, b


def expected(arms: tuple[SerialArm, SerialArm]) -> tuple[str, str]:
    file = Path(arms[0].source.inputs[0][0]).name
    return ("old.toml", "new.toml") if file == "old.toml" else ("A", "B")


def test_diff(versions: tuple[SerialArm, SerialArm]) -> None:
    a, b = expected(versions)
    explanation = ur5check.explain(ur5check.diff(*versions, samples=20))
    d = explanation.difference
    text = render_text(diff_document(d, explanation), width=200)
    title, *_ = text.splitlines()
    assert title.startswith(f"{a} ({versions[0].name}")
    assert f" against {b} ({versions[1].name}" in title
    if a == "A":  # a letter says nothing: the title says which file it stands for
        assert all(arm.source.inputs[0][0] in title for arm in versions)
    assert f"DIFFER: {a} and {b} " in text
    assert f"Torque difference: {a} − {b}" in text
    report = read_report(json_text(diff_json(d)))["comparison"]
    assert [report[side]["label"] for side in "ab"] == [a, b]
    assert [report[side]["name"] for side in "ab"] == [arm.name for arm in versions]


def test_validate_and_sweep_and_simulate(versions: tuple[SerialArm, SerialArm]) -> None:
    a, b = expected(versions)
    validation = ur5check.validate(*versions, versions[0], samples=20)
    labels = [model.arm.label for model in validation.models]
    assert labels == ["A", "B", "C"]  # the first and the third are one file
    text = render_text(validate_document(validation), width=200)
    assert "A against B:" in text
    sweep = render_text(sweep_document(ur5check.sweep(*versions, states=50)), width=200)
    assert f"Torque difference: {a} − {b}" in sweep
    hold = render_text(simulate_document(stand(*versions, [0.0] * 6, seconds=0.01)), width=200)
    assert f"Applied: holds {b}. Needed: holds {a}" in hold
