"""One door: names, paths, models and arms go in; an arm or one clear error comes out."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pinocchio as pin
import pytest

from ur5check._errors import ModelError, UsageError
from ur5check._io.loading import load
from ur5check._io.shipped_models import SHIPPED_MODELS
from urdf_examples import GOOD, robot_path

XACRO = """\
<robot name="{name}" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="m" default="1.5"/>
  <link name="base"/>
  <joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint>
  <link name="arm"><inertial><mass value="$(arg m)"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
</robot>
"""


@pytest.mark.parametrize("name", SHIPPED_MODELS)
def test_every_shipped_model_loads_by_name(name: str) -> None:
    arm = load(name)
    assert (arm.name, arm.n) == (name, 6)
    assert all(not Path(file).is_absolute() for file, _ in arm.source.inputs)
    assert all(re.fullmatch("[0-9a-f]{64}", digest) for _, digest in arm.source.inputs)


def test_a_shipped_model_may_be_cut_elsewhere() -> None:
    assert load("erd-ur5", base="base", tip="ee_link").source.tip == "ee_link"


def test_files_are_read_by_their_suffix(tmp_path: Path) -> None:
    urdf = tmp_path / "two.URDF"
    urdf.write_text(GOOD)
    assert load(urdf).source.kind == "urdf"
    assert load(str(urdf)).name == "two"
    xacro = tmp_path / "one.urdf.xacro"
    xacro.write_text(XACRO.replace("{name}", "one"))
    assert load(xacro).source.kind == "xacro"
    assert load(xacro).links[0].inertia.mass == 1.5
    assert load(xacro, arguments={"m": "2.5"}).links[0].inertia.mass == 2.5
    table = SHIPPED_MODELS["paper"].path()
    assert load(table).source.kind == "dh"


def test_models_and_arms_are_taken_too() -> None:
    arm = load(pin.buildModelFromXML(robot_path("ur5_robot.urdf").read_text()), tip="tool0")
    assert (arm.source.kind, arm.source.tip) == ("pinocchio", "tool0")
    assert load(arm) is arm


@pytest.mark.parametrize(
    ("x", "words"),
    [
        ("papr", "did you mean 'paper'"),
        ("", "is a folder"),
        ("paper.step", "'paper.step'.*|.urdf, .xacro, .toml"),
        ("paperr.toml", "there is no such file.*did you mean 'paper'"),
        ("a\0b.urdf", "cannot be read"),
        (7, "a int is no arm"),
        (None, "a NoneType is no arm"),
    ],
)
def test_what_cannot_be_found_is_said_with_a_hint(x: object, words: str) -> None:
    with pytest.raises((UsageError, ModelError), match=words):
        load(x)  # type: ignore[arg-type]


def test_folders_are_no_arms(tmp_path: Path) -> None:
    with pytest.raises(ModelError, match="is a folder"):
        load(tmp_path)
    (tmp_path / "folder.urdf").mkdir()
    with pytest.raises(ModelError, match="is no file"):
        load(tmp_path / "folder.urdf")


@pytest.mark.parametrize("option", ["base", "tip", "arguments"])
def test_options_without_a_meaning_are_refused(option: str, tmp_path: Path) -> None:
    value: object = {"m": "1"} if option == "arguments" else "base"
    with pytest.raises(UsageError, match=f"{option}= has no meaning for a DH table"):
        load("paper", **{option: value})  # type: ignore[arg-type]
    with pytest.raises(UsageError, match=f"{option}= has no meaning for an arm"):
        load(load("paper"), **{option: value})  # type: ignore[arg-type]


def test_arguments_are_for_xacro_only(tmp_path: Path) -> None:
    (tmp_path / "two.urdf").write_text(GOOD)
    for x in (tmp_path / "two.urdf", pin.buildModelFromXML(GOOD)):
        with pytest.raises(UsageError, match="arguments= has no meaning"):
            load(x, arguments={"m": "1"})


def test_errors_of_a_file_name_it_as_it_was_given(tmp_path: Path) -> None:
    bad = tmp_path / "bad.urdf"
    bad.write_text(GOOD.replace('value="2.0"', 'value="-2.0"'))
    with pytest.raises(ModelError) as caught:
        load(bad)
    assert (caught.value.file, caught.value.line) == (str(bad), 14)


def test_a_table_is_read_without_loading_an_engine() -> None:
    script = (
        "import sys; from ur5check._io.loading import load; load('paper');"
        "print([m for m in ('pinocchio', 'yourdfpy', 'xacro') if m in sys.modules])"
    )
    answer = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert (answer.stdout.strip(), answer.stderr) == ("[]", "")
