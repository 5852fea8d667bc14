"""Couplings across the joints of an MJCF model: constraints, tendons, actuators, as plain data.

Actuators give effort limits, and may add the inertia of their motor.  An equality of two joints
that is linear makes one follow the other.  Every other active constraint, and every tendon that
pulls by itself, is named with what it couples.  Run in MuJoCo's process.
"""

from __future__ import annotations

from typing import Any

__all__ = ["couplings", "motors"]


def couplings(spec: Any) -> list[dict[str, Any]]:
    """Every active constraint, and every tendon that pulls by itself.

    what, line : its name and place;  joints, bodies : that it couples
    mimic : [joint, followed joint, factor, offset of their distances from `ref`], or None
    """
    sites = {site.name: site.parent.name for site in spec.sites}
    geoms = {geom.name: geom.parent.name for geom in spec.geoms}
    tied = {tendon.name: _along(tendon, sites, geoms) for tendon in spec.tendons}
    found: list[dict[str, Any]] = []
    for tendon in spec.tendons:
        losses = (tendon.stiffness, tendon.damping, tendon.frictionloss, tendon.armature)
        if any(_any(value) for value in losses):
            joints, bodies = tied[tendon.name]
            found.append(_coupling(f"tendon {tendon.name!r}", tendon.info, joints, bodies))
    for constraint in spec.equalities:
        if not constraint.active:
            continue
        kind = constraint.type.name.removeprefix("mjEQ_").lower()
        names = [name for name in (constraint.name1, constraint.name2) if name]
        joints, bodies, mimic = set[str](), set[str](), None
        if kind == "joint":
            joints = set(names)
            mimic = _mimic(spec, names, [float(c) for c in constraint.data[:5]])
        elif kind == "tendon":
            for name in names:
                more = tied.get(name, (set[str](), set[str]()))
                joints, bodies = joints | more[0], bodies | more[1]
        else:
            by_site = constraint.objtype.name == "mjOBJ_SITE"
            bodies = {sites.get(name, name) if by_site else name for name in names}
            bodies |= {"world"} if len(names) < 2 else set()
        what = f"equality {constraint.name or kind!r}"
        found.append(_coupling(what, constraint.info, joints, bodies, mimic))
    return found


def _coupling(
    what: str, line: str, joints: set[str], bodies: set[str], mimic: list[Any] | None = None
) -> dict[str, Any]:
    return {
        "what": what,
        "line": line,
        "joints": sorted(joints),
        "bodies": sorted(bodies),
        "mimic": mimic,
    }


def _mimic(spec: Any, names: list[str], coefficients: list[float]) -> list[Any] | None:
    """y − y₀ = a₀ + a₁ (x − x₀) + a₂ (x − x₀)² + …, where only a₀ and a₁ are not zero."""
    known = {joint.name: joint.type.name for joint in spec.joints}
    scalar = all(known.get(name) in ("mjJNT_HINGE", "mjJNT_SLIDE") for name in names)
    if len(names) != 2 or names[0] == names[1] or not scalar or any(coefficients[2:]):
        return None
    return [*names, coefficients[1], coefficients[0]]


def motors(spec: Any) -> dict[str, dict[str, Any]]:
    """Of each joint, the sum of all its actuators.

    effort : their largest in both directions, from the actuators and `actuatorfrcrange`; None where
        that is not one number;  line : of the actuator that it comes from, "" for the joint itself
    armature, damping : of the motors, seen through their gears
    """
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
        effort, line = _both_ways(joint.actfrcrange, joint.actfrclimited), ""
        if effort is None and len(at_joint) == 1 and joint.name not in through_tendons:
            effort, line = _strength(at_joint[0]), at_joint[0].info
        found[joint.name] = {
            "effort": effort,
            "line": line,
            "armature": sum(float(a.gear[0] ** 2 * a.armature) for a in at_joint),
            "damping": sum(float(a.gear[0] ** 2 * a.damping[0]) for a in at_joint),
        }
    return found


def _along(tendon: Any, sites: dict[str, str], geoms: dict[str, str]) -> tuple[set[str], set[str]]:
    """Joints and bodies that a tendon passes."""
    joints, bodies = set[str](), set[str]()
    for wrap in tendon.path:
        if wrap.type.name == "mjWRAP_JOINT":
            joints.add(wrap.target.name)
        elif wrap.type.name == "mjWRAP_SITE":
            bodies.add(sites.get(wrap.target.name, ""))
        elif wrap.type.name != "mjWRAP_PULLEY":
            bodies.add(geoms.get(wrap.target.name, ""))
    return joints, bodies


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
