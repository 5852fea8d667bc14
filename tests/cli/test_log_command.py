"""`ur5check log`: exit codes, the first screen, reports in every form."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from logs.recorded import heavier, motion_of, small_model, write
from report_schema import read_report
from ur5check import load
from ur5check._io.urdf.urdf_writer import urdf_of

if TYPE_CHECKING:
    from .conftest import Command


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """The right model, a wrong one, a recording, and a column that a controller computed."""
    folder = tmp_path_factory.mktemp("log")
    right = small_model(folder)
    arm = load(right)
    wrong = folder / "wrong.urdf"
    wrong.write_text(urdf_of(heavier(arm, 1, 1.4)), encoding="utf-8")
    computed = motion_of(arm, drives=np.zeros((3, 4)), noise=1e-5)
    return {
        "right": right,
        "wrong": wrong,
        "run": write(motion_of(arm), folder / "run.csv"),
        "computed": write(computed, folder / "computed.csv"),
    }


@pytest.mark.parametrize(
    ("model", "run", "word", "code"),
    [
        ("right", "run", "PASS", 0),
        ("wrong", "run", "FAIL", 1),
        ("right", "computed", "UNUSABLE", 1),
    ],
)
def test_the_first_screen_is_the_answer(
    ur5check: Command, files: dict[str, Path], model: str, run: str, word: str, code: int
) -> None:
    said = ur5check("log", files[run], "--model", files[model], "--quiet")
    assert said.code == code
    assert said.err == ""
    lines = said.out.splitlines()
    assert lines[0].startswith(word)
    assert len(lines) <= 24
    assert max(map(len, lines)) <= 80


def test_json_holds_to_the_schema(ur5check: Command, files: dict[str, Path]) -> None:
    said = ur5check("log", files["run"], "--model", files["wrong"], "--format", "json", "--quiet")
    report = read_report(said.out)
    assert report["schema"] == "ur5check.log/1"
    assert report["verdict"]["word"] == "FAIL"
    named = [cause for cause in report["causes"] if cause["named"]]
    assert (named[0]["id"], named[0]["joint"]) == ("link-mass", 2)
    assert [finding["rule"] for finding in report["findings"]] == ["LOG111"]
    assert json.loads(said.out)["recording"]["rows"] == 2000


def test_the_report_is_written_whole(
    ur5check: Command, files: dict[str, Path], tmp_path: Path
) -> None:
    for name in ("report.md", "report.json", "report.txt"):
        said = ur5check("log", files["run"], "--model", files["right"], "-o", tmp_path / name)
        assert (said.code, said.out) == (0, "")
        assert "friction" in (tmp_path / name).read_text(encoding="utf-8")
    full = ur5check("log", files["run"], "--model", files["right"], "--full", "--quiet")
    assert full.out.count("\n") > 24


@pytest.mark.parametrize(
    "options",
    [
        ("--cutoff", "0"),
        ("--cutoff", "80"),
        ("--columns", "t,q"),
        ("--gains", "1,a"),
        ("--gains", "1,2"),
        ("--recording-config", "none.toml"),
    ],
)
def test_wrong_usage_is_one_line_and_code_2(
    ur5check: Command, files: dict[str, Path], options: tuple[str, str]
) -> None:
    said = ur5check("log", files["run"], "--model", files["right"], "--quiet", *options)
    assert (said.code, said.out) == (2, "")
    assert said.err.count("\n") == 1


def test_options_of_a_file_and_of_the_command(
    ur5check: Command, files: dict[str, Path], tmp_path: Path
) -> None:
    table = np.loadtxt(files["run"], delimiter=",")
    table[:, 1:7] = np.degrees(table[:, 1:7])
    table[:, 7:] /= 2.5
    run, config = tmp_path / "run.csv", tmp_path / "run.toml"
    np.savetxt(run, table, delimiter=",", fmt="%.9g")
    config.write_text("degrees = true\ngains = [2.5]\n")
    for options in (("--degrees", "--gains", "2.5"), ("--recording-config", config)):
        said = ur5check("log", run, "--model", files["right"], "--quiet", *options)
        assert said.code == 0
    said = ur5check("log", run, "--model", files["right"], "--quiet", "--degrees")
    assert said.code == 1
    assert "0.40" in said.out


def test_the_corrected_model_is_written(
    ur5check: Command, files: dict[str, Path], tmp_path: Path
) -> None:
    file = tmp_path / "corrected.urdf"
    said = ur5check("log", files["run"], "--model", files["wrong"], "--repair", file)
    assert said.code == 1
    assert "±" in said.err
    assert ur5check("log", files["run"], "--model", file, "--quiet").code == 0


@pytest.mark.parametrize("run", ["run", "computed"])
def test_nothing_is_written_where_nothing_is_to_be_repaired(
    ur5check: Command, files: dict[str, Path], tmp_path: Path, run: str
) -> None:
    file = tmp_path / "corrected.urdf"
    ur5check("log", files[run], "--model", files["right"], "--repair", file)
    assert not file.exists()
    said = ur5check("log", files["run"], "--model", files["wrong"], "--repair", tmp_path / "x.txt")
    assert said.code == 2


def test_other_recordings_and_models_in_one_report(
    ur5check: Command, files: dict[str, Path]
) -> None:
    run = files["run"]
    command = ("log", run, "--model", files["right"], "--model", files["wrong"], "--quiet")
    said = ur5check(*command, "--unloaded", run, "--validate", run, "--format", "json")
    report = read_report(said.out)
    assert report["rivals"][0]["clear"]
    assert abs(report["load"][0]["value"]) < 0.01
    assert report["validation"]["file"] == str(run)
    said = ur5check(*command, "--unloaded", run, "--validate", run)
    assert len(said.out.splitlines()) <= 24
