"""Arms that expose import errors, each in two forms that were written down separately.

The first comes as a URDF's text, for the engine's own parser, and beside it the `SerialArm` that
the text means, computed here from the same numbers by the arm's own algebra and by no parser of
ours.  It has what readers are known to misread: joints listed from tip to base, an axis that is no
coordinate axis and one that points backwards, a prismatic joint, a continuous one, rotated
inertials, massless links (one with a shape), links fixed to moving ones, a finger beside the arm,
a base with a mass.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from .._robot.inertia import Inertia
from .._robot.serial_arm import Joint, Limits, Link, SerialArm, Source
from .._robot.transforms import Array, Transform

__all__ = ["CASES", "Case", "as_value", "in_text"]

URDF = """\
<robot name="conformance">
  <link name="tool">
    <collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision>
  </link>
  <link name="finger">
    <inertial>
      <origin xyz="0 0.02 0.05"/>
      <mass value="0.2"/>
      <inertia ixx="0.0004" ixy="0" ixz="0" iyy="0.0003" iyz="0.00005" izz="0.0002"/>
    </inertial>
  </link>
  <link name="camera">
    <inertial>
      <origin xyz="0.01 0 0.03" rpy="0.5 0.1 -0.7"/>
      <mass value="0.3"/>
      <inertia ixx="0.0007" ixy="0" ixz="0.0001" iyy="0.0005" iyz="0" izz="0.0004"/>
    </inertial>
  </link>
  <link name="hand">
    <inertial>
      <origin xyz="0.02 -0.03 0.06" rpy="0.4 0.5 0.6"/>
      <mass value="1.1"/>
      <inertia ixx="0.009" ixy="0.0004" ixz="-0.0006" iyy="0.008" iyz="0.0002" izz="0.005"/>
    </inertial>
  </link>
  <link name="slider">
    <inertial>
      <origin xyz="0 0.1 0" rpy="1.5707963267948966 0 0"/>
      <mass value="2.5"/>
      <inertia ixx="0.03" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.012"/>
    </inertial>
  </link>
  <link name="shoulder">
    <inertial>
      <origin xyz="0.05 0.02 0.2"/>
      <mass value="4"/>
      <inertia ixx="0.08" ixy="0.002" ixz="0.001" iyy="0.07" iyz="-0.003" izz="0.03"/>
    </inertial>
  </link>
  <link name="base_link">
    <inertial>
      <mass value="7"/>
      <inertia ixx="0.2" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.1"/>
    </inertial>
  </link>
  <joint name="tool_fixed" type="fixed">
    <parent link="hand"/>
    <child link="tool"/>
    <origin xyz="0.03 0 0.12" rpy="0.2 -0.4 0.9"/>
  </joint>
  <joint name="finger_joint" type="revolute">
    <parent link="hand"/>
    <child link="finger"/>
    <origin xyz="0 0.04 0.1" rpy="0 0.3 0"/>
    <axis xyz="0 1 0"/>
    <limit lower="-0.5" upper="0.5" effort="2" velocity="1"/>
  </joint>
  <joint name="camera_fixed" type="fixed">
    <parent link="hand"/>
    <child link="camera"/>
    <origin xyz="-0.05 0.02 0.04" rpy="0.1 0.7 0.2"/>
  </joint>
  <joint name="turn" type="continuous">
    <parent link="slider"/>
    <child link="hand"/>
    <origin xyz="0 0.25 0.02" rpy="-0.6 0.1 0.3"/>
    <axis xyz="-1 0 0"/>
    <limit effort="12" velocity="4"/>
  </joint>
  <joint name="slide" type="prismatic">
    <parent link="shoulder"/>
    <child link="slider"/>
    <origin xyz="0.02 0.05 0.35" rpy="0.2 0.3 -0.4"/>
    <axis xyz="0 -1 0"/>
    <limit lower="-0.5" upper="0.4" effort="200" velocity="1.5"/>
  </joint>
  <joint name="hinge" type="revolute">
    <parent link="base_link"/>
    <child link="shoulder"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.3 -0.2 0.1"/>
    <axis xyz="0.6 0 0.8"/>
    <dynamics damping="0.3" friction="0"/>
    <limit lower="-2" upper="2.5" effort="90" velocity="3"/>
  </joint>
