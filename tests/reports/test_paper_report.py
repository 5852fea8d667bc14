"""The paper's report: strict JSON by the schema, and the verdict in the first lines of the text."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from paper.curves import replaced
from report_schema import VALIDATOR, read_report
from ur5check._paper.paper_models import PINOCCHIO
from ur5check._paper.reproduction import Reproduction
from ur5check._reports.json_report import json_text
from ur5check._reports.markdown import render_markdown
from ur5check._reports.paper_document import paper_document
from ur5check._reports.paper_json import paper_json
from ur5check._reports.terminal import render_text


@pytest.fixture(scope="module")
def report(reproduction: Reproduction) -> dict[str, Any]:
    return read_report(json_text(paper_json(reproduction, command="ur5check paper")))


def test_json_is_as_the_schema_says(report: dict[str, Any]) -> None:
    spoiled = report | {"claims": [report["claims"][0] | {"verdict": "perhaps"}]}
    assert not VALIDATOR.is_valid(spoiled)
    for key in report:
        assert not VALIDATOR.is_valid({k: v for k, v in report.items() if k != key}), key


def test_json_counts_what_it_lists(report: dict[str, Any], reproduction: Reproduction) -> None:
    assert report["schema"] == "ur5check.paper/2"
    assert len(report["claims"]) == len(reproduction.claims)
    came = [claim["verdict"] for claim in report["verdicts"]]
    assert report["verdict"]["confirmed"] == came.count("confirmed")
    assert report["verdict"]["confirmed_after_repair"] == came.count("confirmed after repair")
    assert report["verdict"]["refuted"] == came.count("refuted")
    assert (report["seed"], report["samples"]) == (0, 1000)
    assert [row["name"].rpartition("/")[2] for row in report["inputs"]][:2] == [
        "paper-listing.toml",
        "paper.toml",
    ]


def test_json_curves_can_be_drawn_again(report: dict[str, Any], reproduction: Reproduction) -> None:
    angle = np.radians(np.arange(361.0))
    assert len(report["cases"]) == 9 * 5
    for row, run in zip(report["cases"], reproduction.cases, strict=True):
        assert (row["case"], row["model"]) == (run.case.number, run.model.name)
        if row["amplitude"] is None:
            assert row["torque"] == pytest.approx(run.watched.tolist())
        else:
            sine = row["offset"] + row["amplitude"] * np.sin(angle + (row["phase"] or 0.0))
            assert run.watched == pytest.approx(sine, abs=1e-12)


def test_the_verdict_stands_first(reproduction: Reproduction) -> None:
    text = render_text(paper_document(reproduction))
    title, blank, verdict, *_ = text.splitlines()
    assert (title, blank) == ("The paper, claim by claim", "")
    assert verdict.startswith("REPRODUCED: of 28 claims of the paper, 12 are confirmed, 9 only")
    assert all(f"\n{number}     τ" in text for number in range(1, 9))


def test_what_cannot_be_believed_says_so(reproduction: Reproduction) -> None:
    runs = [
        replaced(run, run.torque + 1e-6) if run.model.name == PINOCCHIO else run
        for run in reproduction.cases
    ]
    document = paper_document(replace(reproduction, cases=tuple(runs)))
    assert document.verdict is not None
    assert not document.verdict.good
    assert "1.0e-06 N m apart" in document.verdict.text


def test_markdown_shows_every_claim_for_every_model(reproduction: Reproduction) -> None:
    short = render_markdown(paper_document(reproduction))
    long = render_markdown(paper_document(reproduction, written_out=True))
    for claim in reproduction.verdicts:
        assert f"| {claim.id} |" not in short
        rows = long.count(f"| {claim.id} |") + long.count(f"| **{claim.id}** |")
        assert rows == len(reproduction.outcomes(claim.id)) + 1  # and how it was tested


@pytest.mark.parametrize("missing", ["radius", "formula"])
def test_a_tensor_without_a_formula_is_shown_without(
    reproduction: Reproduction, missing: str
) -> None:
    first, *others = reproduction.formulas
    bare = replace(first, radius=None, length=None, formula=None)
    text = render_text(paper_document(replace(reproduction, formulas=(bare, *others))))
    (row,) = (line for line in text.splitlines() if line.startswith("1     0.016926823"))
    assert {"radius": "  –  ", "formula": "none known"}[missing] in row


def test_pictures_are_linked_with_what_there_is_to_see(reproduction: Reproduction) -> None:
    document = paper_document(reproduction, pictures={2: "my figures/case 2.svg"})
    says = "Case 2. Not as expected; as printed 74.5 % too large, of opposite sign"
    assert f"\n\n![{says}](my%20figures/case%202.svg)\n" in render_markdown(document)
    assert f"picture: my figures/case 2.svg: {says}" in render_text(document).replace("\n", " ")
    assert "picture: " not in render_text(paper_document(reproduction))
