"""The mutation benchmark runs, says what it measured, and its quick set comes out right."""

from __future__ import annotations

import importlib
import json
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from repository import REPOSITORY

ROOT = REPOSITORY


@pytest.fixture(scope="module")
def bench() -> ModuleType:
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(ROOT / "benchmarks"))
        return importlib.import_module("bench_diagnosis")


@pytest.fixture(scope="module")
def quick(bench: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    file = tmp_path_factory.mktemp("quick") / "figures.json"
    assert bench.main(["--quick", "--json", str(file)]) == 0
    report: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
    return report


def test_report_has_its_structure(bench: ModuleType, quick: dict[str, Any]) -> None:
    assert quick["schema"] == "ur5check._comparison.diagnosis-benchmark/1"
    assert set(quick) == {"schema", "seed", "arms", "noise", "states", "cases", "clean"}
    assert {case["mistake"] for case in quick["cases"]} == set(bench.MISTAKES)
    assert {case["noise"] for case in quick["cases"]} == {0.0, 0.01}
    table = bench.tables(quick)
    assert all(f"| {mistake} |" in table for mistake in bench.MISTAKES)


def test_mistakes_are_detected(quick: dict[str, Any]) -> None:
    quiet = [case for case in quick["cases"] if not case["noise"]]
    found = [case["detected"] for case in quiet]
    assert np.mean(found) >= 0.95, [case["answer"] for case in quiet if not case["detected"]]


def test_no_false_alarm(quick: dict[str, Any]) -> None:
    assert [pair for pair in quick["clean"] if pair["findings"]] == []


def test_plantings_change_what_they_say_and_nothing_else(bench: ModuleType) -> None:
    arm = bench.arm_called("panda", 0)
    for mistake in bench.MISTAKES:
        for way in bench.plantings(mistake, arm, 3):
            changed = {
                i
                for i, (one, other) in enumerate(zip(arm.links, way.arm.links, strict=True), 1)
                if not np.allclose(
                    one.inertia.parameters(), other.inertia.parameters(), rtol=1e-9, atol=1e-12
                )
                and mistake in bench.INERTIAL
            }
            assert changed <= set(way.links), (mistake, way.how)
            assert way.arm.n == arm.n


def test_page_is_that_of_the_benchmark(bench: ModuleType) -> None:
    page = (ROOT / "docs" / "diagnosis-benchmark.md").read_text(encoding="utf-8")
    assert all(f"| {mistake} |" in page for mistake in bench.MISTAKES)
    assert "False alarms in 1,000 pairs" in page
