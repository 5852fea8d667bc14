"""A URDF's text to a `SerialArm`.

`check_urdf` refuses what two readers could read differently, `Robot` holds the numbers, and
`assemble` builds the arm from the chain between base and tip.
"""

from __future__ import annotations

import hashlib

from ..._robot import SerialArm, Source
from ..chain_assembly import assemble
from ..model_format import ModelFile
from ..xml.safe_xml import checked_xml
from .urdf_chain import Edge
from .urdf_checks import check_urdf
from .urdf_values import Robot

__all__ = ["read_urdf", "read_urdf_file"]


def read_urdf_file(file: ModelFile) -> SerialArm:
    """The arm in a URDF.  Raises ModelError as `read_urdf` does."""
    return read_urdf(file.data, file=file.label, base=file.base, tip=file.tip)


def read_urdf(
    data: bytes,
    *,
    file: str,
    base: str | None = None,
    tip: str | None = None,
    kind: str = "urdf",
    inputs: tuple[tuple[str, str], ...] | None = None,
) -> SerialArm:
    """The arm between two links of a URDF.

    data : the file's bytes;  file : what errors and reports call it
    base : link to start from, any from which the tip is reached without climbing a moving joint
        (default: the root)
    tip : link to end at (default: the end of the only chain of moving joints)
    kind, inputs : for `Source`, where the text was made from something else (xacro)

    Raises ModelError if the file is faulty, branches where no base and tip choose, or if the chain
    holds a joint that is not one angle or one length of its own.
    """
    text = checked_xml(data, file)
    robot = Robot(check_urdf(text, file), file, lines=kind == "urdf")
    chain = robot.tree.chain(base, tip)
    for edge in chain.moving:
        _refuse_unless_simple(robot, edge)
    parts = assemble(robot, chain)
    return SerialArm(
        robot.name,
        parts.joints,
        parts.links,
        base=parts.base,
        source=Source(
            kind=kind,
            inputs=inputs or ((file, hashlib.sha256(data).hexdigest()),),
            urdf=text.decode("utf-8"),
            base=chain.base,
            tip=chain.tip,
            notes=parts.notes,
        ),
    )


def _refuse_unless_simple(robot: Robot, edge: Edge) -> None:
    """A joint of the chain must have one coordinate, and that its own."""
    if edge.kind in ("planar", "floating"):
        problem = f"is {edge.kind}: neither revolute nor prismatic"
        fix = "choose base= and tip= so that it lies outside the arm"
        robot.fail("joint", edge.joint, "", problem, fix)
    followed = robot.mimicked(edge.joint)
    if followed is not None:
        problem = f"mimics {followed!r}: it has no coordinate of its own"
        robot.fail("joint", edge.joint, "", problem, "choose a tip= before it, or remove <mimic>")
