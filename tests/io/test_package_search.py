"""ROS packages around a file are found without being named."""

from __future__ import annotations

from ur5check._io.package_search import packages_around


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


def test_the_variables_of_ros(tmp_path, monkeypatch):
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "one"))
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path / "two"))
    one, two = package(tmp_path / "one/a", "a"), package(tmp_path / "two/share/b", "b")
    assert packages_around(tmp_path / "elsewhere/arm.urdf") == {"a": one, "b": two}


def test_a_file_in_no_package_finds_none(tmp_path):
    assert packages_around(tmp_path / "arm.urdf") == {}
