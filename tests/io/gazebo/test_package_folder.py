"""A folder is there as a whole, or not at all; nothing that was there is touched."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from ur5check._cli.main import main
from ur5check._errors import UsageError
from ur5check._io.gazebo.package_folder import write_folder

FILES = {"a/b.txt": b"b", "c.py": b"c"}


def test_a_new_and_an_empty_folder_are_filled(tmp_path):
    (tmp_path / "empty").mkdir()
    for name in ("new", "empty"):
        write_folder(str(tmp_path / name), FILES, {"c.py"})
        assert (tmp_path / name / "a/b.txt").read_bytes() == b"b"
        assert os.access(tmp_path / name / "c.py", os.X_OK)
        assert not os.access(tmp_path / name / "a/b.txt", os.X_OK)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["empty", "new"]


@pytest.mark.parametrize(
    ("name", "problem"),
    [("full", "is not empty"), ("file", "is a file"), ("no/where", "there is no folder")],
)
def test_what_is_there_is_left_alone(tmp_path, name, problem):
    (tmp_path / "full").mkdir()
    (tmp_path / "full/mine").write_text("mine")
    (tmp_path / "file").write_text("mine")
    with pytest.raises(UsageError, match=problem):
        write_folder(str(tmp_path / name), FILES)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", "full"]
    assert [p.read_text() for p in (tmp_path / "full").iterdir()] == ["mine"]


def test_a_write_that_fails_half_way_leaves_nothing(tmp_path):
    with pytest.raises(UsageError, match="cannot be written"):
        write_folder(str(tmp_path / "new"), {"a": b"a", "a/b": b"a file is no folder"})
    assert list(tmp_path.iterdir()) == []


def said(capsys, *arguments: str) -> tuple[int, str, str]:
    code = main(["export", *arguments])
    out, err = capsys.readouterr()
    return code, out, err


def test_the_command_says_where_and_what_torque(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code, out, _ = said(capsys, "gazebo", "out", "--ros", "2", "--quiet")
    assert code == 0
    assert "out/README.md" in out and "shoulder_lift_joint     0.9000   -40.3916" in out
    assert sorted(p.name for p in Path("out").iterdir()) == ["README.md", "ros2"]
    again = next(line for line in Path("out/ros2/appendix_gazebo/config/torque.yaml").read_text()
                 .splitlines() if "Command:" in line)  # fmt: skip
    assert again.endswith("--model appendix --ros 2 --pose 0.0 0.9 -1.0 1.0 3.5 -1.9")


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (("gazebo", "out", "--model", "nobody"), "nobody"),
        (("gazebo", "out", "--pose", "1", "2"), "2 angles for the 6 joints"),
        (
            ("gazebo", "out", "--model", "one.urdf"),
            "one.urdf has 1 joints, the paper's case 9 has 6",
        ),
        (("gazebo", "full"), "full: is not empty"),
        (("isaac", "out"), "invalid choice"),
    ],
)
def test_bad_usage_is_one_line_and_no_folder(tmp_path, capsys, monkeypatch, arguments, problem):
    monkeypatch.chdir(tmp_path)
    Path("full").mkdir()
    Path("full/mine").write_text("mine")
    Path("one.urdf").write_text(
        '<robot name="one"><link name="b"/><joint name="j" type="continuous"><parent link="b"/>'
        '<child link="l"/></joint><link name="l"><inertial><mass value="1"/><inertia ixx="1" '
        'ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>'
    )
    code, out, err = said(capsys, *arguments, "--quiet")
    assert (code, out) == (2, "")
    assert problem in err and err.count("\n") == 1
    assert sorted(p.name for p in tmp_path.iterdir()) == ["full", "one.urdf"]
