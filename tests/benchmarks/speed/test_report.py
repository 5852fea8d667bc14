"""The report holds every measured value, with its unit; the script writes it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import bench_speed
import pytest
from speed.measure import QUESTIONS
from speed.report import speed_document
from speed.result import Benchmark, Profile

from ur5check._reports.markdown import render_markdown

PROFILE = Profile("ur5check validate", 2.0, (("reference engines", 1.25), ("imports", 0.75)))


@pytest.fixture
def whole(found: Benchmark) -> Benchmark:
    return replace(found, profiles=(PROFILE,))


def test_every_timing_is_in_the_report(whole: Benchmark) -> None:
    shown = render_markdown(speed_document(whole)).replace("\\", "")
    timings = [t for c in whole.chapters for s in c.comparisons for t in s.timings]
    assert [t.name for t in timings if t.name not in shown] == []
    assert "| reference engines | 1.25 |" in shown


def test_a_time_is_shown_in_the_unit_of_its_column(whole: Benchmark) -> None:
    torques = whole.comparison("torques")
    assert torques is not None
    first = replace(torques.timings[0], seconds=1234e-9, spread=0.1, speed=1.0)
    chapter = replace(whole.chapters[0], comparisons=(replace(torques, timings=(first,)),))
    markdown = render_markdown(speed_document(replace(whole, chapters=(chapter,))))
    assert "time per state \\[ns\\]" in markdown
    assert f"| {first.name} | 1,230 | 10 | 1.00 |" in markdown


def test_the_script_writes_the_selected_measurements(tmp_path: Path) -> None:
    file = tmp_path / "speed.md"
    words = ["paper", "--only", "start-up", "--rounds", "1", "--states", "10", "-o", str(file)]
    assert bench_speed.main(words) == 0
    text = file.read_text(encoding="utf-8")
    assert "## Start-up" in text
    assert "## Inverse dynamics" not in text
    assert "python benchmarks/bench_speed.py paper --only start-up" in text


def test_the_help_names_every_measurement(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="0"):
        bench_speed.main(["--help"])
    assert ", ".join(QUESTIONS) in " ".join(capsys.readouterr().out.split())


def test_an_unknown_measurement_is_bad_usage(capsys: pytest.CaptureFixture[str]) -> None:
    assert bench_speed.main(["paper", "--only", "speed"]) == 2
    assert "'speed' is not measured" in capsys.readouterr().err
