"""The report says what was measured, as text, Markdown and JSON, and is documented."""

from __future__ import annotations

import json
from dataclasses import replace

import jsonschema
import pytest

from repository import REPOSITORY
from ur5check._benchmarking.benchmark import QUESTIONS
from ur5check._benchmarking.result import Benchmark, Profile
from ur5check._cli.main import main
from ur5check._reports.benchmark_document import benchmark_document
from ur5check._reports.benchmark_json import benchmark_json
from ur5check._reports.json_values import json_text
from ur5check._reports.markdown import render_markdown
from ur5check._reports.terminal import render_text

DOCS = REPOSITORY / "docs"
SCHEMA = json.loads((DOCS / "schemas" / "report-1.schema.json").read_text(encoding="utf-8"))
PROFILE = Profile("ur5check validate", 2.0, (("the reference engines", 1.25), ("imports", 0.75)))


@pytest.fixture
def whole(found: Benchmark) -> Benchmark:
    return replace(found, profiles=(PROFILE,))


def test_json_is_as_the_schema_says(whole: Benchmark) -> None:
    report = json.loads(json_text(benchmark_json(whole, command="ur5check bench")))
    validator = jsonschema.Draft202012Validator(SCHEMA)
    validator.validate(report)
    report["chapters"][0]["comparisons"][0]["timings"][0]["seconds"] = 0.0
    with pytest.raises(jsonschema.ValidationError):
        validator.validate(report)


def test_every_timing_is_in_every_form(whole: Benchmark) -> None:
    document = benchmark_document(whole)
    text, markdown = render_text(document), render_markdown(document)
    timings = [t for c in whole.chapters for s in c.comparisons for t in s.timings]
    assert [t.name for t in timings if t.name not in text] == []
    shown = markdown.replace("\\", "")
    assert [t.name for t in timings if t.name not in shown] == []
    assert "the reference engines" in text
    assert "1.25" in text


def test_units_are_said_once_and_hold(whole: Benchmark) -> None:
    torques = whole.comparison("torques")
    assert torques is not None
    first = replace(torques.timings[0], seconds=1234e-9, spread=0.1, speed=1.0)
    chapter = replace(whole.chapters[0], comparisons=(replace(torques, timings=(first,)),))
    markdown = render_markdown(benchmark_document(replace(whole, chapters=(chapter,))))
    assert "time a state \\[ns\\]" in markdown
    assert f"| {first.name} | 1,230 | 10 | 1.00 |" in markdown


def test_the_command_measures(capsys: pytest.CaptureFixture[str]) -> None:
    words = [
        "bench",
        "paper",
        "--only",
        "start-up",
        "--states",
        "20",
        "--rounds",
        "1",
        "--threads",
        "1",
    ]
    assert main([*words, "--lengths", "2", "--format", "json", "--quiet"]) == 0
    said = capsys.readouterr()
    report = json.loads(said.out)
    assert said.err == ""
    assert report["schema"] == "ur5check.benchmark/1"
    assert [chapter["key"] for chapter in report["chapters"]] == ["start-up"]
    assert report["command"].endswith("--threads 1 --lengths 2 --only start-up")


def test_the_help_names_every_question(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "--help"]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert ", ".join(QUESTIONS) in said


def test_an_unknown_question_is_bad_input(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "paper", "--only", "speed", "--quiet"]) == 2
    assert "'speed' is no question" in capsys.readouterr().err
