"""ROS packages around a file are found without being named."""

from __future__ import annotations

import pytest

import ur5check
from ur5check._errors import ModelError
from ur5check._io.package_search import packages_around
from ur5check._io.ros_packages import PackageMap
from ur5check._io.xacro.xacro_reader import expand_xacro
from ur5check._rules.examples import robot

ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
XACRO = f'{ROBOT}<link name="a"/></robot>'


def package(folder, name):
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(f"<package><name>{name}</name></package>")
    return folder


def test_its_own_package_its_siblings_and_those_of_repositories(tmp_path):
    own = package(tmp_path / "src/my_arm/my_arm_description", "my_arm_description")
    sibling = package(tmp_path / "src/my_arm/my_gripper", "gripper")
    file = own / "urdf" / "arm.urdf"
    file.parent.mkdir()
    file.write_text("")
    assert packages_around(file) == {"my_arm_description": own, "gripper": sibling}


@pytest.mark.parametrize("is_repository", [True, False])
def test_all_packages_of_a_repository(tmp_path, is_repository):
    """Planner's configurations lie in a folder of their own, beside the description."""
    top = tmp_path / "vendor"
    own = package(top / "moveit/arm_config", "arm_config")
    description = package(top / "arm_description", "arm_description")
    if is_repository:
        (top / ".git").mkdir()
    found = packages_around(own / "config/arm.urdf.xacro")
    assert found == {"arm_config": own} | (
        {"arm_description": description} if is_repository else {}
    )


def test_the_variables_of_ros(tmp_path, monkeypatch):
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "one"))
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path / "two"))
    one, two = package(tmp_path / "one/a", "a"), package(tmp_path / "two/share/b", "b")
    assert packages_around(tmp_path / "elsewhere/arm.urdf") == {"a": one, "b": two}


def test_a_file_in_no_package_finds_none(tmp_path):
    assert packages_around(tmp_path / "arm.urdf") == {}


def test_the_other_packages_of_a_colcon_workspace(tmp_path):
    own = package(tmp_path / "install/arm/share/arm", "arm")
    other = package(tmp_path / "install/hand/share/hand", "hand")
    assert packages_around(own / "urdf/arm.urdf") == {"arm": own, "hand": other}


def linked(folder, target):
    """A package as `colcon build --symlink-install` leaves it; its sources."""
    source = package(target, "arm")
    (source / "arm.xacro").write_text(XACRO)
    folder.mkdir(parents=True)
    (folder / "arm.xacro").symlink_to(source / "arm.xacro")
    return source


@pytest.mark.parametrize("manifest", ["linked", "copied", "of another package"])
def test_links_into_a_packages_own_sources_are_read(tmp_path, manifest):
    share = tmp_path / "install/arm/share/arm"
    source = linked(share, tmp_path / "src/arm")
    if manifest == "linked":
        (share / "package.xml").symlink_to(source / "package.xml")
    else:
        (share / "package.xml").write_text("<package><name>arm</name></package>")
    if manifest == "of another package":
        (source / "package.xml").write_text("<package><name>other</name></package>")
    file = tmp_path / "robots" / "r.xacro"
    file.parent.mkdir()
    file.write_text(
        XACRO.replace("<link", '<xacro:include filename="$(find arm)/arm.xacro"/><link')
    )
    packages = PackageMap({"arm": (share,)})
    if manifest == "of another package":
        with pytest.raises(ModelError) as caught:
            expand_xacro(file, arguments={}, packages=packages)
        assert caught.value.rule == "XAC103"
    else:
        expansion = expand_xacro(file, arguments={}, packages=packages)
        assert expansion.text.count("<link") == 2
        assert "package://arm/arm.xacro" in dict(expansion.inputs)


def test_load_finds_the_package_around_the_file(tmp_path):
    own = package(tmp_path / "arm", "arm")
    (own / "part.xacro").write_text(robot().replace('<robot name="r">', ROBOT))
    file = own / "r.xacro"
    file.write_text(f'{ROBOT}<xacro:include filename="$(find arm)/part.xacro"/></robot>')
    assert ur5check.load(file).n == 1
