"""JNT: joints, their axes, angles, limits and losses."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._finding import Finding
from .._robot.robot import RobotJoint
from .examples import joint, link, robot
from .finding_log import finding_of
from .rule import Rule
from .rule_subject import RuleSubject

__all__ = ["RULES"]

#: |v| of an axis may miss 1 by this: six printed digits.
_UNIT = 1e-4
#: A joint that may turn further either way than this many turns is taken for degrees [turns].
_TURNS = 3.0
#: Angles beyond this have lost their meaning: a double has no digit left behind the point [rad].
_ABSURD = 1e6
_DRIVEN = ("revolute", "continuous", "prismatic")


def _subject(one: RobotJoint) -> str:
    return f"joint {one.name!r}"


def _axis(s: RuleSubject) -> Iterator[Finding]:
    for one in s.robot.joints:
        if one.kind not in (*_DRIVEN, "planar") or not np.isfinite(one.written_axis).all():
            continue
        largest = float(np.abs(one.written_axis).max())
        shown = " ".join(f"{x:g}" for x in one.written_axis)
        if not 1e-100 < largest < 1e100:  # squares leave a double's range
            problem = "zero" if largest == 0.0 else f"({shown}), whose length has no double"
            yield finding_of(
                "JNT101", _subject(one), f"its axis is {problem}", one.at("axis"), value=shown,
                bound=1.0,
            )  # fmt: skip
            continue
        length = largest * float(np.linalg.norm(one.written_axis / largest))
        if abs(length - 1.0) > _UNIT:
            yield finding_of(
                "JNT102", _subject(one), f"its axis ({shown}) has length {length:.6g}, not 1",
                one.at("axis"), value=length, bound=1.0,
            )  # fmt: skip


def _effort_velocity(s: RuleSubject) -> Iterator[Finding]:
    for one in s.robot.joints:
        if one.kind not in _DRIVEN or one.mimic is not None:
            continue
        for key, value in (("effort", one.limits.effort), ("velocity", one.limits.velocity)):
            if value is not None and value < 0.0:
                yield finding_of(
                    "JNT104", _subject(one), f"its {key} limit is negative: {value:g}",
                    one.at(key), value=value, bound=0.0,
                )  # fmt: skip
            elif value == 0.0:
                yield finding_of(
                    "JNT103", _subject(one), f"its {key} limit is 0: by the file it cannot move",
                    one.at(key), value=0.0, bound=0.0,
                )  # fmt: skip


def _range(s: RuleSubject) -> Iterator[Finding]:
    for one in s.robot.joints:
        lower, upper = one.limits.lower, one.limits.upper
        if one.kind not in ("revolute", "prismatic") or lower is None or upper is None:
            continue
        if "limit" not in one.places or not (np.isfinite(lower) and np.isfinite(upper)):
            continue
        span = f"lower {lower:g}, upper {upper:g}"
        if lower > upper:
            yield finding_of(
                "JNT105", _subject(one), f"its limits are swapped: {span}", one.at("lower"),
                one.at("upper"), value=lower, bound=upper,
            )  # fmt: skip
        elif lower == upper:
            missing = "lower" not in one.places and "upper" not in one.places
            why = "lower and upper are left out, which means 0" if missing else span
            yield finding_of(
                "JNT106", _subject(one), f"it cannot move: {why}", one.at("limit"), value=lower,
                bound=upper, severity=None if lower == 0.0 else "note",
            )  # fmt: skip
        elif not lower <= 0.0 <= upper:
            yield finding_of(
                "JNT107", _subject(one), f"its zero lies outside its limits: {span}",
                one.at("lower"), value=0.0, bound=lower if lower > 0.0 else upper,
            )  # fmt: skip


def _degrees(s: RuleSubject) -> Iterator[Finding]:
    for one in s.robot.joints:
        bounds = [b for b in (one.limits.lower, one.limits.upper) if b is not None]
        if one.kind != "revolute" or not bounds or not np.isfinite(bounds).all():
            continue
        largest = max(map(abs, bounds))
        if _TURNS * 2.0 * np.pi < largest <= 720.0 and all(_whole(b) for b in bounds):
            key = "upper" if one.limits.upper == largest else "lower"
            yield finding_of(
                "JNT109", _subject(one),
                f"its limits {min(bounds):g} and {max(bounds):g} rad are "
                f"{largest / (2 * np.pi):.3g} turns: degrees?",
                one.at(key), value=largest, bound=_TURNS * 2.0 * float(np.pi), unit="rad",
            )  # fmt: skip


def _whole(x: float) -> bool:
    return abs(x - round(x)) < 1e-9 or abs(2 * x - round(2 * x)) < 1e-9


def _angles(s: RuleSubject) -> Iterator[Finding]:
    for one in s.robot.joints:
        yield from _angle_of(_subject(one), one.rpy, one.at("origin"))
    for body, inertial in s.bodies:
        yield from _angle_of(f"link {body.name!r} inertial", inertial.rpy, inertial.place("origin"))


def _angle_of(subject: str, rpy: object, place: object) -> Iterator[Finding]:
    angles = np.asarray(rpy, dtype=np.float64)
    largest = float(np.abs(angles).max()) if np.isfinite(angles).all() else 0.0
    shown = " ".join(f"{x:g}" for x in angles)
    if largest > _ABSURD:
        yield finding_of(
            "JNT111", subject, f"rpy {shown} rad: angles so large have no meaning", place,  # type: ignore[arg-type]
            value=largest, bound=_ABSURD, unit="rad",
        )  # fmt: skip
    elif largest > 2.0 * np.pi + 1e-3:
        yield finding_of(
            "JNT110", subject, f"rpy {shown} rad turns more than once: degrees?", place,  # type: ignore[arg-type]
            value=largest, bound=2.0 * float(np.pi), unit="rad",
        )  # fmt: skip


def _losses(s: RuleSubject) -> Iterator[Finding]:
    for one in s.robot.joints:
        for key, value in (("damping", one.damping), ("friction", one.friction)):
            if value < 0.0:
                yield finding_of(
                    "JNT112", _subject(one), f"its {key} is negative: {value:g}", one.at(key),
                    value=value, bound=0.0,
                )  # fmt: skip
        effort, speed = one.limits.effort, one.limits.velocity
        if not effort or not np.isfinite(effort):
            continue
        if one.friction > effort:
            yield finding_of(
                "JNT113", _subject(one),
                f"its friction {one.friction:g} exceeds its effort limit {effort:g}",
                one.at("friction"), value=one.friction, bound=effort,
            )  # fmt: skip
        if speed and np.isfinite(speed) and one.damping * speed > 10.0 * effort:
            yield finding_of(
                "JNT113", _subject(one),
                f"its damping {one.damping:g} takes {one.damping * speed:.3g} at full speed, more "
                f"than ten times its effort limit {effort:g}",
                one.at("damping"), value=one.damping * speed, bound=10.0 * effort,
            )  # fmt: skip


def _mimic(s: RuleSubject) -> Iterator[Finding]:
    for one in s.robot.joints:
        seen = [one.name]
        other = one
        while other.mimic is not None and other.mimic.joint in s.robot.joint:
            other = s.robot.joint[other.mimic.joint]
            if other.name in seen:
                yield finding_of(
                    "JNT114", _subject(one), f"follows itself: {' → '.join([*seen, other.name])}",
                    one.at("mimic"),
                )  # fmt: skip
                break
            seen.append(other.name)
        else:
            if len(seen) > 2:
                yield finding_of(
                    "JNT114", _subject(one),
                    f"follows a joint that follows another: {' → '.join(seen)}", one.at("mimic"),
                    severity="note",
                )  # fmt: skip


def _several_coordinates(s: RuleSubject) -> Iterator[Finding]:
    for one in s.robot.joints:
        if one.kind in ("floating", "planar", "ball"):
            yield finding_of(
                "JNT115", _subject(one), f"is {one.kind}: more than one coordinate", one.place
            )


_GOOD = robot()


def _limit(**values: str) -> str:
    given = {"lower": "-2", "upper": "2", "effort": "20", "velocity": "3"} | values
    return "<limit " + " ".join(f'{k}="{v}"' for k, v in given.items()) + "/>"


RULES = (
    Rule(
        "JNT100", "joint-type", "error",
        "every joint has a type that URDF knows",
        "A joint of an unknown type has no motion.",
        "readers refuse the file or leave the joint out",
        bad=robot(joint(kind="hinge"), link()), good=_GOOD,
        fix="use revolute, continuous, prismatic, fixed, floating or planar",
    ),
    Rule(
        "JNT101", "axis-zero", "error",
        "the axis of a moving joint is not zero",
        "A joint moves along or about its axis.",
        "Pinocchio loads it and computes nan or a dead joint; others refuse the file",
        bad=robot(joint(axis='<axis xyz="0 0 0"/>'), link()), good=_GOOD,
        fix="write the direction in the joint's frame, such as 0 0 1",
        check=_axis,
    ),
    Rule(
        "JNT102", "axis-not-unit", "warning",
        "axes are unit vectors",
        "Some readers normalise an axis, others scale the joint's motion by its length.",
        "joint angles mean different things to different engines",
        bad=robot(joint(axis='<axis xyz="0 0 2"/>'), link()), good=_GOOD,
        fix="write the unit vector",
    ),
    Rule(
        "JNT103", "limit-zero", "warning",
        "effort and velocity limits are not 0",
        "0 is what exporters write for unknown; controllers and simulators take it at its word.",
        "MoveIt and simulators let the joint do nothing",
        bad=robot(joint(limit=_limit(effort="0")), link()), good=_GOOD,
        fix="write the drive's limit; leave the joint continuous if there is none",
        check=_effort_velocity,
    ),
    Rule(
        "JNT104", "limit-negative", "error",
        "effort and velocity limits are not negative",
        "They bound magnitudes.",
        "controllers clip to an empty range",
        bad=robot(joint(limit=_limit(velocity="-3")), link()), good=_GOOD,
        fix="write it positive",
    ),
    Rule(
        "JNT105", "limits-swapped", "error",
        "the lower limit is below the upper",
        "A range whose ends are exchanged is empty.",
        "planners find no path, simulators push the joint out of both limits",
        bad=robot(joint(limit=_limit(lower="2", upper="-2")), link()), good=_GOOD,
        fix="exchange them, and check the sign of the axis",
        check=_range,
    ),
    Rule(
        "JNT106", "limits-equal", "warning",
        "a moving joint can move",
        "lower and upper that are left out are 0 to URDF.",
        "planners hold the joint, MuJoCo ignores such limits",
        bad=robot(joint(limit='<limit effort="1" velocity="1"/>'), link()), good=_GOOD,
        fix="write lower and upper, or type='continuous', or type='fixed'",
    ),
    Rule(
        "JNT107", "zero-outside-limits", "note",
        "the zero position lies within the limits",
        "Tools start at zero and take it for a valid posture.",
        "simulators start with the joint beyond its limit and push it back",
        bad=robot(joint(limit=_limit(lower="1", upper="2")), link()), good=_GOOD,
        fix="start from a posture within the limits",
    ),
    Rule(
        "JNT108", "limit-missing", "error",
        "revolute and prismatic joints have a <limit>",
        "URDF demands it.",
        "urdfdom refuses the file",
        bad=robot(joint(limit=""), link()), good=_GOOD,
        fix="write <limit lower upper effort velocity>, or type='continuous'",
    ),
    Rule(
        "JNT109", "limits-in-degrees", "error",
        "limits are in radians",
        "A revolute joint that turns more than three times either way is a rare cable's dream.",
        "limits never act",
        bad=robot(joint(limit=_limit(lower="-170", upper="170")), link()), good=_GOOD,
        fix="write radians: 170° is 2.967",
        check=_degrees,
    ),
    Rule(
        "JNT110", "angles-in-degrees", "error",
        "rpy is in radians",
        "No frame needs more than one turn.",
        "all that follows stands askew",
        bad=robot(joint(origin='<origin xyz="0 0 0.3" rpy="0 90 0"/>'), link()), good=_GOOD,
        fix="write radians: 90° is 1.5707963267948966",
        check=_angles,
    ),
    Rule(
        "JNT111", "angle-without-meaning", "error",
        "angles are small enough to mean something",
        "At 1e16 rad and beyond, neighbouring numbers lie more than a turn apart.",
        "every library reduces such an angle to another one",
        bad=robot(joint(origin='<origin rpy="0 1e22 0"/>'), link()), good=_GOOD,
        fix="write the angle between -π and π",
    ),
    Rule(
        "JNT112", "loss-negative", "error",
        "damping and friction are not negative",
        "A bearing takes energy.",
        "simulations gain energy and diverge",
        bad=robot(joint(more='<dynamics damping="-1"/>'), link()), good=_GOOD,
        fix="write it positive",
        check=_losses,
    ),
    Rule(
        "JNT113", "loss-beyond-effort", "warning",
        "friction and damping leave the drive something to move with",
        "A drive that cannot overcome its own bearing does not move.",
        "the joint stands still or creeps in simulation",
        bad=robot(joint(more='<dynamics friction="50"/>'), link()), good=_GOOD,
        fix="check the unit and the value",
    ),
    Rule(
        "JNT114", "mimic-chain", "error",
        "a followed joint has a coordinate of its own",
        "Readers resolve one step of <mimic> only.",
        "joints of a chain or loop stay still in some readers",
        bad=robot(joint(more='<mimic joint="k"/>'), link(),
                  joint("k", parent="arm", child="tip", more='<mimic joint="j"/>'), link("tip")),
        good=_GOOD,
        fix="let every joint follow the one that is driven",
        check=_mimic,
    ),
    Rule(
        "JNT115", "several-coordinates", "note",
        "every joint has one coordinate",
        "Arms and trees are computed on a fixed base, with one angle or length a joint.",
        "an arm or tree with this joint is not computed",
        bad=robot(joint(kind="floating", axis="", limit=""), link()), good=_GOOD,
        fix="choose --base and --tip beside it",
        check=_several_coordinates,
    ),
)  # fmt: skip
