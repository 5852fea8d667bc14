"""Parts that several JSON reports share."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec
import numpy as np
from msgspec import Meta

from .._comparison.alignment import Alignment
from .._robot.inertia import Inertia
from .._robot.robot_tree import ArmOrTree
from .._robot.transforms import Transform

__all__ = [
    "AlignmentValue",
    "InertiaValue",
    "Matrix",
    "Matrix3",
    "Model",
    "Number",
    "OperationsValue",
    "Pose",
    "SideValue",
    "State",
    "Vector",
    "Vector3",
    "alignment_value",
    "inertia_value",
    "model_value",
    "pose",
    "state",
    "vector",
]

#: A number, or null where there is none.
Number = float | None
Vector = list[float]
Matrix = list[list[float]]
Vector3 = Annotated[list[float], Meta(min_length=3, max_length=3)]
Matrix3 = Annotated[list[Vector3], Meta(min_length=3, max_length=3)]
_Row4 = Annotated[list[float], Meta(min_length=4, max_length=4)]
Pose = Annotated[list[_Row4], Meta(min_length=4, max_length=4)]
SideValue = Literal["a", "b"]


class State(msgspec.Struct, frozen=True):
    """A state of the joints: q [rad or m], qd [per s], qdd [per s²], in the first model's
    coordinates.
    """

    q: Vector
    qd: Vector
    qdd: Vector


class Model(msgspec.Struct, frozen=True, kw_only=True):
    """A model: its name, the label that sets it apart from the others, where it came from."""

    name: str
    label: str
    kind: Literal["dh", "urdf", "xacro", "mjcf", "sdf", "pinocchio", "value"]
    base: str
    tip: str
    notes: list[str]


class InertiaValue(msgspec.Struct, frozen=True):
    """Mass [kg], centre of mass [m], tensor about it [kg m²], null where it is unknown."""

    mass: float
    com: Vector3
    tensor: Matrix3 | None


class UndeterminedValue(msgspec.Struct, frozen=True):
    """A joint, from 1, whose zero neither axes nor torques determine."""

    joint: int
    reason: Literal["same line", "tool"]


class OtherAlignmentValue(msgspec.Struct, frozen=True, kw_only=True):
    """Another alignment, and the torques that it would leave apart: RMS in parts of each joint's
    torque, and the largest [N m].
    """

    T_ab: Pose
    signs: Vector
    offsets: Vector
    relative_difference: Number
    torque_difference: Number


class AlignmentValue(OtherAlignmentValue, frozen=True, kw_only=True):
    """How b was aligned with a; `others` make the axes coincide too, the best first; `nearest` all
    but does so, where none does.
    """

    exact: bool
    axis_angle: Vector
    axis_distance: Vector
    tool: Pose
    unknown: list[UndeterminedValue]
    others: list[OtherAlignmentValue]
    nearest: OtherAlignmentValue | None


class OperationsValue(msgspec.Struct, frozen=True):
    """How many operations."""

    multiplications: int
    additions: int
    total: int


def vector(values: object) -> Vector:
    """Numbers of an array or sequence of one dimension."""
    return [float(x) for x in np.asarray(values)]


def pose(transform: Transform) -> Matrix:
    """A pose as a homogeneous matrix, row by row."""
    return [vector(row) for row in transform.matrix()]


def state(values: dict[str, list[float]]) -> State:
    """A state that is given as q, qd and qdd."""
    return State(values["q"], values["qd"], values["qdd"])


def model_value(arm: ArmOrTree) -> Model:
    """What an arm or a robot is called, and where it came from."""
    return msgspec.convert(
        {
            "name": arm.name,
            "label": arm.label,
            "kind": arm.source.kind,
            "base": arm.source.base,
            "tip": arm.source.tip,
            "notes": list(arm.source.notes),
        },
        Model,
    )


def alignment_value(alignment: Alignment) -> AlignmentValue:
    """How b was aligned with a."""
    return AlignmentValue(
        **_alignment(alignment),
        exact=alignment.exact,
        axis_angle=vector(alignment.axis_angle),
        axis_distance=vector(alignment.axis_distance),
        tool=pose(alignment.tool),
        unknown=[UndeterminedValue(each.joint, each.reason) for each in alignment.unknown],
        others=[OtherAlignmentValue(**_alignment(each)) for each in alignment.others],
        nearest=None
        if alignment.nearest is None
        else OtherAlignmentValue(**_alignment(alignment.nearest)),
    )


def _alignment(alignment: Alignment) -> dict[str, Any]:
    return {
        "T_ab": pose(alignment.T_ab),
        "signs": vector(alignment.signs),
        "offsets": vector(alignment.offsets),
        "relative_difference": alignment.relative_difference,
        "torque_difference": alignment.torque_difference,
    }


def inertia_value(inertia: Inertia, tensor_known: bool) -> InertiaValue:
    """Mass, centre and tensor about the centre."""
    tensor = [vector(row) for row in inertia.tensor] if tensor_known else None
    return InertiaValue(float(inertia.mass), vector(inertia.com), tensor)
