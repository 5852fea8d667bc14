"""Every command, every format: what it prints, and its exit code."""

from __future__ import annotations

import hashlib
import json
import re
import shlex
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pinocchio as pin
import pytest

from ur5check._cli.options import MODELS
from ur5check._io.shipped_models import SHIPPED_MODELS

if TYPE_CHECKING:
    from .conftest import Command

FEW = ("--samples", 200)

TWO_ARMS = """\
<robot name="two">
  <link name="body"/>
  {arms}
</robot>
"""
ARM = """\
  <joint name="{side}_joint" type="continuous"><parent link="body"/><child link="{side}_hand"/>
    <origin xyz="0 {y} 0"/><axis xyz="0 1 0"/></joint>
  <link name="{side}_hand"><inertial><origin xyz="0.1 0 0"/><mass value="1.5"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
"""


@pytest.fixture
def two_arms(tmp_path: Path) -> Path:
    path = tmp_path / "two.urdf"
    arms = "".join(ARM.format(side=side, y=y) for side, y in (("left", 1), ("right", -1)))
    path.write_text(TWO_ARMS.format(arms=arms))
    return path


def test_validate_is_the_paper_against_its_appendix(ur5check: Command) -> None:
    said = ur5check("validate", *FEW)
    assert said.code == 0
    lines = said.out.splitlines()
    assert [line.split()[0] for line in lines if line[:4].isupper()] == ["PASS", "PASS", "ACCEPTED"]
    assert len(lines) <= 24
    whole = ur5check("validate", *FEW, "--full")
    assert "command: ur5check validate --samples 200 --seed 0 --fail-level error" in whole.out
    assert all(line.startswith("ur5check: ") for line in said.err.splitlines())


def test_the_command_in_a_verdict_gives_the_same_verdict(ur5check: Command, two_arms: Path) -> None:
    given = (
        "--base", "body", "--tip", "left_hand", "--hold", "right_joint=0.5", "--payload", 2.0,
        "--expect-mass", 9.0, "--no-meshes", "--fail-level", "warning", "--format", "json",
    )  # fmt: skip
    said = ur5check("validate", two_arms, "--samples", 20, *given)
    report = json.loads(said.out)
    assert said.code == 1
    assert "ROB101" in {finding["rule"] for finding in report["files"][0]["findings"]}
    _, *words = shlex.split(report["command"])
    again = ur5check(*words, "--format", "json")
    assert (again.code, json.loads(again.out)) == (1, report)


def test_a_verdict_takes_no_gravity_that_it_would_not_use(ur5check: Command) -> None:
    assert ur5check("validate", "paper", "--gravity", 0, 0, 0).code == 2


def test_what_describes_no_robot_is_in_the_report_with_its_hash(
    ur5check: Command, tmp_path: Path
) -> None:
    file, config = tmp_path / "arm.urdf", tmp_path / "ur5check.toml"
    file.write_text("<robot")
    config.write_text('fail-level = "warning"\n')
    said = ur5check("validate", file, "--format", "json")
    report = json.loads(said.out)
    assert (said.code, report["passed"]) == (1, False)
    assert {one["name"]: one["sha256"] for one in report["inputs"]} == {
        str(path): hashlib.sha256(path.read_bytes()).hexdigest() for path in (file, config)
    }
    assert report["summary"][0].startswith("0 of 1")


def test_quiet_is_quiet(ur5check: Command) -> None:
    said = ur5check("validate", "paper", *FEW, "--quiet")
    assert (said.code, said.err) == (0, "")


def test_validate_exits_with_1_when_a_law_fails(ur5check: Command, tmp_path: Path) -> None:
    """A grain on a mountain: M is positive definite, but no double can tell."""
    path = tmp_path / "grain.urdf"
    links = "".join(
        f'<joint name="j{k}" type="continuous"><parent link="l{k}"/><child link="l{k + 1}"/>'
        f'<axis xyz="0 {k} 1"/></joint><link name="l{k + 1}"><inertial><mass value="{m}"/>'
        f'<inertia ixx="{m}" ixy="0" ixz="0" iyy="{m}" iyz="0" izz="{m}"/></inertial></link>'
        for k, m in enumerate(("1e9", "1e-12"))
    )
    path.write_text(f'<robot name="grain"><link name="l0"/>{links}</robot>')
    said = ur5check("validate", path, *FEW, "--format", "json")
    assert said.code == 1, said.err
    failed = {c["id"] for c in json.loads(said.out)["checks"] if c["status"] == "fail"}
    assert "mass-positive" in failed
    said = ur5check("validate", path, *FEW)
    assert said.code == 1
    assert "WRONG: mass-positive" in " ".join(said.out.split())


