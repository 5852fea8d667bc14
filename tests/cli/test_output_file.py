"""-o: the file is whole or not there, and never one of the inputs."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from ur5check._cli.output import emit
from ur5check._errors import UsageError
from ur5check._io.shipped_models import SHIPPED_MODELS

if TYPE_CHECKING:
    from .conftest import Command

FEW = ("--samples", 20)


def test_the_suffix_chooses_the_format(ur5check: Command, tmp_path: Path) -> None:
    for name in ("r.json", "r.md", "r.txt"):
        said = ur5check("show", "paper", "-o", tmp_path / name)
        assert (said.code, said.out) == (0, "")
    assert json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))["model"]["name"] == "paper"
    assert (tmp_path / "r.md").read_text(encoding="utf-8").startswith("# paper\n")
    assert (tmp_path / "r.txt").read_text(encoding="utf-8").startswith("paper\n")


def test_several_reports_of_one_run(ur5check: Command, tmp_path: Path) -> None:
    files = [tmp_path / "r.md", tmp_path / "r.json"]
    options = [word for file in files for word in ("-o", file)]
    said = ur5check("show", "paper", *options, "--format", "text", "--format", "json")
    assert said.code == 0
    assert files[0].read_text(encoding="utf-8").startswith("# paper\n")
    text, _, report = said.out.partition("{\n")
    assert text.startswith("paper\n")
    assert json.loads("{\n" + report) == json.loads(files[1].read_text(encoding="utf-8"))


def test_a_named_format_is_that_of_a_file_without_a_known_suffix(
    ur5check: Command, tmp_path: Path
) -> None:
    assert ur5check("show", "paper", "-o", tmp_path / "step", "--format", "json").out == ""
    json.loads((tmp_path / "step").read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    ("command", "options"),
    [
        ("show paper", "-o r.log"),
        ("show paper", "-o report"),
        ("show paper", "-o r.txt -o r.log"),
        ("show paper", "-o a.md -o ./a.md"),
        ("show paper", "-o r.sarif"),
        ("show paper", "--format sarif"),
        ("diff paper appendix", "-o r.summary.md"),
        ("engines paper", "--format junit"),
        ("validate paper", "-o r.log"),
    ],
)
def test_a_report_that_no_format_fits_is_refused(
    ur5check: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: str, options: str
) -> None:
    monkeypatch.chdir(tmp_path)
    said = ur5check(*command.split(), *options.split())
    assert (said.code, said.out, said.err.count("\n")) == (2, "", 1)
    assert list(tmp_path.iterdir()) == []


def test_models_that_differ_are_written_too(ur5check: Command, tmp_path: Path) -> None:
    said = ur5check("diff", "paper", "appendix", *FEW, "--quick", "-o", tmp_path / "d.json")
    assert (said.code, said.out) == (1, "")
    assert (tmp_path / "d.json").exists()


def test_a_failing_command_leaves_no_file(ur5check: Command, tmp_path: Path) -> None:
    assert ur5check("diff", "paper", "papr", "-o", tmp_path / "d.json").code == 2
    assert list(tmp_path.iterdir()) == []


def test_a_failing_command_leaves_an_old_file_alone(ur5check: Command, tmp_path: Path) -> None:
    old = tmp_path / "d.json"
    old.write_text("old")
    assert ur5check("diff", "paper", "papr", "-o", old).code == 2
    assert old.read_text() == "old"


def test_a_failing_write_leaves_an_old_file_alone(tmp_path: Path) -> None:
    """The draft's name is too long for the file system, so that writing it fails."""
    old = tmp_path / ("x" * 250)
    old.write_text("old")
    with pytest.raises(UsageError, match="cannot be written"):
        emit("new", str(old))
    assert old.read_text() == "old"
    assert list(tmp_path.iterdir()) == [old]


def test_the_mode_of_an_old_file_stays(ur5check: Command, tmp_path: Path) -> None:
    old = tmp_path / "r.txt"
    old.write_text("old")
    old.chmod(0o640)
    assert ur5check("show", "paper", "-o", old).code == 0
    assert old.stat().st_mode & 0o777 == 0o640
    assert list(tmp_path.iterdir()) == [old]


def test_a_link_stays_a_link(ur5check: Command, tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "target")
    assert ur5check("show", "paper", "-o", tmp_path / "link", "--format", "text").code == 0
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "target").is_file()


def test_a_device_stays_a_device(ur5check: Command) -> None:
    assert ur5check("show", "paper", "-o", os.devnull).code == 0
    assert Path(os.devnull).is_char_device()


@pytest.mark.parametrize("command", ["show", "expand"])
def test_no_input_is_overwritten(ur5check: Command, tmp_path: Path, command: str) -> None:
    part = tmp_path / "part.xacro"
    part.write_text(
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>'
        '<joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint>'
        '<link name="arm"><inertial><mass value="1"/>'
        '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>'
    )
    robot = tmp_path / "robot.xacro"
    robot.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:include filename="part.xacro"/></robot>'
    )
    os.link(part, tmp_path / "same.txt")
    before = part.read_bytes()
    as_text = ("--format", "text") if command == "show" else ()
    for output in (robot, part, tmp_path / "same.txt"):
        code, out, err = ur5check(command, robot, "-o", output, *as_text)
        assert (code, out) == (2, ""), err
        assert err.endswith("is one of the inputs; name another file\n")
    assert part.read_bytes() == before
    assert ur5check(command, robot, "-o", tmp_path / "new.txt").code == 0


def test_no_shipped_model_is_overwritten(ur5check: Command) -> None:
    included = SHIPPED_MODELS["appendix"].path().with_name("ur5.urdf.xacro")
    for model, path in (("paper", SHIPPED_MODELS["paper"].path()), ("appendix", included)):
        code, _, err = ur5check("validate", model, *FEW, "-o", path, "--format", "text")
        assert code == 2
        assert "is one of the inputs" in err


def test_what_cannot_be_written_is_said_first(ur5check: Command, tmp_path: Path) -> None:
    code, _, err = ur5check("show", "paper", "-o", tmp_path)
    assert (code, err.count("\n")) == (2, 1)
    assert "is a folder" in err
    code, _, err = ur5check("show", "paper", "-o", tmp_path / "no" / "such" / "r.txt")
    assert (code, err.count("\n")) == (2, 1)
    assert "there is no folder" in err
