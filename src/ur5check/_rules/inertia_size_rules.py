"""INE108–112: masses, centres and tensors that no body of the link's size has."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._finding import Finding
from .._robot.inertia import Inertia
from .._robot.robot import Inertial, RobotLink
from .._robot.transforms import Array
from .examples import joint, link, robot
from .finding_log import finding_of
from .inertia_measures import (
    axis_text,
    is_sound,
    largest_spread,
    metres,
    placeholder,
    size_severity,
    spreads,
    subject_of,
)
from .rule import Rule
from .rule_subject import RuleSubject

__all__ = ["RULES"]

#: A shape may be smaller than the body that it shows: covers, screws, coarse boxes [m].
SHAPE_MARGIN = 0.01
#: Times the largest spread squared that a shape allows, from which no coarse shape explains it.
_FAR_BEYOND = 4.0
#: Spread against a link's length: beyond the first no link of a robot is, beyond the second none
#: can be that moves with the others (all mass at the ends of a rod has half its length).
_WIDE, _IMPOSSIBLE = 1.0, 3.0
#: Below this part of a link's length all mass is in one point: a tensor in a smaller unit.
_POINT = 0.01
#: Denser than copper (8,960 kg/m³) is a mistake; twice as dense as tungsten is impossible.
DENSE, IMPOSSIBLY_DENSE = 9000.0, 40000.0
#: Lighter than balsa wood (150 kg/m³) by a factor of ten.
_LIGHT = 15.0
#: Masses up to this are written for dummies of frames and sensors: no density is meant [kg].
_DUMMY_MASS = 0.01
#: Units that tensors and masses are found in: factor to kg m² or kg.
_TENSOR_UNITS = (
    (1e9, "g mm²"),
    (1e7, "g cm²"),
    (1e6, "kg mm²"),
    (1e4, "kg cm²"),
    (1e3, "g m²"),
    (3417.17, "lb in²"),
    (23.7304, "lb ft²"),
    (144.0, "a unit with inches for feet"),
)
_PLAUSIBLE_SPREAD = (0.03, 0.8)  # of a link's length


def _directions(inertia: Inertia, body: RobotLink) -> Array:
    """Where the bound is tried: the link's axes, its shapes' axes, the principal axes."""
    _, principal = np.linalg.eigh(inertia.tensor)
    frames = [np.eye(3), principal.T, *(shape.pose.R.T for shape in body.shapes)]
    return np.concatenate(frames)


def _beyond_shape(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        extent = s.extent(body.name) if is_sound(inertial) else None
        if extent is None:
            continue
        inertia = inertial.inertia
        directions = _directions(inertia, body)
        low, high = extent.along(directions)
        along = directions @ inertia.com
        # A centre outside the shape has a rule of its own; here it is brought to the surface.
        along = np.clip(along, low, high)
        allowed = (along - low + SHAPE_MARGIN) * (high - along + SHAPE_MARGIN)
        squares = spreads(inertia, directions)
        ratio = squares / allowed
        worst = int(ratio.argmax())
        if ratio[worst] > 1.0:
            yield finding_of(
                "INE108",
                subject_of(body),
                f"mass spreads {metres(np.sqrt(squares[worst]))} along "
                f"{axis_text(directions[worst])}, {np.sqrt(ratio[worst]):.3g} times what its shape "
                f"allows ({metres(np.sqrt(allowed[worst]))})"
                + _unit_hint(s, body, inertial, float(np.sqrt(ratio[worst]))),
                inertial.place("inertia"),
                value=float(np.sqrt(squares[worst])),
                bound=float(np.sqrt(allowed[worst])),
                unit="m",
                severity=size_severity(s, body, inertial, bool(ratio[worst] > _FAR_BEYOND)),
            )


def _beyond_length(s: RuleSubject) -> Iterator[Finding]:
    """Where no shape says how large the link is: its length, and the robot's reach."""
    for body, inertial in s.bodies:
        if not is_sound(inertial) or s.extent(body.name) is not None:
            continue
        spread, direction = largest_spread(inertial.inertia)
        length = s.longest(body.name)
        if spread <= _WIDE * length:
            continue
        grave = spread > _IMPOSSIBLE * length and spread > 0.5 * s.reach
        yield finding_of(
            "INE109",
            subject_of(body),
            f"mass spreads {metres(spread)} along {axis_text(direction)} in a link of "
            f"{metres(length)}" + _unit_hint(s, body, inertial, 2.0 * spread / length),
            inertial.place("inertia"),
            value=spread,
            bound=_WIDE * length,
            unit="m",
            severity=size_severity(s, body, inertial, grave),
        )


