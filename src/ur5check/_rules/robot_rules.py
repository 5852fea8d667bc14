"""ROB: the robot as a whole."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from .._dynamics.equations import gravity_torque
from .._finding import Finding
from .._robot.inertia import Inertia
from .._robot.robot import Inertial
from .._robot.serial_arm import SerialArm
from .._robot.states import random_states
from .examples import joint, link, robot
from .finding_log import finding_of
from .rule import Rule
from .rule_subject import RuleSubject

__all__ = ["RULES", "worst_holding_torque"]

#: CAD programs' default densities [kg/m³] and how close a link must come.
_DEFAULTS = {7850.0: "steel", 7860.0: "steel", 7870.0: "iron", 1000.0: "water", 2700.0: "aluminium"}
_SAME_DENSITY = 0.01
#: Two numbers of a left and a right limb that agree to this are meant to be equal.
_SAME = 1e-3
_POSTURES, _SEED = 2000, 0
#: Words for the two sides, as names of links spell them.
_SIDES = (("left", "right"), ("Left", "Right"), ("LEFT", "RIGHT"), ("l", "r"), ("L", "R"))


def _expected_mass(s: RuleSubject) -> Iterator[Finding]:
    if s.expected_mass is None:
        return
    mass, expected = s.robot.mass, s.expected_mass
    if abs(mass - expected) > 0.05 * expected:
        yield finding_of(
            "ROB101", "robot", f"weighs {mass:.4g} kg, {mass / expected:.3g} times the "
            f"{expected:.4g} kg expected", value=mass, bound=expected, unit="kg",
        )  # fmt: skip


def _default_density(s: RuleSubject) -> Iterator[Finding]:
    densities = []
    for body, inertial in s.bodies:
        extent = s.extent(body.name)
        if extent is not None and inertial.mass > 0.05 and body.name in s.moving:
            densities.append(inertial.mass / extent.volume)
    if len(densities) < 3:
        return
    middle = float(np.median(densities))
    same = [d for d in densities if abs(d - middle) <= _SAME_DENSITY * middle]
    if len(same) < max(3, 0.8 * len(densities)):
        return
    near = [name for d, name in _DEFAULTS.items() if abs(d - middle) <= _SAME_DENSITY * d]
    what = f" ({near[0]})" if near else ""
    yield finding_of(
        "ROB102",
        "robot",
        f"{len(same)} of {len(densities)} moving links have one density, {middle:,.0f} kg/m³"
        f"{what}: computed from solid shapes, not weighed",
        value=middle,
        unit="kg/m³",
    )


def _other_side(name: str, names: set[str]) -> str | None:
    for one, other in _SIDES:
        if len(one) > 1:
            found = [name.replace(one, other, 1)] if one in name else []
        else:
            found = [
                re.sub(pattern, rf"\g<1>{other}\g<2>", name, count=1)
                for pattern in (
                    rf"(^|_){one}(_|$)",
                    rf"(^){one}(?=[A-Z0-9])()",
                    rf"()(?<=[a-z0-9]){one}($)",
                )
                if re.search(pattern, name)
            ]
        for candidate in found:
            if candidate != name and candidate in names:
                return candidate
    return None


def _mirrored(s: RuleSubject) -> Iterator[Finding]:
    """Left and right: equal masses; equal tensors up to the signs of two products."""
    bodies = {body.name: inertial for body, inertial in s.bodies if inertial.mass > 0.0}
    names = set(bodies)
    for left, one in bodies.items():
        right = _other_side(left, names)
        if right is None or _in_one_chain(s, left, right):
            continue
        other = bodies[right]
        if abs(one.mass - other.mass) > _SAME * max(one.mass, other.mass):
            problem = f"weighs {one.mass:.4g} kg, {right!r} {other.mass:.4g} kg"
            value, bound, part = one.mass, other.mass, "mass"
        elif (gap := _mirror_gap(one, other)) > 0.01:
            problem = f"its tensor is no mirror image of that of {right!r}: {gap:.0%} apart"
            value, bound, part = gap, 0.01, "inertia"
        else:
            continue
        yield finding_of(
            "ROB103", f"link {left!r}", problem, one.place(part), other.place(part), value=value,
            bound=bound,
        )  # fmt: skip


def _in_one_chain(s: RuleSubject, one: str, other: str) -> bool:
    """Whether one of two links carries the other: then they are no pair, whatever their names."""
    return other in s.robot.down(one) or one in s.robot.down(other)


def _mirror_gap(one: Inertial, other: Inertial) -> float:
    """The least relative distance of principal moments: what any mirror image keeps."""
    a, b = (np.linalg.eigvalsh(x.own_tensor) for x in (one, other))
    size = max(float(np.abs(a).max()), float(np.abs(b).max()))
    return float(np.abs(a - b).max()) / size if size > 0.0 else 0.0


def worst_holding_torque(arm: SerialArm) -> tuple[np.ndarray, np.ndarray]:
    """The largest |gravity torque| of each joint over random postures within the limits, and the
    posture of each: at least so much is needed.  Shapes (n,) [N m] or [N], and (n, n)."""
    states = random_states(arm.n, _POSTURES, _SEED)
    q = np.array(states.q)
    for i, one in enumerate(arm.joints):
        low, high = one.limits.lower, one.limits.upper
        if low is not None and high is not None and low < high and np.isfinite([low, high]).all():
            span = (q[:, i] - q[:, i].min()) / float(np.ptp(q[:, i]))
            q[:, i] = low + span * (high - low)
    torque = np.abs(gravity_torque(arm, q))
    return torque.max(axis=0), q[torque.argmax(axis=0)]


def _with_payload(arm: SerialArm, mass: float) -> SerialArm:
    """The arm with a point mass [kg] at its tip."""
    if mass == 0.0:
        return arm
    held = Inertia(mass, np.zeros(3), np.zeros((3, 3)))
    inertias = [link.inertia for link in arm.links]
    return arm.with_inertias([*inertias[:-1], inertias[-1] + held])


def _holding_torque(s: RuleSubject) -> Iterator[Finding]:
    if s.arm is None:
        return
    torque, posture = worst_holding_torque(_with_payload(s.arm, s.payload))
    for i, one in enumerate(s.arm.joints):
        effort = one.limits.effort
        if not effort or not np.isfinite(effort) or torque[i] <= effort:
            continue
        file_joint = s.robot.joint[one.name]
        at = ", ".join(f"{x:.2f}" for x in posture[i])
        with_payload = f" with {s.payload:g} kg at the tip" if s.payload else ""
        yield finding_of(
            "ROB104",
            f"joint {one.name!r}",
            f"holding the arm still{with_payload} takes at least {torque[i]:.4g} N m at "
            f"({at}), {torque[i] / effort:.4g} times its effort limit {effort:g}",
            file_joint.at("effort"),
            value=float(torque[i]),
            bound=effort,
            unit="N m" if one.kind == "revolute" else "N",
            effect=float(torque[i]),
        )


_GOOD = robot()
_LIMBS = (
    joint("jl", child="left_arm"), link("left_arm"), joint("jr", child="right_arm"),
)  # fmt: skip


RULES = (
    Rule(
        "ROB101", "total-mass", "error",
        "the robot weighs what was expected (--expect-mass), to 5 %",
        "The data sheet's mass is the number that most users can check.",
        "all torques are wrong",
        bad="a robot of 20.6 kg where 18.4 kg were expected", good="a robot of 18.5 kg there",
        fix="compare the links' masses with the data sheet: is a link missing, or counted twice?",
        check=_expected_mass,
        example="words",
    ),
    Rule(
        "ROB102", "one-density", "warning",
        "links have densities of their own",
        "Motors, gears, covers and cables never give each link one density: these masses are a CAD "
        "program's default.",
        "masses and tensors are guesses, mostly too heavy",
        bad="six links of 7,850 kg/m³ each", good="links between 1,200 and 3,100 kg/m³",
        fix="weigh the links, or take the maker's masses",
        check=_default_density,
        example="words",
    ),
    Rule(
        "ROB103", "limbs-not-mirrored", "warning",
        "left and right limbs are mirror images",
        "Two sides are built alike; a number that differs is a mistake on one side.",
        "the robot leans, gaits and dual-arm motions are asymmetric",
        bad=robot(*_LIMBS, link("right_arm", mass="3")), good=robot(*_LIMBS, link("right_arm")),
        fix="compare the two, and correct one",
        check=_mirrored,
    ),
    Rule(
        "ROB104", "effort-below-weight", "warning",
        "effort limits hold the arm up in every posture",
        "A drive that cannot hold the arm is wrongly described, or the arm is too heavy.",
        "the arm sinks in simulation; controllers saturate",
        bad=robot(joint(limit='<limit lower="-2" upper="2" effort="1" velocity="3"/>'), link()),
        good=_GOOD,
        fix="check the effort limit, its unit (N m at the joint, not at the motor), and the masses",
        check=_holding_torque,
    ),
)  # fmt: skip
