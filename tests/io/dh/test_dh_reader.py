"""A DH file gives exactly the table it holds, and each fault in it one clear error."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ur5check
from kinematics_comparison import link_poses
from ur5check._errors import ModelError
from ur5check._io.dh.dh_reader import read_dh, read_dh_robot
from ur5check._io.dh.dh_writer import dh_toml_of
from ur5check._io.formats import FORMATS
from ur5check._robot import Limits, SerialArm, Transform
from ur5check._rules.finding_log import FindingLog

GOOD = """\
schema = "ur5check.dh/1"
name = "two"
title = "an arm of two joints"
convention = "standard"
gravity = [0.0, 0, -9.806]

[[joint]]
joint = "shoulder"
link = "upper"
d = 0.1
a = 0
alpha = "pi/2"
offset = "-pi/2"
mass = 2.5
com = [0.0, -0.02, 0.001]
inertia = { ixx = 0.02, iyy = 0.03, izz = 0.04, ixy = 0.001 }
limits = { lower = -1.5, upper = 2, velocity = 3.0, effort = 150 }
source = { d = "Table 1" }

[[joint]]
joint = "elbow"
link = "fore"
kind = "prismatic"
d = 0.0
a = -0.4
alpha = 0.3
mass = 1.0
com = [0, 0, 0]

