"""A `pin.Model` to a `SerialArm`.

A joint's motion subspace S, one column of (linear, angular), says what the joint does, whatever
class it is of: S = (0, u) turns about u, S = (u, 0) slides along u.  Anything else (a screw, a
ball, a free body) is no joint of a `SerialArm`.
"""

from __future__ import annotations

import hashlib
import math
from typing import Any, NoReturn

import numpy as np

from .._errors import ModelError
from .._robot import Inertia, Joint, Limits, Link, SerialArm, Source, Transform
from .._robot.pseudo_inertia import DigitBounds
from .._robot.transforms import Array
from .inertia_checks import Place, check_inertia
from .suggestions import did_you_mean

__all__ = ["read_pinocchio_model"]

# A model keeps doubles, not the number of digits that they were printed with.  Six significant
# ones is what C++ streams and %g print unless told otherwise: half a unit of the sixth digit is at
# most this part of the number.
_ROUNDING = 5e-6


def read_pinocchio_model(
    model: Any, *, base: str | None = None, tip: str | None = None
) -> SerialArm:
    """The arm that a `pin.Model` holds: all of its joints, one chain, each with one coordinate.

    base : frame fixed to the universe to start from (default: the universe itself)
    tip : frame carried by the last joint to end at (default: the last joint's own frame)

    Continuous joints (JointModelRUBX, …), which take cos and sin for a coordinate in Pinocchio,
    are one angle each here.  Raises ModelError, naming the joint, if the joints are no such chain.
    """
    count = model.njoints - 1
    if count == 0:
        _fail("model", "has no joint", "an arm needs one")
    for i in range(1, count + 1):
        if model.parents[i] != i - 1:
            parent = model.names[model.parents[i]]
            problem = f"hangs on {parent!r}: the joints are not one chain"
            _fail(_named(model, i), problem, "lock the others with pin.buildReducedModel")
    B, base_name = _frame(model, base, 0, "base")
    last, tip_name = _frame(model, tip, count, "tip")
    starts = [_transform(model.jointPlacements[i]) for i in range(1, count + 1)]
    link_tip_frames = [*starts[1:], last]
    joints, links = [], []
    for i, link_tip_frame in enumerate(link_tip_frames, start=1):
        joints.append(_joint(model, i))
        to_link_tip_frame = link_tip_frame.inverse()
        inertia = _inertia(model, i, last=i == count).expressed_in(to_link_tip_frame)
        links.append(Link(_link_name(model, i), link_tip_frame, inertia, to_link_tip_frame))
    to_base = B.inverse()
    digest = hashlib.sha256(model.saveToString().encode()).hexdigest()
    return SerialArm(
        model.name or "model",
        tuple(joints),
        tuple(links),
        base=to_base @ starts[0],
        gravity=to_base.R @ np.asarray(model.gravity.linear),
        source=Source(
            "pinocchio",
            ((f"pin.Model {model.name!r}", digest),),
            model=model,
            base=base_name,
            tip=tip_name,
        ),
    )


def _fail(element: str, problem: str, fix: str, value: object = None) -> NoReturn:
    raise ModelError(problem, fix=fix, file="pin.Model", element=element, value=value)


def _named(model: Any, i: int) -> str:
    return f"joint {model.names[i]!r}"


def _transform(placement: Any) -> Transform:
    return Transform(placement.rotation, placement.translation)


def _frame(model: Any, name: str | None, joint: int, option: str) -> tuple[Transform, str]:
    """Pose of a frame in the joint that carries it, and its name."""
    if name is None:
        return Transform.identity(), str(model.names[joint])
    import pinocchio as pin

    # A fixed joint and a link may share a name; the link is meant, as in a URDF.  It comes last.
    frames = [frame for frame in model.frames if frame.parentJoint == joint]
    frames.sort(key=lambda frame: frame.type == pin.FrameType.BODY)
    carried = {frame.name: frame for frame in frames}
    if name not in carried:
        problem = f"is no frame carried by {model.names[joint]!r}"
        _fail(option, problem, did_you_mean(name, carried), name)
    return _transform(carried[name].placement), name


def _joint(model: Any, i: int) -> Joint:
    axis, kind = _axis(model, i)
    index = model.joints[i].idx_v
    # Continuous joints have position entries too, but they bound cos and sin.
    bounded = model.joints[i].nq == 1
    position = model.joints[i].idx_q
    limits = Limits(
        lower=_finite(model.lowerPositionLimit[position]) if bounded else None,
        upper=_finite(model.upperPositionLimit[position]) if bounded else None,
        velocity=_finite(model.upperVelocityLimit[index]),
        effort=_finite(model.upperEffortLimit[index]),
    )
    motor = (
        float(of[index]) for of in (model.armature, model.damping, model.upperDryFrictionLimit)
    )
    return Joint(model.names[i], axis, kind, limits, *motor)  # type: ignore[arg-type]


def _axis(model: Any, i: int) -> tuple[Array, str]:
    joint = model.joints[i]
    name = joint.shortname()
    fix = "lock it with pin.buildReducedModel, or build the model without it"
    # A composite may hide several joints, a mimic shares another's coordinate: both show one
    # column, and neither is a joint of its own.
    if joint.nv != 1 or "Composite" in name or "Mimic" in name:
        _fail(_named(model, i), f"is a {name}: no revolute or prismatic joint", fix)
    import pinocchio as pin

    data = joint.createData()
    joint.calc(data, pin.neutral(model))
    S = np.asarray(data.S, dtype=np.float64).reshape(6)
    linear, angular = S[:3], S[3:]
    if linear.any() == angular.any():
        _fail(_named(model, i), f"is a {name}: it turns and slides at once", fix)
    axis, kind = (linear, "prismatic") if linear.any() else (angular, "revolute")
    return axis, kind


def _inertia(model: Any, i: int, *, last: bool) -> Inertia:
    body = model.inertias[i]
    tensor = np.asarray(body.inertia)
    place = Place("pin.Model", f"{_named(model, i)} ")
    digits = DigitBounds.of(_ROUNDING * np.abs(tensor))
    check_inertia(body.mass, tensor, place, digits=digits)
    if last and body.mass == 0.0:
        problem = "mass zero on a moving tip: no torque would move it, so its motion is free"
        _fail(f"{_named(model, i)} mass", problem, "give the last body a mass", 0.0)
    return Inertia(body.mass, body.lever, tensor, digits)


def _link_name(model: Any, i: int) -> str:
    """The first body that the joint carries, as a URDF's link of that joint is; else the joint."""
    import pinocchio as pin

    for frame in model.frames:
        if frame.parentJoint == i and frame.type == pin.FrameType.BODY:
            return str(frame.name)
    return str(model.names[i])


def _finite(limit: float) -> float | None:
    # Pinocchio writes "no limit" as infinity or as the largest double.
    return None if math.isinf(limit) or abs(limit) == np.finfo(float).max else float(limit)
