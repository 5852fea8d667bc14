"""Checks of numbers: could these bodies exist, is every difference of two arms explained?"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._comparison.alignment import SAME_ANGLE, SAME_LENGTH
from .._comparison.difference import Difference
from .._engines.engine import Engine
from .._robot.pseudo_inertia import Fault
from .._robot.transforms import Array
from .law import Check, Measurement, Tolerance
from .law_subject import Subject

__all__ = ["BODIES", "PAIRS", "PairSubject"]


@dataclass(frozen=True, eq=False)
class PairSubject:
    """Two arms that were compared, and an engine for each.

    recursion : our dynamics with arm a;  reference : another engine with arm b as it was given
    """

    difference: Difference
    recursion: Engine
    reference: Engine


def _bodies(s: Subject) -> Measurement:
    """How far each link is from a body of positive density beyond what printed digits allow, as a
    part of its largest moment; 0 for a body that could exist."""
    values, details = [], []
    for link in s.arm.links:
        body = link.inertia.judged()
        beyond = {
            None: 0.0,
            "mass-negative": -body.mass,
            "mass-zero": 1.0,
            "not-positive-definite": -float(body.moments[0]) - body.moment_tolerance,
            "triangle-inequality": -body.margin - body.margin_tolerance,
        }[body.fault]
        of_tensor = body.fault in ("not-positive-definite", "triangle-inequality")
        values.append(beyond / body.largest if of_tensor else beyond)
        if body.fault is not None:  # also where all three moments are zero within their digits
            values[-1] = max(values[-1], float(np.finfo(np.float64).eps))
        verdict = "a body that could exist" if body.fault is None else _FAULTS[body.fault]
        details.append(
            f"{link.name}: {verdict} (principal moments "
            f"{', '.join(f'{moment:.4g}' for moment in body.moments)} kg m²)"
        )
    return Measurement(np.array(values), 1.0, tuple(details), per_state=False)


_FAULTS: dict[Fault, str] = {
    "mass-negative": "the mass is negative",
    "mass-zero": "the mass is zero although the inertia is not",
    "not-positive-definite": "a principal moment is negative",
    "triangle-inequality": "a principal moment exceeds the sum of the others",
}

_PRINTED = Tolerance(
    0.0,
    "what the printed digits allow is taken off before, as in rules INE101 to INE103",
    per_joint=False,
)

BODIES: tuple[Check[Subject], ...] = (
    Check(
        "inertia-physical",
        "body",
        "every link's inertia could belong to a real body",
        "m ≥ 0, I ≥ 0, I_a + I_b ≥ I_c (principal moments)",
        "Wensing, Kim & Slotine 2018; Traversaro et al. 2016",
        "of the largest moment",
        _PRINTED,
        _bodies,
    ),
)


def _fk_alignment(s: PairSubject) -> Measurement:
    alignment, tool = s.difference.pair.alignment, s.difference.tool
    values = np.concatenate(
        [alignment.axis_angle / SAME_ANGLE, alignment.axis_distance / SAME_LENGTH]
    )
    said = f"tools agree to {tool.position:.1e} m and {tool.angle:.1e} rad over all states"
    return Measurement(values, 1.0, (said,), per_state=False)


def _residual(s: PairSubject) -> Measurement:
    """Our torques of a, minus the reference engine's of b, minus all contributions."""
    states, alignment = s.difference.states, s.difference.pair.alignment
    signs, offsets = alignment.signs, alignment.offsets
    tau_a = s.recursion.inverse_dynamics(states.q, states.qd, states.qdd)
    tau_b = signs * s.reference.inverse_dynamics(
        signs * states.q + offsets, signs * states.qd, signs * states.qdd
    )
    attributed = s.difference.attribution.torque.sum(axis=0)
    left: Array = np.abs(tau_a - tau_b - attributed).max(axis=1)
    return Measurement(left, float(max(np.abs(tau_a).max(), np.abs(tau_b).max())))


PAIRS: tuple[Check[PairSubject], ...] = (
    Check(
        "fk-alignment",
        "numbers",
        "the joint axes are the same lines in space",
        "X · T_b(s ∘ q + o) and T_a(q) carry the same axes",
        "base transform X, signs s and offsets o are found, not assumed: docs/conventions.md",
        "of 1 µm or 1 µrad",
        Tolerance(
            1.0, "no table or file that people write carries digits below these", per_joint=False
        ),
        _fk_alignment,
    ),
    Check(
        "residual",
        "numbers",
        "the attribution of the difference leaves no residual",
        "τ_own(a) − τ_reference(b) = share(geometry) + share(gravity) + Ȳ (π_a − π_b)",
        "linearity of torque in π; Shapley's average over orders: docs/checks.md",
        "N m",
        Tolerance(128, "rounding of two torques, and of as many regressors again"),
        _residual,
    ),
)
