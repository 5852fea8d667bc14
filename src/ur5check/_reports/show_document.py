"""What `show` shows: an arm as it was read, in the frames of its own file."""

from __future__ import annotations

import math

import numpy as np

from .._comparison.alignment import SAME_ANGLE
from .._robot.serial_arm import Joint, SerialArm
from .._robot.transforms import Transform
from .difference_summary import base_in_words
from .document import Column, Document, Row, Section, Table
from .provenance import Provenance, inputs_of
from .wording import MISSING, coordinates, figures

__all__ = ["show_document"]

_KINDS = {
    "dh": "a DH table",
    "urdf": "a URDF",
    "xacro": "a xacro",
    "pinocchio": "a pin.Model",
    "value": "Python",
}


def show_document(arm: SerialArm, *, command: str = "") -> Document:
    """The report of `ur5check show`."""
    source = arm.source
    lines = (
        f"{arm.n} joint{'s' if arm.n > 1 else ''} from {source.base} to {source.tip}, read from "
        f"{_KINDS.get(source.kind, source.kind)}",
        f"gravity {coordinates(arm.gravity)} m/s² in the frame of {source.base}",
        *source.notes,
    )
    return Document(
        arm.name,
        None,
        lines,
        (
            Section("Joints", tables=(_joints(arm),)),
            Section("Geometry", tables=(_geometry(arm),)),
            Section("Bodies", tables=(_bodies(arm), _tensors(arm))),
        ),
        Provenance(inputs_of((arm,)), command=command),
    )


def _joints(arm: SerialArm) -> Table:
    return Table(
        (
            Column("joint"),
            Column("kind"),
            Column("axis"),
            Column("from [° or mm]", number=True),
            Column("to [° or mm]", number=True),
            Column("speed [°/s or mm/s]", number=True),
            Column("effort [N m or N]", number=True),
        ),
        tuple(
            Row(
                (
                    joint.name,
                    joint.kind,
                    coordinates(joint.axis),
                    _position(joint, joint.limits.lower),
                    _position(joint, joint.limits.upper),
                    _position(joint, joint.limits.velocity),
                    figures(joint.limits.known_effort),
                )
            )
            for joint in arm.joints
        ),
        note=f"{MISSING}: the source does not say.",
    )


def _position(joint: Joint, value: float | None) -> str:
    if value is None:
        return MISSING
    return f"{1e3 * value if joint.kind == 'prismatic' else math.degrees(value):.1f}"


def _geometry(arm: SerialArm) -> Table:
    poses = [("base", "first joint", arm.base)]
    poses += [(link.name, "tip frame", link.link_tip_frame) for link in arm.links]
    rows = []
    for of, pose, T in poses:
        turned = Transform(T.R, np.zeros(3))
        turn = (
            base_in_words(turned).removeprefix("turned by ")
            if turned.angle() > SAME_ANGLE
            else MISSING
        )
        rows.append(Row((of, pose, coordinates(T.p, 1e-3), turn)))
    return Table(
        (Column("link"), Column("pose of"), Column("position [mm]"), Column("rotation")),
        tuple(rows),
        note="In the link's frame at its joint, in the joint's zero position; base: in the base "
        "frame.",
    )


def _bodies(arm: SerialArm) -> Table:
    rows = []
    for link in arm.links:
        own = link.inertia.expressed_in(link.source_frame.inverse())
        rows.append(Row((link.name, figures(own.mass), coordinates(own.com))))
    return Table(
        (Column("link"), Column("mass [kg]", number=True), Column("centre of mass [m]")),
        tuple(rows),
        note="Links fixed to a moving link are part of it.",
    )


def _tensors(arm: SerialArm) -> Table:
    entries = (("xx", 0, 0), ("yy", 1, 1), ("zz", 2, 2), ("xy", 0, 1), ("xz", 0, 2), ("yz", 1, 2))
    rows = []
    for link in arm.links:
        own = link.inertia.expressed_in(link.source_frame.inverse())
        cells = (
            figures(float(own.tensor[row, column])) if link.tensor_known else "unknown"
            for _, row, column in entries
        )
        rows.append(Row((link.name, *cells)))
    return Table(
        (Column("link"), *(Column(f"I{name}", number=True) for name, _, _ in entries)),
        tuple(rows),
        title="Tensor about the centre of mass [kg m²]",
        note="Along the axes of the link's frame in the source.",
    )
