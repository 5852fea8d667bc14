"""Every fault of a URDF meets one clear error that names its line; a good file meets none."""

from __future__ import annotations

import pytest

from ur5check._errors import ModelError
from ur5check._io.urdf.urdf_reader import read_urdf
from urdf_examples import GOOD, spoiled

TENSOR = 'ixx="0.02" ixy="0.001" ixz="0" iyy="0.03" iyz="0" izz="0.04"'
LIMIT = '<limit lower="-1.5" upper="2.5" effort="10" velocity="3"/>'
SLIDE = '<limit lower="0" upper="0.2" effort="10" velocity="3"/>'
LOOP = """<link name="a"/><link name="b"/>
<joint name="ab" type="fixed"><parent link="a"/><child link="b"/></joint>
<joint name="ba" type="fixed"><parent link="b"/><child link="a"/></joint></robot>"""

# id, what is replaced, by what, line of the error, words in its message
FAULTS = [
    ("namespace", "<robot ", '<robot xmlns="http://ros.org" ', 2, ["namespace"]),
    ("no robot name", '<robot name="two">', "<robot>", 2, ["<robot>", "has no name"]),
    ("empty robot name", 'name="two"', 'name=" "', 2, ["has no name"]),
    ("xacro expression", 'value="2.0"', 'value="${m}"', 14, ["xacro", "${m}", "expand"]),
    ("xacro find", 'name="tool"', 'name="$(arg tool)"', 36, ["xacro"]),
    ("no link name", '<link name="tool"/>', "<link/>", 36, ["<link>", "has no name"]),
    ("no joint name", 'name="flange" ', "", 31, ["<joint>", "has no name"]),
    ("twin links", '<link name="tool"/>', '<link name="upper"/>', 36, ["twice", "line 11"]),
    ("twin joints", 'name="flange"', 'name="j1"', 31, ["joint 'j1'", "twice", "line 4"]),
    ("no type", 'type="fixed"', "", 31, ["joint 'flange'", "has no type"]),
    ("bad type", 'type="fixed"', 'type="fixd"', 31, ["'fixd'", "did you mean 'fixed'?"]),
    ("no parent", '<parent link="base"/>', "", 4, ["joint 'j1' parent", "missing"]),
    ("no child link", '<child link="tool"/>', "<child/>", 31, ["joint 'flange' child", "missing"]),
    ("bad parent", 'parent link="upper"', 'parent link="uper"', 20, ["did you mean 'upper'?"]),
    ("bad child", 'child link="tool"', 'child link="tol"', 34, ["did you mean 'tool'?"]),
    ("two parents", 'child link="tool"', 'child link="upper"', 31, ["two parents", "'j1'"]),
    ("own child", 'child link="tool"', 'child link="base"', 4, ["cycle"]),
    ("loop aside", "</robot>", LOOP, 38, ["joint 'ab'", "cycle"]),
    ("two roots", "</robot>", '<link name="lost"/></robot>', 37, ["'lost'", "2 separate trees"]),
    ("two parent tags", '<parent link="base"/>', '<parent link="base"/><parent/>', 6, ["several"]),
    ("comma", 'value="2.0"', 'value="2,5"', 14, ["decimal comma", "'2,5'"]),
    ("nan", 'value="2.0"', 'value="nan"', 14, ["not finite", "link 'upper' inertial/mass"]),
    ("inf", 'value="2.0"', 'value="inf"', 14, ["not finite"]),
    ("overflow", 'value="2.0"', 'value="1e999"', 14, ["larger than a double"]),
    ("underscore", 'value="2.0"', 'value="1_000"', 14, ["not a plain number", "1_000"]),
    ("hexadecimal", 'value="2.0"', 'value="0x10"', 14, ["not a plain number"]),
    ("empty number", 'value="2.0"', 'value=""', 14, ["is empty"]),
    ("no value", 'value="2.0"', "", 14, ["value is missing"]),
    ("xyz of two", 'xyz="0 0 0.2"', 'xyz="0 0.2"', 13, ["takes 3 numbers, not 2"]),
    ("xyz nan", 'xyz="0 0 0.2"', 'xyz="0 0 nan"', 13, ["not finite", "0 0 nan"]),
    ("rpy of four", 'rpy="0.1 0.2 0.3"', 'rpy="0 0 0 1"', 13, ["not 4", "rpy"]),
    ("joint xyz", 'xyz="0.3 0 0.5"', 'xyz="0.3"', 19, ["joint 'j2' origin xyz"]),
    ("axis of two", 'axis xyz="0 0 1"', 'axis xyz="0 1"', 8, ["joint 'j1' axis", "not 2"]),
    ("axis without xyz", '<axis xyz="0 0 1"/>', "<axis/>", 8, ["joint 'j1' axis", "missing"]),
    ("zero axis", 'axis xyz="0 0 1"', 'axis xyz="0 0 0"', 8, ["joint 'j1' axis", "is zero"]),
    ("two inertials", "</inertial>\n  </link>\n  <joint name=\"j2\"",
     "</inertial>\n<inertial/></link>\n  <joint name=\"j2\"", 17, ["several <inertial>"]),
    ("no mass", '<mass value="2.0"/>', "", 12, ["link 'upper' inertial", "has no <mass>"]),
    ("no inertia", f"<inertia {TENSOR}/>", "", 12, ["has no <inertia>"]),
    ("no ixy", 'ixy="0.001"', "", 15, ["ixy is missing"]),
    ("negative mass", 'value="2.0"', 'value="-2.0"', 14, ["mass is negative", "kilograms"]),
    ("tensor alone", 'value="2.0"', 'value="0"', 14, ["mass is zero although"]),
    ("indefinite", 'ixy="0.001"', 'ixy="0.1"', 15, ["not positive definite"]),
    ("triangle", 'izz="0.04"', 'izz="0.06"', 15, ["triangle inequality", "0.06"]),
    ("no limit", LIMIT, "", 4, ["joint 'j1' limit", "missing"]),
    ("no bounds", SLIDE, '<limit effort="1" velocity="1"/>', 23, ["lower and upper are missing"]),
    ("no effort", LIMIT, '<limit lower="0" upper="1" velocity="1"/>', 9, ["effort is missing"]),
    ("no velocity", LIMIT, '<limit lower="0" upper="1" effort="1"/>', 9, ["velocity is missing"]),
    ("swapped", LIMIT, LIMIT.replace("-1.5", "3.5"), 9, ["lower exceeds upper", "3.5"]),
    ("negative effort", LIMIT, LIMIT.replace('"10"', '"-10"'), 9, ["effort", "negative"]),
    ("negative velocity", LIMIT, LIMIT.replace('"3"', '"-3"'), 9, ["velocity", "negative"]),
    ("nan limit", LIMIT, LIMIT.replace('"2.5"', '"nan"'), 9, ["upper", "not finite"]),
    ("mimic", SLIDE, SLIDE + '<mimic joint="j7"/>', 23, ["'j7'", "names no other joint"]),
    ("mimic itself", SLIDE, SLIDE + '<mimic joint="j2"/>', 23, ["names no other joint"]),
    ("mimic number", SLIDE, SLIDE + '<mimic joint="j1" offset="x"/>', 23, ["offset", "'x'"]),
]  # fmt: skip