[joint.inertia]
ixx = 0.01
iyy = 0.01
izz = 0.01
"""


def read(text: str) -> SerialArm:
    return read_dh(text.encode(), file="two.toml")


def changed(old: str, new: str) -> SerialArm:
    assert GOOD.count(old) == 1, old
    return read(GOOD.replace(old, new))


def test_a_good_file_is_read_as_written() -> None:
    arm = read(GOOD)
    assert (arm.name, arm.joint_names, arm.n) == ("two", ("shoulder", "elbow"), 2)
    assert [link.name for link in arm.links] == ["upper", "fore"]
    assert [joint.kind for joint in arm.joints] == ["revolute", "prismatic"]
    assert arm.joints[0].limits == Limits(-1.5, 2.0, 3.0, 150.0)
    assert arm.joints[1].limits == Limits()
    assert arm.gravity.tolist() == [0.0, 0.0, -9.806]
    assert arm.links[0].inertia.mass == 2.5
    assert arm.links[0].inertia.com.tolist() == [0.0, -0.02, 0.001]
    assert arm.links[0].inertia.tensor[0].tolist() == [0.02, 0.001, 0.0]
    assert (arm.source.kind, arm.source.tip) == ("dh", "fore")
    assert arm.source.inputs[0][0] == "two.toml"
    first = (
        Transform.rotation((0, 0, 1), 0.7 - math.pi / 2)
        @ Transform.translation((0, 0, 0.1))
        @ Transform.rotation((1, 0, 0), math.pi / 2)
    )
    poses = link_poses(arm, np.array([0.7, 0.2]))
    np.testing.assert_allclose(poses[0].matrix(), first.matrix(), atol=1e-15)


def test_gravity_and_title_may_be_left_out() -> None:
    assert changed("gravity = [0.0, 0, -9.806]\n", "").gravity.tolist() == [0.0, 0.0, -9.81]
    assert changed('title = "an arm of two joints"\n', "").n == 2


ANGLES = [
    ('"pi"', math.pi), ('"-pi"', -math.pi), ('"pi/2"', math.pi / 2), ('"+pi/4"', math.pi / 4),
    ('"2*pi/3"', 2 * math.pi / 3), ('"-3 * pi / 4"', -3 * math.pi / 4), ('"2*pi"', 2 * math.pi),
    ('"0.5*pi"', math.pi / 2), ("1.5707", 1.5707), ("-1", -1.0), ("6.283185307179586", math.tau),
]  # fmt: skip


@pytest.mark.parametrize(("text", "angle"), ANGLES)
def test_angles_are_numbers_or_fractions_of_pi(text: str, angle: float) -> None:
    turned = changed("alpha = 0.3", f"alpha = {text}").links[1].link_tip_frame.R
    assert turned.tolist() == Transform.rotation((1, 0, 0), angle).R.tolist()


def test_r_stands_in_place_of_d_and_a() -> None:
    link_tip_frame = changed("a = -0.4\n", "a = -0.4\nr = [0.4, 0, 0]\n").links[1].link_tip_frame
    np.testing.assert_allclose(link_tip_frame.p, [0.4, 0.0, 0.0])


def test_the_modified_convention_is_read() -> None:
    arm = changed('"standard"', '"modified"')
    np.testing.assert_allclose(arm.base.R, Transform.rotation((1, 0, 0), math.pi / 2).R)


SHORT = 'schema = "ur5check.dh/1"\nname = "x"\nconvention = "standard"\n'
TENSOR = "{ ixx = 0.02, iyy = 0.03, izz = 0.04, ixy = 0.001 }"
LIMITS = "limits = { lower = -1.5, upper = 2, velocity = 3.0, effort = 150 }"

# id, what is replaced, by what, line, element, words
FAULTS = [
    ("not toml", "d = 0.1", "d = = 0.1", 10, None, ["not TOML"]),
    ("twin key", "d = 0.1", "d = 0.1\nd = 0.1", 11, None, ["not TOML"]),
    ("schema", "dh/1", "dh/9", 1, "schema", ["unknown", "ur5check.dh/1"]),
    ("no schema", 'schema = "ur5check.dh/1"', "", None, "schema", ["missing"]),
    ("no name", 'name = "two"', "", None, "name", ["missing"]),
    ("name", 'name = "two"', "name = 2", 2, "name", ["not a text"]),
    ("empty name", 'name = "two"', 'name = " "', 2, "name", ["not a text"]),
    ("title", 'title = "an arm of two joints"', "title = 3", 3, "title", ["not a text"]),
    ("top key", "title = ", "titel = ", 3, "titel", ["did you mean 'title'?"]),
    ("convention", '"standard"', '"standrd"', 4, "convention", ["did you mean 'standard'?"]),
    ("gravity of two", "[0.0, 0, -9.806]", "[0.0, -9.806]", 5, "gravity", ["not 2"]),
    ("gravity number", "[0.0, 0, -9.806]", "-9.806", 5, "gravity", ["not a list of three"]),
    ("row key", "offset = ", "offest = ", 13, "joint 1 (shoulder) offest", ["'offset'?"]),
    ("no column", "mass = 2.5\n", "", 7, "joint 1 (shoulder) mass", ["is missing"]),
    ("no joint name", 'joint = "elbow"\n', "", 20, "joint 2 joint", ["is missing"]),
    ("kind", '"prismatic"', '"linear"', 23, "joint 2 (elbow) kind", ["one of: prismatic"]),
    ("text for number", "d = 0.1", 'd = "0.1"', 10, "joint 1 (shoulder) d", ["not a number"]),
    ("bool", "d = 0.1", "d = true", 10, "joint 1 (shoulder) d", ["not a number", "True"]),
    ("nan", "d = 0.1", "d = nan", 10, "joint 1 (shoulder) d", ["not finite"]),
    ("inf", "mass = 2.5", "mass = inf", 14, "joint 1 (shoulder) mass", ["not finite"]),
    ("overflow", "d = 0.1", "d = 1e999", 10, "joint 1 (shoulder) d", ["not finite"]),
    ("huge integer", "d = 0.1", f"d = 1{'0' * 400}", 10, "joint 1 (shoulder) d", ["not finite"]),
    ("millimetres", "d = 0.1", "d = 89.159", 10, "joint 1 (shoulder) d", ["millimetres"]),
    ("com in mm", "-0.02, 0.001", "-25.61, 1.93", 15, "joint 1 (shoulder) com", ["millimetres"]),
    ("degrees", 'alpha = "pi/2"', "alpha = 90", 12, "joint 1 (shoulder) alpha", ["degrees", "90"]),
    ("many turns", 'alpha = "pi/2"', 'alpha = "90*pi"', 12, "joint 1 (shoulder) alpha", ["degree"]),
    ("offset", 'offset = "-pi/2"', "offset = -90", 13, "joint 1 (shoulder) offset", ["degrees"]),
    ("not an angle", '"-pi/2"', '"tau/4"', 13, "joint 1 (shoulder) offset", ["is no angle"]),
    ("pi by zero", '"-pi/2"', '"pi/0"', 13, "joint 1 (shoulder) offset", ["is no angle"]),
    ("code", '"-pi/2"', '"__import__(1)"', 13, "joint 1 (shoulder) offset", ["is no angle"]),
    ("com of two", "[0.0, -0.02, 0.001]", "[0, 0]", 15, "joint 1 (shoulder) com", ["not 2"]),
    ("com text", "[0.0, -0.02, 0.001]", '["0", 0, 0]', 15, "joint 1 (shoulder) com", ["number"]),
    ("r of two", "a = -0.4", "a = -0.4\nr = [0, 0]", 26, "joint 2 (elbow) r", ["not 2"]),
    ("inertia list", TENSOR, "[1, 1, 1]", 16, "joint 1 (shoulder) inertia", ["not a table"]),
    ("no izz", "izz = 0.04, ", "", 16, "joint 1 (shoulder) inertia izz", ["is missing"]),
    ("inertia key", "ixy = 0.001", "iyx = 0.001", 16, "joint 1 (shoulder) inertia iyx",
     ["did you mean"]),
    ("indefinite", "ixy = 0.001", "ixy = 0.1", 16, "joint 1 (shoulder) inertia",
     ["not positive definite"]),
    ("triangle", "izz = 0.04", "izz = 0.06", 16, "joint 1 (shoulder) inertia", ["triangle"]),
    ("negative mass", "mass = 2.5", "mass = -2.5", 14, "joint 1 (shoulder) mass", ["negative"]),
    ("tensor alone", "mass = 2.5", "mass = 0", 14, "joint 1 (shoulder) mass", ["mass is zero"]),
    ("limits", LIMITS, "limits = 3", 17, "joint 1 (shoulder) limits", ["not a table"]),
    ("limits key", "effort = 150", "force = 150", 17, "joint 1 (shoulder) limits force",
     ["choose one of"]),
    ("swapped", "lower = -1.5", "lower = 2.5", 17, "joint 1 (shoulder) limits", ["exceeds"]),
    ("negative effort", "effort = 150", "effort = -150", 17, "joint 1 (shoulder) limits effort",
     ["negative"]),
    ("source", '{ d = "Table 1" }', "{ d = 1 }", 18, "joint 1 (shoulder) source d", ["text"]),
    ("twin joints", '"elbow"', '"shoulder"', 21, "joint 2 joint", ["row 1 already"]),
    ("twin links", '"fore"', '"upper"', 22, "joint 2 link", ["row 1 already"]),
]  # fmt: skip


@pytest.mark.parametrize(
    ("old", "new", "line", "element", "words"), [fault[1:] for fault in FAULTS],
    ids=[fault[0] for fault in FAULTS],
)  # fmt: skip
def test_each_fault_is_named_with_its_place(
    old: str, new: str, line: int | None, element: str | None, words: list[str]
) -> None:
    with pytest.raises(ModelError) as caught:
        changed(old, new)
    error = caught.value
    assert (error.file, error.line, error.element) == ("two.toml", line, element), error
    for word in words:
        assert word in str(error)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "schema: is missing"),
        (SHORT, "no rows"),
        (SHORT + "joint = []", "no rows"),
        (SHORT + "joint = 3", "no rows"),
        (SHORT + "joint = [3]", "no rows"),
        (SHORT + "[joint]", "no rows"),
        (SHORT + "joint = " + 5000 * "[" + 5000 * "]", "not TOML"),
        (SHORT + f"joint = 1{5000 * '0'}", "not TOML"),
    ],
    ids=["empty", "none", "empty list", "number", "list", "table", "deep", "endless integer"],
)
def test_a_file_without_rows_is_refused(text: str, words: str) -> None:
    with pytest.raises(ModelError, match=words):
        read(text)


def test_a_massless_tip_is_refused_and_a_massless_link_within_is_not() -> None:
    massless = "mass = 0\ncom = [0, 0, 0]\ninertia = { ixx = 0, iyy = 0, izz = 0 }\n"
    with pytest.raises(ModelError, match="mass zero on a moving tip"):
        read(GOOD[: GOOD.rindex("mass = 1.0")] + massless)
    within = GOOD.replace("mass = 2.5", "mass = 0.0").replace(TENSOR, "{ixx=0, iyy=0, izz=0}")
    assert read(within).links[0].inertia.mass == 0.0


def test_r_has_no_meaning_under_the_modified_convention() -> None:
    text = GOOD.replace('"standard"', '"modified"').replace("a = 0\n", "a = 0\nr = [0, 0, 0]\n")
    with pytest.raises(ModelError, match="modified convention"):
        read(text)


def test_bytes_that_are_no_text_are_refused() -> None:
    with pytest.raises(ModelError, match=r"two\.toml:2: the file is not UTF-8"):
        read_dh(b'schema = "x"\nname = "\xff"\n', file="two.toml")


@pytest.mark.parametrize("tensor", ["", "inertia = { ixx = 0, iyy = 0.0, izz = 0 }"])
def test_a_tensor_left_out_or_zero_is_unknown(tensor: str) -> None:
    arm = changed(f"inertia = {TENSOR}", tensor)
    assert arm.unknown_tensors == ("upper",)
    known = read(GOOD)
    q, rest = [0.3, 0.1], [0.0, 0.0]
    expected = ur5check.gravity_torque(known, q)
    np.testing.assert_array_equal(ur5check.gravity_torque(arm, q), expected)
    np.testing.assert_array_equal(ur5check.rnea(arm, q, rest, rest), expected)
    for needs_it in (
        lambda: ur5check.rnea(arm, q, [1.0, 0.0], rest),
        lambda: ur5check.mass_matrix(arm, q),
        lambda: ur5check.forward_dynamics(arm, q, rest, rest),
        lambda: ur5check.validate(arm, samples=5),
        lambda: ur5check.compile(arm).rnea(np.zeros((1, 2)), np.zeros((1, 2)), np.zeros((1, 2))),
        lambda: urdf_of_format(arm),
    ):
        with pytest.raises(ModelError, match="'upper'") as caught:
            needs_it()
        assert caught.value.rule == "INE117"
    difference = ur5check.diff(arm, known, samples=20)
    assert difference.gravity_only
    assert difference.agrees
    assert read(dh_toml_of(arm)).unknown_tensors == ("upper",)


def urdf_of_format(arm: SerialArm) -> str:
    return FORMATS["urdf"].write(arm)


def test_all_faults_of_a_sheet_are_found_in_one_run() -> None:
    text = GOOD.replace('alpha = "pi/2"', "alpha = 90").replace("a = -0.4", "a = -425")
    text = text.replace("mass = 2.5", "mass = -2.5").replace("offset = ", "offest = ")
    log = FindingLog()
    assert read_dh_robot(text.encode(), "two.toml", log) == (None, None)
    lines = text.splitlines()
    found = {(f.rule, lines[f.place.line - 1].split(" ")[0]) for f in log.findings}
    assert found == {
        ("JNT110", "alpha"), ("XML100", "a"), ("INE101", "mass"), ("XML100", "offest")
    }  # fmt: skip
