"""A link's numbers against its reach, where there is no mesh; and those of the whole arm.

The reach of a link is the distance from its joint to the next one. Its body may extend beyond
either end and to the sides, so a finding here is never "impossible", only "suspicious".
"""

from __future__ import annotations

import numpy as np

from ..._robot.serial_arm import Link, SerialArm
from ..._robot.transforms import Array
from .plausible_body import Plausibility

__all__ = ["reach_findings", "whole_findings"]

#: A reach below this says nothing about a body's size [m].
_SHORT = 0.05

#: How far past its ends a centre of mass may lie, as a share of the reach.  The body of a link with
#: a motor at one end is heaviest there, but its centre lies within the link.
_OVERSHOOT = 0.25

#: Slender: least principal moment under this share of the next.  Such a body points along its
#: reach, or at least not across it (60°).
_SLENDER, _ACROSS = 0.25, float(np.radians(60.0))

#: Moving mass against the cube of the reach [kg/m³].  Similar arms scale so: UR5 11, a small
#: desktop arm about 10, a heavy foundry arm about 150.  Grams for kilograms is a factor of 1,000.
_AIRY, _MASSIVE = 1.0, 500.0

#: Mass of a link against the link that carries it.  Heavier than its carrier is common at the
#: shoulder (UR5: 2.3), five times is not; a hundredth is a wrist on a foundation.
_HEAVIER, _LIGHTER = 5.0, 0.01


def reach_findings(number: int, link: Link) -> list[Plausibility]:
    """Radius of gyration, centre of mass and direction against the vector from joint to joint."""
    reach = link.link_tip_frame.R.T @ link.link_tip_frame.p  # r_{i−1,i}, in frame i
    length = float(np.linalg.norm(reach))
    moments, axes = np.linalg.eigh(link.inertia.tensor)
    if length < _SHORT or moments[0] < 0.0:
        return []
    name = link.name
    findings = []
    k = float(np.sqrt(moments[-1] / link.inertia.mass))
    if k > length:
        sentence = (
            f"{name}: a radius of gyration of {k:.3g} m in a link that reaches {length:.3g} m; "
            "without a mesh, the extent of its body is unknown."
        )
        quantity = "radius of gyration"
        findings.append(
            Plausibility("suspicious", number, name, quantity, k, length, "m", sentence)
        )
    findings += _past_the_ends(number, name, link.inertia.com, reach / length, length)
    slender = moments[1] > 0.0 and moments[0] < _SLENDER * moments[1]
    angle = float(np.arccos(min(1.0, abs(float(axes[:, 0] @ reach)) / length)))
    if slender and angle > _ACROSS:
        sentence = (
            f"{name}: its inertia is that of a slender body that lies {np.degrees(angle):.0f}° "
            f"across the link's own reach of {length:.3g} m, as if the tensor had not been turned "
            "into this frame."
        )
        quantity = "direction of the least moment"
        findings.append(
            Plausibility("suspicious", number, name, quantity, angle, _ACROSS, "rad", sentence)
        )
    return findings


def _past_the_ends(
    number: int, name: str, com: Array, along: Array, length: float
) -> list[Plausibility]:
    station = float(com @ along)  # 0 at the tip frame, −length at the joint
    past = max(station, -length - station)
    bound = max(_OVERSHOOT * length, _SHORT)
    if past <= bound:
        return []
    end = "tip frame" if station > 0.0 else "joint"
    sentence = (
        f"{name}: the centre of mass lies {past:.3g} m beyond the {end} of a link that reaches "
        f"{length:.3g} m."
    )
    return [Plausibility("suspicious", number, name, "centre of mass", past, bound, "m", sentence)]


def whole_findings(arm: SerialArm) -> list[Plausibility]:
    """Total mass against reach, and neighbouring links against each other."""
    findings = []
    total = sum(link.inertia.mass for link in arm.links)
    reach = sum(float(np.linalg.norm(link.link_tip_frame.p)) for link in arm.links)
    if reach >= _SHORT and total > 0.0 and not _AIRY <= total / reach**3 <= _MASSIVE:
        bound = (_AIRY if total / reach**3 < _AIRY else _MASSIVE) * reach**3
        size = "light" if total < bound else "heavy"
        sentence = (
            f"The arm weighs {total:.4g} kg and reaches {reach:.3g} m stretched out: unusually "
            f"{size} for its size; are masses in kilograms and lengths in metres?"
        )
        findings.append(
            Plausibility("suspicious", None, arm.name, "total mass", total, bound, "kg", sentence)
        )
    for number, (carrier, link) in enumerate(zip(arm.links, arm.links[1:], strict=False), 2):
        if min(carrier.inertia.mass, link.inertia.mass) <= 0.0:
            continue
        ratio = link.inertia.mass / carrier.inertia.mass
        if _LIGHTER <= ratio <= _HEAVIER:
            continue
        bound = _HEAVIER if ratio > _HEAVIER else _LIGHTER
        sentence = (
            f"{link.name} weighs {ratio:.3g} times as much as {carrier.name}, which carries it."
        )
        quantity = "mass of neighbours"
        findings.append(
            Plausibility("suspicious", number, link.name, quantity, ratio, bound, "", sentence)
        )
    return findings