@pytest.mark.parametrize(
    ("old", "new", "line", "words"), [fault[1:] for fault in FAULTS], ids=[f[0] for f in FAULTS]
)
def test_each_fault_is_named_with_its_line(old: str, new: str, line: int, words: list[str]) -> None:
    with pytest.raises(ModelError) as caught:
        read_urdf(spoiled(old, new), file="spoiled.urdf")
    error = caught.value
    assert (error.file, error.line) == ("spoiled.urdf", line), error
    assert error.element and error.fix
    for word in words:
        assert word in str(error)


def test_a_robot_without_links_is_refused() -> None:
    with pytest.raises(ModelError, match="has no link"):
        read_urdf(b'<robot name="empty"/>', file="empty.urdf")


@pytest.mark.parametrize(("tag", "words"), [("sdf", "SDFormat"), ("mujoco", "MuJoCo")])
def test_other_formats_are_named(tag: str, words: str) -> None:
    with pytest.raises(ModelError, match=f"{words}.*name it"):
        read_urdf(f"<{tag}/>".encode(), file="other.urdf")


def test_a_xacro_element_is_refused() -> None:
    macro = b'<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include/></robot>'
    with pytest.raises(ModelError, match=r"xacro:include.*not yet expanded"):
        read_urdf(macro, file="raw.urdf")


