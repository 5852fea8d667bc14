"""A small good URDF to spoil, and where the robots of example-robot-data lie."""

from __future__ import annotations

from importlib import metadata
from pathlib import Path

GOOD = """\
<?xml version="1.0" encoding="utf-8"?>
<robot name="two">
  <link name="base"/>
  <joint name="j1" type="revolute">
    <origin xyz="0 0 0.1" rpy="0 1.5707963267948966 0"/>
    <parent link="base"/>
    <child link="upper"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1.5" upper="2.5" effort="10" velocity="3"/>
  </joint>
  <link name="upper">
    <inertial>
      <origin xyz="0 0 0.2" rpy="0.1 0.2 0.3"/>
      <mass value="2.0"/>
      <inertia ixx="0.02" ixy="0.001" ixz="0" iyy="0.03" iyz="0" izz="0.04"/>
    </inertial>
  </link>
  <joint name="j2" type="prismatic">
    <origin xyz="0.3 0 0.5"/>
    <parent link="upper"/>
    <child link="lower"/>
    <axis xyz="0 3 4"/>
    <limit lower="0" upper="0.2" effort="10" velocity="3"/>
  </joint>
  <link name="lower">
    <inertial>
      <mass value="1.0"/>
      <inertia ixx="0.010" ixy="0" ixz="0" iyy="0.010" iyz="0" izz="0.010"/>
    </inertial>
  </link>
  <joint name="flange" type="fixed">
    <origin xyz="0 0 0.05"/>
    <parent link="lower"/>
    <child link="tool"/>
  </joint>
  <link name="tool"/>
</robot>
"""


def spoiled(old: str, new: str) -> bytes:
    """The good URDF with one passage replaced, which must be there exactly once."""
    assert GOOD.count(old) == 1, old
    return GOOD.replace(old, new).encode()


def robot_path(name: str) -> Path:
    """A URDF of example-robot-data, by its file name."""
    files = metadata.files("example-robot-data") or []
    (found,) = (file for file in files if file.name == name and "robots" in file.parts)
    return Path(str(found.locate()))
