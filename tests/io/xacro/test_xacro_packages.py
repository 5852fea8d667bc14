"""$(find NAME) of an unknown package is an error only where the robot needs the package."""

from __future__ import annotations

import pytest

from ur5check._errors import ModelError
from ur5check._io.ros_packages import PackageMap
from ur5check._io.xacro.xacro_reader import expand_xacro

FIND = "$(find absent)/x"


def expand(folder, body):
    file = folder / "r.xacro"
    file.write_text(f'<robot name="r" xmlns:xacro="http://wiki.ros.org/xacro">\n{body}\n</robot>')
    return expand_xacro(file, arguments={}, packages=PackageMap()).text


@pytest.mark.parametrize(
    "body",
    [
        f'<gazebo><plugin name="p"><parameters>{FIND}</parameters></plugin></gazebo>',
        f'<ros2_control name="c"><hardware file="{FIND}"/></ros2_control>',
        f'<transmission name="t"><type>{FIND}</type></transmission>',
        f'<xacro:property name="f" value="{FIND}"/><gazebo><a>${{f}}</a></gazebo>',
        f'<xacro:arg name="f" default="{FIND}"/><gazebo><a>$(arg f)</a></gazebo>',
    ],
)
def test_configuration_needs_no_package(tmp_path, body):
    assert FIND in expand(tmp_path, body)


@pytest.mark.parametrize(
    "body",
    [
        f'\n<link name="{FIND}"/>',
        f"\n<link>{FIND}</link>",
        f'\n<xacro:include filename="{FIND}.xacro"/>',
        f'\n<xacro:include filename="{FIND}*.xacro"/>',
        f'\n<xacro:property name="f" value="{FIND}"/><a b="${{xacro.load_yaml(f)}}"/>',
        f'\n<xacro:arg name="f" default="{FIND}"/><link name="$(arg f)"/>',
    ],
)
def test_the_robot_does(tmp_path, body):
    with pytest.raises(ModelError) as caught:
        expand(tmp_path, body)
    error = caught.value
    assert (error.rule, error.element, error.line) == ("XAC101", "$(find absent)", 3)
    assert "--package absent=DIR" in error.fix
