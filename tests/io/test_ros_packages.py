"""Package names to folders, without ROS."""

from __future__ import annotations

from pathlib import Path

import pytest

from ur5check._errors import ModelError
from ur5check._io.ros_packages import PackageMap, default_packages, models_directory


@pytest.fixture
def two_folders(tmp_path: Path) -> PackageMap:
    """Package `arm` in two folders: `shared.txt` in both, `second.txt` in the second only."""
    for folder, files in (("one", ["shared.txt"]), ("two", ["shared.txt", "second.txt"])):
        (tmp_path / folder).mkdir()
        for file in files:
            (tmp_path / folder / file).write_text(folder)
    return PackageMap({"arm": (tmp_path / "one", tmp_path / "two")})


def refusal(packages: PackageMap, uri: str, relative_to: Path) -> ModelError:
    with pytest.raises(ModelError) as caught:
        packages.resolve(uri, relative_to)
    assert caught.value.element == uri
    return caught.value


def test_find_answers_with_the_first_folder(two_folders: PackageMap, tmp_path: Path) -> None:
    assert two_folders.find("arm") == tmp_path / "one"


def test_folders_are_searched_in_order(two_folders: PackageMap, tmp_path: Path) -> None:
    assert two_folders.resolve("package://arm/shared.txt", tmp_path).read_text() == "one"
    assert two_folders.resolve("package://arm/second.txt", tmp_path).read_text() == "two"


def test_a_package_given_later_is_searched_first(two_folders: PackageMap, tmp_path: Path) -> None:
    more = two_folders.with_packages({"arm": str(tmp_path / "two"), "leg": [tmp_path / "one"]})
    assert more.find("arm") == tmp_path / "two"
    assert more.find("leg") == tmp_path / "one"
    assert two_folders.find("arm") == tmp_path / "one"  # the first map has not changed


@pytest.mark.parametrize("form", ["second.txt", "file://{}/two/second.txt", "{}/two/second.txt"])
def test_paths_need_no_package(two_folders: PackageMap, tmp_path: Path, form: str) -> None:
    found = two_folders.resolve(form.format(tmp_path), tmp_path / "two")
    assert found == tmp_path / "two" / "second.txt"


def test_percent_signs_are_read(two_folders: PackageMap, tmp_path: Path) -> None:
    (tmp_path / "two" / "a b.stl").write_text("")
    assert two_folders.resolve("package://arm/a%20b.stl", tmp_path).name == "a b.stl"


def test_an_unknown_package_names_the_option_and_the_nearest_name(two_folders: PackageMap) -> None:
    with pytest.raises(ModelError) as caught:
        two_folders.find("army")
    assert "--package army=DIR" in caught.value.fix
    assert "did you mean 'arm'?" in caught.value.fix


def test_a_missing_file_says_where_it_was_looked_for(
    two_folders: PackageMap, tmp_path: Path
) -> None:
    error = refusal(two_folders, "package://arm/third.txt", tmp_path)
    assert all(str(tmp_path / folder / "third.txt") in error.problem for folder in ("one", "two"))


@pytest.mark.parametrize("uri", ["package://arm/../two/second.txt", "package://arm/%2e%2e/x"])
def test_a_package_path_may_not_climb_out(
    two_folders: PackageMap, tmp_path: Path, uri: str
) -> None:
    assert "climbs out" in refusal(two_folders, uri, tmp_path).problem


@pytest.mark.parametrize("uri", ["http://arm/x.stl", "model://arm/x.stl", "file://elsewhere/x.stl"])
def test_other_addresses_are_refused(two_folders: PackageMap, tmp_path: Path, uri: str) -> None:
    assert "not supported" in refusal(two_folders, uri, tmp_path).problem


def test_a_folder_that_does_not_exist_is_refused_at_once(tmp_path: Path) -> None:
    with pytest.raises(ModelError, match="does not exist") as caught:
        PackageMap().with_packages({"arm": tmp_path / "nowhere"})
    assert caught.value.value == str(tmp_path / "nowhere")


def test_a_package_map_cannot_be_changed(two_folders: PackageMap) -> None:
    with pytest.raises(TypeError):
        two_folders.folders["arm"] = ()  # type: ignore[index]


def test_by_default_our_ur_description_comes_first_and_the_meshes_are_found() -> None:
    packages = default_packages()
    assert packages.find("ur_description") == models_directory() / "ur_description"
    mesh = packages.resolve("package://ur_description/meshes/ur5/visual/base.dae", Path())
    assert "example-robot-data" in mesh.parts
    assert packages.find("panda_description").parent.name == "robots"


def test_addresses_inside_example_robot_data_are_found() -> None:
    uri = "package://example-robot-data/robots/ur_description/meshes/ur5/visual/base.dae"
    assert default_packages().resolve(uri, Path()).is_file()
