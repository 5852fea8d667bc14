"""The models that come with this program, by name."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Literal

from .._errors import ModelError, UsageError
from .ros_packages import example_robot_data, models_directory
from .suggestions import did_you_mean

__all__ = ["SHIPPED_MODELS", "ShippedModel", "lookup", "models_directory"]

_PAPER = (
    "R. Kumar, Inverse Dynamics Analysis of 6-dof Robotic Manipulator (UR5) by Forward & Backward "
    "Recursion, SSRN 3939013"
)


@dataclass(frozen=True)
class ShippedModel:
    """A shipped model.

    kind : which reader takes it
    title : one line for a list
    source : where its numbers come from
    licence : of the file
    home, file : the folder it lies in (`models`, or the robots that example-robot-data installs)
        and its path from there
    base, tip : the links between which a URDF is taken as an arm; None for a DH table
    """

    name: str
    kind: Literal["dh", "xacro", "urdf"]
    title: str
    source: str
    licence: str
    home: Literal["models", "example-robot-data"]
    file: PurePosixPath
    base: str | None = None
    tip: str | None = None

    def path(self) -> Path:
        """The file.  Raises ModelError if it is not installed."""
        if self.home == "models":
            return models_directory() / self.file
        share = example_robot_data()
        path = None if share is None else share / self.file
        if path is None or not path.is_file():
            raise ModelError(
                "this model is part of example-robot-data, which is not installed here",
                fix="install example-robot-data",
                file=str(path or self.file),
                element=f"model {self.name!r}",
            )
        return path


_ENTRIES = (
    ShippedModel(
        "paper",
        "dh",
        "UR5 on the controller's DH, with the masses and inertias of the paper's listing",
        f"{_PAPER}: the controller's DH in the appendix, the listing's tables",
        "BSD-2-Clause",
        "models",
        PurePosixPath("paper.toml"),
    ),
    ShippedModel(
        "paper-listing",
        "dh",
        "UR5 as the paper's listing computes it: its own r vectors, α = 1.5707, g = 9.806",
        f"{_PAPER}: the listing, taken literally",
        "BSD-2-Clause",
        "models",
        PurePosixPath("paper-listing.toml"),
    ),
    ShippedModel(
        "appendix",
        "xacro",
        "UR5 of the paper's appendix: the xacro of ur_description",
        f"{_PAPER}: appendix, ur5.urdf.xacro",
        "BSD",
        "models",
        PurePosixPath("ur_description/urdf/ur5_robot.urdf.xacro"),
        base="base_link",
        tip="tool0",
    ),
    ShippedModel(
        "erd-ur5",
        "urdf",
        "UR5 of example-robot-data",
        "example-robot-data, robots/ur_description/urdf/ur5_robot.urdf, made from ROS-Industrial's "
        "ur_description",
        "BSD",
        "example-robot-data",
        PurePosixPath("robots/ur_description/urdf/ur5_robot.urdf"),
        base="base_link",
        tip="tool0",
    ),
)

#: Every shipped model, in the order in which lists show them.
SHIPPED_MODELS: dict[str, ShippedModel] = {entry.name: entry for entry in _ENTRIES}


def lookup(name: str) -> ShippedModel:
    """The model of that name.  Raises UsageError for an unknown one."""
    try:
        return SHIPPED_MODELS[name]
    except KeyError:
        raise UsageError(
            f"no shipped model is called {name!r}; {did_you_mean(name, SHIPPED_MODELS)}"
        ) from None
