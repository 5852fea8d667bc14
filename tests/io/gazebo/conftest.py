"""What the export's tests share: packages in memory, and packages on disk."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

import ur5check
from ur5check._io.gazebo.gazebo_package import GazeboPackages, gazebo_packages
from ur5check._io.gazebo.package_folder import write_folder
from ur5check._io.ros_packages import default_packages
from ur5check._paper.cases import case

CASE_9 = tuple(case(9).joint_angles().ravel())


def hand_over(model, pose=CASE_9, **options) -> GazeboPackages:
    arm = ur5check.load(model) if isinstance(model, str) else model
    defaults = {"ros": ("1", "2"), "packages": default_packages(), "file": str(model)}
    return gazebo_packages(arm, pose, **defaults | options)


@pytest.fixture
def packages_of() -> Callable[..., GazeboPackages]:
    """`packages_of(model, pose, **options)`: packages for a model, in the paper's case 9."""
    return hand_over


@pytest.fixture(scope="session")
def appendix() -> GazeboPackages:
    """The paper's own arm, for both."""
    command = "ur5check export gazebo somewhere --model appendix"
    return hand_over("appendix", command=command)


@pytest.fixture(scope="session")
def on_disk(appendix, tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("packages") / "exported"
    write_folder(str(folder), appendix.files, appendix.programs)
    return folder
