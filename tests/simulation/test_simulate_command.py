"""`ur5check simulate`: the command, its report in every format, and what it refuses."""

from __future__ import annotations

import json
import re

import jsonschema
import pytest

from report_schema import VALIDATOR, read_report
from ur5check._cli.main import main

QUICK = ("--seconds", "0.05")


@pytest.fixture
def simulate(capsys):
    def run(*arguments):
        code = main(["simulate", *map(str, arguments)])
        return code, *capsys.readouterr()

    return run


def test_an_arm_that_stands_exits_with_0(simulate):
    code, out, err = simulate(*QUICK, "--engine", "dart")
    assert code == 0
    assert "STANDS: appendix stands for 0.05 s" in out
    assert "link 'ee_link': 1 kg" in out  # what DART would have made of the file
    assert "ur5check: simulating appendix" in err


def test_an_arm_that_moves_exits_with_1(simulate):
    code, out, _ = simulate(*QUICK, "--torque", "paper-listing", "--engine", "mujoco", "--quiet")
    assert code == 1
    assert "MOVES: appendix moves" in out
    assert re.search(r"joint 2 is given\s+\+65.92 N m and needs\s+−40.39 N m", out)


def test_progress_goes_to_stderr_and_can_be_silenced(simulate):
    _, _, err = simulate(*QUICK, "--engine", "mujoco")
    assert "0.03 of 0.05 s" in err
    assert simulate(*QUICK, "--engine", "mujoco", "--quiet")[2] == ""


def test_the_report_says_how_to_make_it_again(simulate):
    pose = ("0", "0.9", "-1", "1", "3.5", "-1.9")
    given = ("--torque", "paper", "--pose", *pose, "--recompute", *QUICK)
    report = json.loads(simulate(*given, "--format", "json")[1])
    again = json.loads(simulate(*report["command"].split()[2:], "--format", "json")[1])
    assert again == report
    # Numbers given one by one are case 9.
    named = json.loads(simulate("--torque", "paper", "--recompute", *QUICK, "--format", "json")[1])
    assert named["motion"] == report["motion"]


@pytest.mark.parametrize("engine", ["ur5check", "mujoco"])
def test_json_is_as_the_schema_says(simulate, engine):
    code, out, _ = simulate(*QUICK, "--torque", "paper", "--engine", engine, "--format", "json")
    report = read_report(out)
    assert report["schema"] == "ur5check.simulate/2"
    assert report["verdict"]["stands"] is (code == 0) is False
    assert report["motion"]["tool_drift"][0] == 0.0
    assert len(report["motion"]["q"]) == len(report["motion"]["t"]) <= 501
    report["torques"][0]["given"] = "much"
    with pytest.raises(jsonschema.ValidationError):
        VALIDATOR.validate(report)


def test_markdown_has_the_drift_table(simulate):
    _, out, _ = simulate(*QUICK, "--format", "markdown")
    assert out.startswith("# appendix under the torques of appendix\n")
    assert "| t [s] | tool [mm] |" in out.replace("\\", "")


@pytest.mark.parametrize("suffix", [".svg", ".png"])
def test_the_picture_is_drawn(simulate, tmp_path, suffix):
    file = tmp_path / f"drift{suffix}"
    code, _, _ = simulate(*QUICK, "--torque", "paper", "--figure", file)
    assert code == 1
    begin = {".png": b"\x89PNG", ".svg": b"<?xml"}[suffix]
    assert file.read_bytes().startswith(begin)
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--pose", "case8"), "--pose case8: give case9, or one angle a joint"),
        (("--pose", "0", "1"), "q has shape (2,)"),
        (("--pose", "0", "nan", "0", "0", "0", "0"), "every entry must be finite"),
        (("--pose", "0", "0", "4", "0", "0", "0"), "joint 'elbow_joint' of 'appendix' starts at 4"),
        (("--engine", "gazebo"), "'gazebo' moves no arm in time; choose from ur5check, mujoco"),
        (("--seconds", "-1"), "--seconds must be a positive number"),
        (("--hold", "--recompute"), "not allowed with"),
        (("--integrator", "rk4"), "leave it out"),
        (("--plant", "apendix"), "did you mean 'appendix'"),
        (("--figure", "drift.gif"), "is drawn as .svg or .png"),
        (("--figure", "no/such/drift.svg"), "there is no folder"),
        (("--figure", "a.svg", "--format", "text", "-o", "a.svg"), "name another file"),
    ],
)
def test_one_line_says_what_is_wrong(simulate, arguments, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code, out, err = simulate(*arguments, "--quiet")
    assert (code, out) == (2, "")
    assert said in err
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []
