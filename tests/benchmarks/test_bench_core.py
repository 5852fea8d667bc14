"""The benchmark runs and says what it measured; how fast is nobody's test."""

from __future__ import annotations

import json
import runpy
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
BENCH = ROOT / "benchmarks" / "bench_core.py"
NAMES = [
    "Python loop over pin.rnea",
    "pin.rneaInParallel, 1 thread",
    "pin.rneaInParallel, 2 threads",
    "ur5check.rnea",
    "Python loop over pin.crba",
    "ur5check.mass_matrix",
    "Python loop over pin.computeCoriolisMatrix",
    "ur5check.coriolis_matrix",
    "Python loop over pin.computeJointTorqueRegressor",
    "ur5check.torque_regressor",
    "import of its dependencies",
    "ur5check validate",
    "python -c pass",
    "import ur5check",
    "ur5check --help",
]


def test_report_has_its_structure(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "figures.json"
    main = runpy.run_path(str(BENCH))["main"]
    assert main(["--states", "3", "--repeats", "1", "--starts", "1", "--json", str(file)]) == 0
    report = json.loads(file.read_text(encoding="utf-8"))
    assert report["schema"] == "ur5check.benchmark/1"
    assert set(report) == {
        "schema", "machine", "versions", "states", "repeats", "starts", "rows",
    }  # fmt: skip
    assert [row["name"] for row in report["rows"]] == NAMES
    assert all(row["seconds"] > 0.0 and row["ratio"] > 0.0 for row in report["rows"])
    printed = capsys.readouterr().out
    assert all(f"| {name} |" in printed for name in NAMES)


def test_page_holds_the_same_rows() -> None:
    page = (ROOT / "docs" / "performance.md").read_text(encoding="utf-8")
    rows = [line.split(" | ") for line in page.splitlines() if line.count(" | ") == 3]
    assert [cells[1] for cells in rows] == NAMES