</robot>
"""


@dataclass(frozen=True, eq=False)
class Case:
    """An arm to test an engine with.

    Attributes
    ----------
    name : str
    arm : SerialArm
    gravity : ndarray, shape (3,)
        In the arm's base frame [m/s²].
    """

    name: str
    arm: SerialArm
    gravity: Array


def _pose(x: float, y: float, z: float, *rpy: float) -> Transform:
    return Transform.from_rpy((x, y, z), rpy or (0.0, 0.0, 0.0))


def _body(mass: float, pose: Transform, *entries: float) -> Inertia:
    """entries : ixx, ixy, ixz, iyy, iyz, izz, along the axes of `pose`."""
    xx, xy, xz, yy, yz, zz = entries
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    return Inertia(mass, np.zeros(3), tensor).expressed_in(pose)


@cache
def in_text() -> SerialArm:
    """The arm that `URDF` means, from base_link to tool, its finger fixed."""
    starts = [
        _pose(0.1, 0.2, 0.3, 0.3, -0.2, 0.1),
        _pose(0.02, 0.05, 0.35, 0.2, 0.3, -0.4),
        _pose(0.0, 0.25, 0.02, -0.6, 0.1, 0.3),
    ]
    tool = _pose(0.03, 0.0, 0.12, 0.2, -0.4, 0.9)
    shoulder = _body(4.0, _pose(0.05, 0.02, 0.2), 0.08, 0.002, 0.001, 0.07, -0.003, 0.03)
    slider = _body(2.5, _pose(0.0, 0.1, 0.0, np.pi / 2, 0.0, 0.0), 0.03, 0, 0, 0.02, 0, 0.012)
    palm = _pose(0.02, -0.03, 0.06, 0.4, 0.5, 0.6)
    hand = _body(1.1, palm, 0.009, 0.0004, -0.0006, 0.008, 0.0002, 0.005)
    lens = _pose(-0.05, 0.02, 0.04, 0.1, 0.7, 0.2) @ _pose(0.01, 0.0, 0.03, 0.5, 0.1, -0.7)
    camera = _body(0.3, lens, 0.0007, 0.0, 0.0001, 0.0005, 0.0, 0.0004)
    bone = _pose(0.0, 0.04, 0.1, 0.0, 0.3, 0.0) @ _pose(0.0, 0.02, 0.05)
    finger = _body(0.2, bone, 0.0004, 0.0, 0.0, 0.0003, 0.00005, 0.0002)
    joints = (
        Joint("hinge", np.array([0.6, 0, 0.8]), "revolute", Limits(-2, 2.5, 3, 90), 0.0, 0.3),
        Joint("slide", np.array([0.0, -1.0, 0.0]), "prismatic", Limits(-0.5, 0.4, 1.5, 200)),
        Joint("turn", np.array([-1.0, 0, 0]), "revolute", Limits(velocity=4, effort=12)),
    )
    links = tuple(
        Link(
            name,
            link_tip_frame,
            inertia.expressed_in(link_tip_frame.inverse()),
            link_tip_frame.inverse(),
        )
        for name, link_tip_frame, inertia in (
            ("shoulder", starts[1], shoulder),
            ("slider", starts[2], slider),
            ("hand", tool, hand + camera + finger),
        )
    )
    source = Source(kind="urdf", urdf=URDF, base="base_link", tip="tool")
    return SerialArm("conformance", joints, links, starts[0], source=source)


@cache
def as_value() -> SerialArm:
    """The same chain as a value without a file, under another gravity."""
    arm = replace(in_text(), name="conformance-value", source=Source())
    return arm.with_gravity((1.0, -2.0, -9.0))


#: As a text, as a text under a gravity that is not down, and joint by joint.
CASES: tuple[Case, ...] = (
    Case("text", in_text(), in_text().gravity),
    Case("text, tilted", in_text(), np.array([3.0, -4.0, -8.0])),
    Case("value", as_value(), as_value().gravity),
)
