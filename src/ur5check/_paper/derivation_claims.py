"""The paper's claims on its derivation: more accurate than Lagrange's, by a program that runs."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

import numpy as np

from .._dynamics.equations import kinetic_energy, potential_energy
from .._dynamics.recursion import rnea
from .._robot.serial_arm import SerialArm
from .._robot.states import States, random_states
from .._robot.transforms import Array
from .claim import Claim, ClaimOutcome, Trial, judged
from .evidence import Evidence
from .paper_models import PRINTED, Form

__all__ = [
    "accuracy_trial",
    "lagrange_torque",
    "listing_runs",
    "newton_euler_is_more_accurate",
    "parse_trial",
]

_STATES, _SEED = 200, 0
_STEP = 1e-20  # of a complex step, which has no cancellation

#: Roundings of Lagrange's torques per joint pair, in units of ε times the largest torque.
_ROUNDINGS = 16.0

#: Where the printed statements for α_5 and α_6 end; their closing brackets are not there.
_CUT_OFF = ("cross(w5, (b5 * dq[4", "cross(w6, (b6 * dq[5")


def newton_euler_is_more_accurate(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """The recursion gives other, more accurate equations than Lagrange's."""
    evidence.say("deriving the torques by Lagrange's equations")
    claim = Claim(
        "newton-euler",
        "Newton–Euler's recursion gives more accurate equations of motion than Lagrange's",
        f"largest difference of the two torques over {_STATES} random motions: above rounding, or "
        "the equations are the same",
        "section 3",
        "N m",
    )
    arm = evidence.model(PRINTED).arm
    states = random_states(arm.n, _STATES, _SEED)
    recursion = rnea(arm, states.q, states.qd, states.qdd)
    yield from judged(claim, [accuracy_trial(PRINTED, recursion, lagrange_torque(arm, states))])


def accuracy_trial(name: str, recursion: Array, lagrange: Array) -> Trial:
    """Torques of shape (N, n) [N m] by both methods; the claim needs a difference."""
    n = recursion.shape[1]
    scale = float(np.abs(recursion).max())
    rounding = _ROUNDINGS * n**2 * float(np.finfo(np.float64).eps) * scale
    apart = float(np.abs(recursion - lagrange).max())
    why = "" if apart > rounding else "the same equations, to rounding"
    return Trial(name, "printed", apart, rounding, why, "above")


def lagrange_torque(arm: SerialArm, states: States) -> Array:
    """d/dt ∂T/∂q̇ − ∂T/∂q + ∂U/∂q, shape (N, n) [N m], from the energies alone.

    T is quadratic in q̇, so that its derivative is half of T(q̇ + e_i) − T(q̇ − e_i), exactly; the
    other derivatives are complex steps.  The recursion is not used.

    References: Siciliano et al., Robotics (2009), ch. 7.1.
    """
    q, qd, qdd = (x.astype(np.complex128) for x in (states.q, states.qd, states.qdd))
    later_q, later_qd = q + 1j * _STEP * qd, qd + 1j * _STEP * qdd
    tau = np.empty(states.q.shape)
    for i, unit in enumerate(np.eye(arm.n)):
        momentum = 0.5 * (
            kinetic_energy(arm, later_q, later_qd + unit)
            - kinetic_energy(arm, later_q, later_qd - unit)
        )
        aside = q + 1j * _STEP * unit
        lagrangian = kinetic_energy(arm, aside, qd) - potential_energy(arm, aside)
        tau[:, i] = (momentum.imag - lagrangian.imag) / _STEP
    return tau


def listing_runs(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """The program runs as printed."""
    claim = Claim(
        "listing-runs",
        "The printed program runs",
        "statements of the listing that Python's parser refuses, its lost indents and minus signs "
        "restored: none",
        "listing",
        "1",
    )
    closed = tuple(f"{text}]))" for text in _CUT_OFF)
    trials: tuple[tuple[str, Form, tuple[str, ...]], ...] = (
        (PRINTED, "printed", _CUT_OFF),
        ("paper-listing, brackets closed", "repaired", closed),
    )
    yield from judged(claim, (parse_trial(*trial) for trial in trials))


def parse_trial(name: str, form: Form, statements: Iterable[str]) -> Trial:
    """The number of these expressions that do not parse."""
    refused = [text for text in statements if not _parses(text)]
    why = "α_5 and α_6 end before their closing brackets" if refused else ""
    return Trial(name, form, float(len(refused)), 0.0, why)


def _parses(text: str) -> bool:
    try:
        ast.parse(text, mode="eval")
    except SyntaxError:
        return False
    return True