def _like_a_point(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        if not is_sound(inertial) or inertial.mass < 0.01:
            continue
        spread, _ = largest_spread(inertial.inertia)
        extent = s.extent(body.name)
        length = s.length(body.name) if extent is None else extent.diameter
        if spread < _POINT * length:
            yield finding_of(
                "INE110",
                subject_of(body),
                f"mass spreads only {metres(spread)} in a link of {metres(length)}, as if all of "
                "it lay in one point" + _unit_hint(s, body, inertial, np.inf),
                inertial.place("inertia"),
                value=spread,
                bound=_POINT * length,
                unit="m",
            )


def _unit_hint(s: RuleSubject, body: RobotLink, inertial: Inertial, excess: float) -> str:
    """The units that would make the spread plausible, if some do.

    excess : times what a body of the link's size has; little excess has other reasons
    """
    if excess < 2.0:
        return ""
    if (what := placeholder(inertial)) is not None:
        return f"; {what}: a placeholder"
    spread, _ = largest_spread(inertial.inertia)
    length = s.length(body.name)
    low, high = (part * length for part in _PLAUSIBLE_SPREAD)
    found = [name for factor, name in _TENSOR_UNITS if low <= spread / np.sqrt(factor) <= high]
    if found:
        return f"; as if the tensor were in {' or '.join(found[:3])}"
    if low <= spread / np.sqrt(1e-3) <= high:
        return "; as if the mass were in g, or the tensor a thousandth"
    return ""


def _density(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        if inertial.mass <= _DUMMY_MASS:
            continue
        extent = s.extent(body.name)
        if extent is not None and extent.most_volume > 0.0:
            volume, of = extent.most_volume, "its shape"
        else:
            # A ball around the link: what no link fills, let alone with metal.
            radius = s.longest(body.name) / 2.0 + 0.05
            volume, of = float(4.0 / 3.0 * np.pi * radius**3), "a ball as long as the link"
        density = inertial.mass / volume
        light = extent is not None and density < _LIGHT
        if density <= DENSE and not light:
            continue
        bound = DENSE if density > DENSE else _LIGHT
        comparison = "denser than copper" if density > DENSE else "lighter than foam"
        yield finding_of(
            "INE111",
            subject_of(body),
            f"{inertial.mass:.4g} kg in the {1e3 * volume:.3g} litres of {of}: "
            f"{density:,.3g} kg/m³, {comparison}",
            inertial.place("mass"),
            value=density,
            bound=bound,
            unit="kg/m³",
            severity=size_severity(s, body, inertial, density > IMPOSSIBLY_DENSE),
        )


def _far_centre(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        if inertial.mass <= 0.0 or s.extent(body.name) is not None:
            continue
        distance = float(np.linalg.norm(inertial.xyz))
        length = s.longest(body.name)
        if distance <= 1.5 * length + 0.1:
            continue
        grave = distance > 3.0 * length and distance > s.reach
        yield finding_of(
            "INE112",
            subject_of(body),
            f"the centre of mass lies {metres(distance)} from the joint of a link of "
            f"{metres(length)}",
            inertial.place("origin"),
            value=distance,
            bound=1.5 * length + 0.1,
            unit="m",
            severity=size_severity(s, body, inertial, grave),
        )


_GOOD = robot()
_BOX = (
    '<collision><origin xyz="0 0 0.1"/><geometry><box size="0.1 0.1 0.25"/></geometry></collision>'
)
_FAR = (
    '<inertial><origin xyz="0 20 310"/><mass value="2"/>'
    '<inertia ixx="0.008" ixy="0" ixz="0" iyy="0.008" iyz="0" izz="0.002"/></inertial>'
)

RULES = (
    Rule(
        "INE108", "inertia-beyond-shape", "error",
        "mass does not spread further than the link's own shape allows: σ² ≤ (c − low)(high − c)",
        "A body inside its shape with its centre there cannot be harder to turn.",
        "accelerations are too small, controllers that use the model push too hard",
        bad=robot(joint(), link(ixx="0.5", iyy="0.5", shapes=_BOX)),
        good=robot(joint(), link(shapes=_BOX)),
        fix="compare unit and frame of the tensor with the CAD export, and the shape with the part",
        report="Wensing, Kim & Slotine 2018",
        check=_beyond_shape,
    ),
    Rule(
        "INE109", "inertia-beyond-length", "error",
        "without a shape: mass does not spread beyond the link's length, nor the robot's reach",
        "Tensors in g mm² or of a placeholder give a hand the inertia of a building.",
        "accelerations are far too small; simulation hardly moves",
        bad=robot(joint(), link(ixx="80", iyy="80", izz="80")), good=_GOOD,
        fix="give the tensor in kg m², about the centre of mass",
        check=_beyond_length,
    ),
    Rule(
        "INE110", "inertia-of-a-point", "warning",
        "mass does not lie in one point of the link",
        "A tensor in a larger unit than meant, or of a much lighter part, is as good as none.",
        "the link turns almost freely: simulation gets stiff, small steps are needed",
        bad=robot(joint(), link(ixx="1e-7", iyy="1e-7", izz="1e-7")), good=_GOOD,
        fix="give the tensor in kg m², about the centre of mass",
        check=_like_a_point,
    ),
    Rule(
        "INE111", "density", "error",
        "mass and size of a link go together",
        "Masses in grams, or of the whole robot in one link, show as density.",
        "gravity torques are wrong by the same factor",
        bad=robot(joint(), link(mass="2000", shapes=_BOX)),
        good=robot(joint(), link(shapes=_BOX)),
        fix="give the mass in kilograms, of this part",
        check=_density,
    ),
    Rule(
        "INE112", "far-centre", "error",
        "without a shape: the centre of mass lies near the link",
        "Centres in millimetres lie hundreds of metres away.",
        "gravity torques are wrong by the same factor",
        bad=robot(joint(), link(inertial=_FAR)),
        good=_GOOD,
        fix="give the centre in metres, in the link's frame",
        check=_far_centre,
    ),
)  # fmt: skip
