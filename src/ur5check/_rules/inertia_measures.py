"""How far the mass of a body spreads, what a finding about it weighs, and how numbers are shown.

Of a body with mass m, centre c and tensor I about c, the spread along a unit vector u is

    σ_u = √(uᵀ Σ u / m),   Σ = ½ tr(I) 1 − I,

the root mean square distance of its mass from the plane through c across u.  It compares with
lengths directly: a rod of length l has 0.29 l along itself, and no body of extent l exceeds l/2.
"""

from __future__ import annotations

import numpy as np

from .._finding import Severity
from .._robot.inertia import Inertia
from .._robot.robot import Inertial, RobotLink
from .._robot.transforms import Array
from .rule_subject import RuleSubject

__all__ = [
    "axis_text",
    "is_sound",
    "largest_spread",
    "metres",
    "placeholder",
    "size_severity",
    "spreads",
    "subject_of",
]


def spreads(inertia: Inertia, directions: Array) -> Array:
    """σ² along each row of `directions`, shape (k,) [m²]; negative where I is no body's."""
    sigma = np.trace(inertia.tensor) / 2.0 * np.eye(3) - inertia.tensor
    return np.asarray(np.einsum("ki,ij,kj->k", directions, sigma, directions) / inertia.mass)


def is_sound(inertial: Inertial) -> bool:
    """Whether the size rules have something to say: a mass, and a tensor that some body has."""
    judged = inertial.judged
    return inertial.mass > 0.0 and judged.has_tensor and judged.fault is None


def largest_spread(inertia: Inertia) -> tuple[float, Array]:
    """The largest σ [m] and its direction."""
    sigma = np.trace(inertia.tensor) / 2.0 * np.eye(3) - inertia.tensor
    values, vectors = np.linalg.eigh(sigma)
    return float(np.sqrt(max(0.0, values[2]) / inertia.mass)), vectors[:, 2]


def placeholder(inertial: Inertial) -> str | None:
    """What of a tensor looks as if somebody had typed it instead of measuring, None if nothing."""
    entries = inertial.entries
    moments = {entries["ixx"], entries["iyy"], entries["izz"]}
    products = {entries["ixy"], entries["ixz"], entries["iyz"]}
    value = entries["ixx"]
    if len(moments) > 1 or value <= 0.0:
        return None
    if products == moments:
        return f"all six entries are {value:g}"
    rounded = float(f"{value:.0e}")
    if products == {0.0} and f"{value:.0e}"[0] in "15" and abs(value - rounded) < 1e-12 * value:
        return f"all three moments are {value:g} kg m²"
    return None


def subject_of(body: RobotLink) -> str:
    return f"link {body.name!r}"


def size_severity(
    s: RuleSubject, body: RobotLink, inertial: Inertial, grave: bool
) -> Severity | None:
    """An error only where it matters: dummies of sensors, and bases that stand, are warnings.

    The scale is M R², the inertia that the robot would have with all its mass at its reach.
    """
    scale = s.robot.mass * max(s.reach, 0.1) ** 2
    part = float(np.abs(inertial.own_tensor).max()) / scale if scale > 0.0 else 1.0
    heavy = inertial.mass / s.robot.mass if s.robot.mass > 0.0 else 1.0
    least_part, least_mass = (1e-4, 0.01) if body.name in s.moving else (1e-2, 0.5)
    return None if grave and (part > least_part or heavy > least_mass) else "warning"


def metres(length: float) -> str:
    return f"{length:.3g} m" if length >= 0.1 else f"{1e3 * length:.3g} mm"


def axis_text(u: Array) -> str:
    k = int(np.abs(u).argmax())
    if abs(u[k]) > 0.999:
        return "xyz"[k]
    return f"({', '.join(f'{x:.2f}' for x in u)})"
