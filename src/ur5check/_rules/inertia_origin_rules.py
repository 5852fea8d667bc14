"""INE113–115: numbers that are possible, but were hardly measured or written in their place."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._finding import Finding
from .._robot.robot import Inertial, RobotLink
from .._robot.transforms import Array
from .body_extent import Extent
from .examples import joint, link, robot
from .finding_log import finding_of
from .inertia_measures import (
    is_sound,
    largest_spread,
    metres,
    placeholder,
    subject_of,
)
from .rule import Rule
from .rule_subject import RuleSubject

__all__ = ["RULES"]

#: A link against the heavier of its neighbours.
_HEAVIER = 30.0
#: Least principal moment below this part of the next: slender; more than 60° from the way to the
#: next joint: across it.
_SLENDER, _ACROSS = 0.3, float(np.radians(60.0))
#: A way to the next joint below this says nothing of a link's direction [m].
_SMALLEST_WAY = 0.1


def _placeholder(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        if not inertial.judged.has_tensor or inertial.mass <= 0.0:
            continue
        what = placeholder(inertial)
        diagonal = not inertial.entries["ixy"]
        if what is None or (diagonal and not _not_a_sphere(s, body, inertial)):
            continue
        yield finding_of(
            "INE113",
            subject_of(body),
            f"{what}: a placeholder, not a measured tensor",
            inertial.place("inertia"),
            value=inertial.entries["ixx"],
            unit="kg m²",
        )


def _not_a_sphere(s: RuleSubject, body: RobotLink, inertial: Inertial) -> bool:
    """Whether a ball of that tensor has a size that the link has not."""
    spread, _ = largest_spread(inertial.inertia)
    extent = s.extent(body.name)
    length = s.length(body.name) if extent is None else extent.diameter
    # σ of a ball is its radius over √5, 0.22 of its diameter.
    return not 0.1 * length <= spread <= 0.35 * length


def _across(s: RuleSubject) -> Iterator[Finding]:
    """A slender tensor that lies across the way to the next joint."""
    for body, inertial in s.bodies:
        ways = [one.origin.p for one in s.robot.below[body.name] if np.any(one.origin.p)]
        if not is_sound(inertial) or len(ways) != 1:
            continue
        length = float(np.linalg.norm(ways[0]))
        if length < max(_SMALLEST_WAY, 0.5 * s.length(body.name)):
            continue
        moments, axes = np.linalg.eigh(inertial.inertia.tensor)
        if not moments[0] < _SLENDER * moments[1]:
            continue
        angle = float(np.arccos(min(1.0, abs(float(axes[:, 0] @ ways[0])) / length)))
        extent = s.extent(body.name)
        if angle <= _ACROSS or (
            extent is not None and not _longest_along(extent, ways[0] / length)
        ):
            continue
        yield finding_of(
            "INE114",
            subject_of(body),
            f"its slender tensor lies {np.degrees(angle):.0f}° across the {metres(length)} to the "
            "next joint, as if axes were exchanged or the tensor not rotated into this frame",
            inertial.place("inertia"),
            value=angle,
            bound=_ACROSS,
            unit="rad",
        )


def _longest_along(extent: Extent, direction: Array) -> bool:
    """Whether the shape is longest about along a direction."""
    helper = np.eye(3)[int(np.abs(direction).argmin())]
    second = np.cross(direction, helper)
    second /= np.linalg.norm(second)
    low, high = extent.along(np.array([direction, second, np.cross(direction, second)]))
    lengths = high - low
    return bool(lengths[0] > 1.5 * lengths[1:].max())


def _heavier_than_neighbours(s: RuleSubject) -> Iterator[Finding]:
    masses = {body.name: inertial.mass for body, inertial in s.bodies if inertial.mass > 0.05}
    for body, inertial in s.bodies:
        if body.name not in masses or body.name not in s.moving:
            continue
        above = s.robot.above[body.name].parent
        near = [above, *(one.child for one in s.robot.below[body.name])]
        weights = [masses[name] for name in near if name in masses]
        if weights and masses[body.name] > _HEAVIER * max(weights):
            ratio = masses[body.name] / max(weights)
            yield finding_of(
                "INE115",
                subject_of(body),
                f"weighs {inertial.mass:.4g} kg, {ratio:.3g} times the heavier of its neighbours",
                inertial.place("mass"),
                value=ratio,
                bound=_HEAVIER,
            )


_GOOD = robot()
_WAY = joint("k", parent="arm", child="tip", origin='<origin xyz="0 0 0.4"/>')
_TIP = link("tip", ixx="0.0002", iyy="0.0002", izz="0.0001", mass="0.2")

RULES = (
    Rule(
        "INE113", "placeholder-tensor", "warning",
        "the tensor is not a placeholder",
        "1, 1, 1 or six equal entries are what tutorials write until somebody measures.",
        "torques in motion are those of another body",
        bad=robot(joint(), link(ixx="1", iyy="1", izz="1")), good=_GOOD,
        fix="compute it from the part, or from a box of its size",
        check=_placeholder,
    ),
    Rule(
        "INE114", "tensor-across", "warning",
        "a slender link's small moment lies along it",
        "Entries in another order, or a tensor in the axes of another frame, lie across.",
        "torques in motion are wrong: the long axis is the easy one",
        bad=robot(joint(), link(ixx="0.02", iyy="0.002", izz="0.02", mass="2"), _WAY, _TIP),
        good=robot(joint(), link(ixx="0.02", iyy="0.02", izz="0.002"), _WAY, _TIP),
        fix="check the order of the entries and the frame they are written in (rpy of <origin>)",
        check=_across,
    ),
    Rule(
        "INE115", "heavier-than-neighbours", "warning",
        "a moving link does not outweigh all its neighbours many times",
        "A mass in another unit stands out against those beside it.",
        "gravity torques of all joints before it are wrong",
        bad=robot(joint(), link(), _WAY, link("tip", mass="90")),
        good=robot(joint(), link(), _WAY, _TIP),
        fix="check the unit of the mass",
        check=_heavier_than_neighbours,
    ),
)  # fmt: skip