def test_diff_exits_as_diff_does(ur5check: Command) -> None:
    assert ur5check("diff", "paper", "paper", *FEW, "--quick").code == 0
    said = ur5check("diff", "paper-listing", "paper", *FEW, "--quick")
    assert said.code == 1
    assert said.out.startswith("DIFFER  paper-listing and paper need different torques")
    assert "── " not in said.out


@pytest.mark.parametrize(
    ("arguments", "schema"),
    [
        (("validate", "paper", *FEW), "validate"),
        (("diff", "erd-ur5", "appendix", *FEW, "--quick"), "diff"),
        (("show", "appendix"), "show"),
    ],
)
def test_formats(ur5check: Command, arguments: tuple[object, ...], schema: str) -> None:
    report = json.loads(ur5check(*arguments, "--format", "json").out)
    assert report["schema"] == f"ur5check.{schema}/2"
    assert ur5check(*arguments, "--format", "markdown").out.startswith("# ")
    full = ("--full",) if arguments[0] in ("validate", "diff") else ()
    assert "── " in ur5check(*arguments, "--format", "text", *full).out


def test_a_report_can_be_made_again(ur5check: Command) -> None:
    given = (
        "diff",
        "paper",
        "appendix",
        "--quick",
        "--samples",
        50,
        "--seed",
        3,
        "--gravity",
        0,
        0,
        -1.62,
    )
    first = ur5check(*given, "--arg", "limited:=true", "--format", "json").out
    name, *arguments = json.loads(first)["command"].split()
    assert name == "ur5check"
    assert ur5check(*arguments, "--format", "json").out == first


def test_gravity_is_used(ur5check: Command) -> None:
    said = ur5check(
        "diff", "paper", "appendix", *FEW, "--quick", "--gravity", 0, 0, 0, "--format", "json"
    )
    weightless = json.loads(said.out)["comparison"]["torques"]
    heavy = json.loads(
        ur5check("diff", "paper", "appendix", *FEW, "--quick", "--format", "json").out
    )
    assert weightless[2]["rms"] < heavy["comparison"]["torques"][2]["rms"]


def test_base_and_tip_choose_among_branches(ur5check: Command, two_arms: Path) -> None:
    assert ur5check("show", two_arms).code == 2
    said = ur5check("show", two_arms, "--tip", "left_hand", "--format", "json")
    assert json.loads(said.out)["joints"][0]["name"] == "left_joint"
    said = ur5check(
        "diff", two_arms, two_arms, *FEW, "--quick", "--tip-a", "left_hand", "--tip-b", "right_hand"
    )
    assert said.code == 0, said.err
    assert ur5check("validate", two_arms, *FEW, "--tip", "right_hand").code == 0


def test_expand_gives_what_pinocchio_reads(ur5check: Command) -> None:
    said = ur5check("expand", "appendix", "--arg", "prefix:=left_")
    assert (said.code, said.err) == (0, "")
    model = pin.buildModelFromXML(said.out)
    assert (model.nq, model.names[1]) == (6, "left_shoulder_pan_joint")


def test_expand_prints_a_urdf_as_it_is(ur5check: Command, two_arms: Path) -> None:
    said = ur5check("expand", two_arms)
    assert (said.code, said.out) == (0, two_arms.read_text())
    assert "is a URDF: there is nothing to expand" in said.err


def test_packages_are_found(ur5check: Command, tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    part = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="from_part"/></robot>'
    (tmp_path / "parts" / "part.xacro").write_text(part)
    robot = tmp_path / "robot" / "robot.xacro"
    robot.parent.mkdir()
    robot.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:include filename="$(find my_parts)/part.xacro"/></robot>'
    )
    said = ur5check("expand", robot, "--package", f"my_parts={tmp_path / 'parts'}")
    assert '<link name="from_part"/>' in said.out
    assert ur5check("expand", robot).code == 2


def test_show_shows_the_arm(ur5check: Command) -> None:
    shown = json.loads(ur5check("show", "paper", "--format", "json").out)
    assert np.allclose(shown["gravity"], [0, 0, -9.81])
    assert ur5check("show", "paper").out.startswith("paper\n")


def test_the_help_names_every_shipped_model() -> None:
    assert all(re.search(rf"\b{name}\b", MODELS) for name in SHIPPED_MODELS)