GOOD_VARIANTS = {
    "as it is": ('name="two"', 'name="two"'),
    "declares xacro, as xacro writes": ("<robot ", '<robot xmlns:xacro="http://ros.org/xacro" '),
    "exponents and signs": ('value="2.0"', 'value="+.2E+1"'),
    "zero axis of a fixed joint": ("<child link=\"tool\"/>",
                                   "<child link=\"tool\"/><axis xyz=\"0 0 0\"/>"),
    "no axis": ('<axis xyz="0 0 1"/>', ""),
    "one bound left out": (SLIDE, '<limit upper="0.2" effort="10" velocity="3"/>'),
    "massless frame": ('<link name="tool"/>',
                       '<link name="tool"><inertial><mass value="0"/><inertia'
                       ' ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>'),
    "point mass": ('<link name="tool"/>', '<link name="tool"><inertial><mass value="1"/><inertia'
                   ' ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>'),
    "a thin disc": (TENSOR, 'ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.04"'),
    "a disc whose digits are rounded": (
        TENSOR, 'ixx="0.0033" ixy="0" ixz="0" iyy="0.0033" iyz="0" izz="0.0067"'),
    "broken shapes, which are no matter here": (
        '<link name="tool"/>', '<link name="tool"><visual><geometry/></visual></link>'),
}  # fmt: skip


@pytest.mark.parametrize(("old", "new"), GOOD_VARIANTS.values(), ids=GOOD_VARIANTS)
def test_what_urdf_allows_is_allowed(old: str, new: str) -> None:
    assert read_urdf(spoiled(old, new), file="good.urdf").get("name") == "two"


def tensor(ixx: str, iyy: str, izz: str, ixy: str = "0") -> bytes:
    return spoiled(TENSOR, f'ixx="{ixx}" ixy="{ixy}" ixz="0" iyy="{iyy}" iyz="0" izz="{izz}"')


def test_the_tolerance_is_the_rounding_of_the_digits_and_no_more() -> None:
    # 0.0033 and 0.0067 may each be off by 0.00005: the margin of −0.0001 lies within 0.00015.
    read_urdf(tensor("0.0033", "0.0033", "0.0067"), file="disc.urdf")
    # The same numbers printed with two digits more leave no room for it.
    with pytest.raises(ModelError, match="triangle"):
        read_urdf(tensor("0.003300", "0.003300", "0.006700"), file="disc.urdf")
    # The margin of −0.0002 is more than the digits can explain.
    with pytest.raises(ModelError, match="triangle"):
        read_urdf(tensor("0.0033", "0.0033", "0.0068"), file="disc.urdf")
    # ixy² > ixx iyy by rounding: the eigenvalue −0.00002 lies within the 0.00005 of ixx and iyy.
    read_urdf(tensor("0.0100", "0.0100", "0.0200", "0.01002"), file="rod.urdf")
    with pytest.raises(ModelError, match="positive definite"):
        read_urdf(tensor("0.010000", "0.010000", "0.020000", "0.010020"), file="rod.urdf")
    # Few digits printed are not few digits known: these are no rounded body's.
    with pytest.raises(ModelError, match="triangle"):
        read_urdf(tensor("0.1", "0.1", "0.3"), file="one_digit.urdf")
    with pytest.raises(ModelError, match="triangle"):
        read_urdf(tensor("1", "1", "3"), file="whole.urdf")


def test_the_good_file_is_good() -> None:
    root = read_urdf(GOOD.encode(), file="good.urdf")
    assert [link.get("name") for link in root.iter("link")] == ["base", "upper", "lower", "tool"]
