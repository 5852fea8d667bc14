"""Couplings across the joints of an MJCF model: constraints, tendons, actuators.

The joints of a serial chain are independent. A constraint or tendon that couples one of them to
another body is refused; one between bodies that do not move relative to each other, as in a locked
gripper, has no effect. Actuators give effort limits, and may add the inertia of their motor.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ..._errors import ModelError
from ..urdf.urdf_chain import Chain
from .mjcf_bodies import Bodies
from .mjcf_text import MjcfText

__all__ = ["Coupling", "Motor", "couplings", "motors", "refuse_couplings"]

_FIX = "choose base= and tip= so that it lies outside the arm, or remove it"


@dataclass(frozen=True)
class Coupling:
    """A constraint or tendon.  joints, bodies : those that it couples."""

    what: str
    place: tuple[str, int | None]
    joints: frozenset[str]
    bodies: frozenset[str]


@dataclass(frozen=True)
class Motor:
    """The sum of all actuators of one joint.

    effort : their largest effort in both directions; None where that is not one number
    armature, damping : of the motors, seen through their gears
    """

    effort: float | None
    armature: float
    damping: float


def couplings(spec: Any, text: MjcfText) -> list[Coupling]:
    """Every active constraint, and every tendon that pulls by itself."""
    sites = {site.name: site.parent.name for site in spec.sites}
    geoms = {geom.name: geom.parent.name for geom in spec.geoms}
    tied = {tendon.name: _along(tendon, sites, geoms) for tendon in spec.tendons}
    found = []
    for tendon in spec.tendons:
        losses = (tendon.stiffness, tendon.damping, tendon.frictionloss, tendon.armature)
        if any(_any(value) for value in losses):
            what = f"tendon {tendon.name!r}"
            found.append(Coupling(what, text.place(tendon.info), *tied[tendon.name]))
    for constraint in spec.equalities:
        if not constraint.active:
            continue
        kind = constraint.type.name.removeprefix("mjEQ_").lower()
        names = [name for name in (constraint.name1, constraint.name2) if name]
        joints: frozenset[str] = frozenset()
        bodies: frozenset[str] = frozenset()
        if kind == "joint":
            joints = frozenset(names)
        elif kind == "tendon":
            for name in names:
                more = tied.get(name, (frozenset(), frozenset()))
                joints, bodies = joints | more[0], bodies | more[1]
        else:
            by_site = constraint.objtype.name == "mjOBJ_SITE"
            bodies = frozenset(sites.get(name, name) if by_site else name for name in names)
            bodies |= frozenset(["world"] if len(names) < 2 else [])
        what = f"equality {constraint.name or kind!r}"
        found.append(Coupling(what, text.place(constraint.info), joints, bodies))
    return found


def refuse_couplings(found: list[Coupling], bodies: Bodies, chain: Chain) -> None:
    """Raise ModelError for the first that couples a joint of the chain, or two of its links."""
    moving = {edge.joint for edge in chain.moving}
    carrier: dict[str, str] = {}
    for edge in chain.moving:
        carrier[edge.child] = edge.joint
        for rigid in bodies.tree.rigid_group(edge.child, chain):
            carrier[rigid.child] = edge.joint
    for coupling in found:
        tied = sorted(coupling.joints & moving)
        groups = {carrier.get(body, "") for body in coupling.bodies}
        if tied or len(groups) > 1:
            named = tied or sorted(groups - {""})
            shown = ", ".join(map(repr, named))
            file, line = coupling.place
            raise ModelError(
                f"acts on the arm's joints beside their own motion ({shown}): no serial chain",
                fix=_FIX,
                file=file,
                line=line,
                element=coupling.what,
            )


def motors(spec: Any) -> dict[str, Motor]:
    """Efforts and motor inertias of each joint, from actuators and `actuatorfrcrange`."""
    through_tendons = {
        wrap.target.name
        for tendon in spec.tendons
        for wrap in tendon.path
        if wrap.type.name == "mjWRAP_JOINT"
    }
    found = {}
    for joint in spec.joints:
        at_joint = [
            actuator
            for actuator in spec.actuators
            if actuator.target == joint.name and "JOINT" in actuator.trntype.name
        ]
        effort = _both_ways(joint.actfrcrange, joint.actfrclimited)
        if effort is None and len(at_joint) == 1 and joint.name not in through_tendons:
            effort = _strength(at_joint[0])
        found[joint.name] = Motor(
            effort,
            sum(float(a.gear[0] ** 2 * a.armature) for a in at_joint),
            sum(float(a.gear[0] ** 2 * a.damping[0]) for a in at_joint),
        )
    return found


def _along(tendon: Any, sites: dict[str, str], geoms: dict[str, str]) -> tuple[Any, Any]:
    """Joints and bodies that a tendon passes."""
    joints, bodies = set(), set()
    for wrap in tendon.path:
        if wrap.type.name == "mjWRAP_JOINT":
            joints.add(wrap.target.name)
        elif wrap.type.name == "mjWRAP_SITE":
            bodies.add(sites.get(wrap.target.name, ""))
        elif wrap.type.name != "mjWRAP_PULLEY":
            bodies.add(geoms.get(wrap.target.name, ""))
    return frozenset(joints), frozenset(bodies)


def _any(value: Any) -> bool:
    return bool(value.any()) if hasattr(value, "any") else bool(value)


def _strength(actuator: Any) -> float | None:
    """The largest force of an actuator at its joint, where its bounds are symmetric."""
    gear = abs(float(actuator.gear[0]))
    force = _both_ways(actuator.forcerange, actuator.forcelimited)
    if force is not None:
        return gear * force
    is_motor = (
        actuator.gaintype.name == "mjGAIN_FIXED"
        and actuator.biastype.name == "mjBIAS_NONE"
        and actuator.dyntype.name == "mjDYN_NONE"
    )
    control = _both_ways(actuator.ctrlrange, actuator.ctrllimited)
    if not is_motor or control is None:
        return None
    return gear * abs(float(actuator.gainprm[0])) * control


def _both_ways(bounds: Any, limited: Any) -> float | None:
    lower, upper = (float(bound) for bound in bounds)
    # MJCF: "auto" means limited as soon as a range is written.
    if getattr(limited, "name", "") == "mjLIMITED_FALSE" or limited == 0:
        return None
    return upper if lower == -upper and upper > 0.0 else None
