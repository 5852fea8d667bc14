"""The paper's claims on control (eqs 16–28), tested by poles and in a simulated loop.

The paper prints no gains.  Here every joint's poles are placed at −8, −10 and −12 / s; the signs
fail for any positive gains (`_simulation.control.error_dynamics`).  Controller and plant are the
same arm by the same engine, so that the outcome depends on the control law only.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._engines.engine import Engine
from .._robot.transforms import Array
from .._simulation.control.computed_torque import ComputedTorque
from .._simulation.control.error_dynamics import poles
from .._simulation.control.feedback_law import FeedbackLaw
from .._simulation.control.gains import Gains
from .._simulation.control.tracking import Tracking, track
from .._simulation.control.trajectory import Quintic
from .claim import Claim, ClaimOutcome, Trial, judged
from .evidence import Evidence
from .paper_models import Form

__all__ = [
    "GAINS",
    "eq_28_is_the_law",
    "feedback_is_stable",
    "following_trial",
    "gain_trial",
    "gains_reach_every_joint",
    "pole_trial",
    "printed_matrix",
]

GAINS = Gains.placed(6, (-8.0, -10.0, -12.0))

#: One second, from a posture in front of the base to another.
_TRAJECTORY = Quintic(
    np.array([0.0, -1.2, 1.0, 0.0, 0.3, 0.0]), np.array([1.0, -0.5, 0.2, 1.0, -0.3, 1.0]), 1.0
)
#: A start this far off is less than any encoder shows [rad].
_OFF = 1e-6
#: Above the integrator's tolerance of 1e-9, below any encoder's resolution [rad].
_FOLLOWS = 1e-6


def feedback_is_stable(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Eqs (21)–(23): the feedback makes the error decay."""
    evidence.say("closing the control loop with the paper's signs")
    claim = Claim(
        "pid-signs",
        "The PID feedback makes the arm follow",
        "largest real part of the poles of the error dynamics: below 0, or errors grow",
        "eqs (21)–(23)",
        "1/s",
    )
    plant = _appendix(evidence)
    laws: tuple[tuple[str, FeedbackLaw, Form], ...] = (
        ("eqs (22), (23)", FeedbackLaw.PRINTED_22, "printed"),
        ("eqs (22), (23), plus signs", FeedbackLaw.RIGHT, "repaired"),
    )
    yield from judged(claim, (pole_trial(name, form, law, plant) for name, law, form in laws))


def pole_trial(name: str, form: Form, law: FeedbackLaw, plant: Engine) -> Trial:
    """The least damped pole, and the error of a simulated arm that starts one microradian off."""
    run = _followed(law, plant, off=_OFF)
    end = 1e6 * float(np.abs(run.error[-1]).max())
    why = f"an error of 1 µrad is half a turn after {run.t[-1]:.2f} s"
    if not run.lost:
        why = f"an error of 1 µrad is {end:.1g} µrad after {run.t[-1]:g} s"
    return Trial(name, form, float(poles(GAINS, law)[0].real), 0.0, why, "below")


def gains_reach_every_joint(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Eqs (24)–(26): the gain matrices give every joint a feedback of its own error."""
    claim = Claim(
        "pid-gains",
        "The gain matrices feed back every joint's error",
        "rank of K_p with one gain for all joints: 6, or some errors have no feedback",
        "eqs (24)–(26)",
        "1",
    )
    gains = np.diag(GAINS.kp)
    yield from judged(
        claim,
        (
            gain_trial("K_p by eq. (24)", "printed", printed_matrix(gains)),
            gain_trial("K_p diagonal", "repaired", np.diag(gains)),
        ),
    )


def printed_matrix(gains: Array) -> Array:
    """Eqs (24)–(26): the first row is K_1 … K_6, the last K_6 … K_6, (i, j) has K_max(i, j).

    gains : K_1 … K_n, shape (n,).  Only the corners K_1, K_6, K_6, K_6 and the dots are printed;
    with one gain for all joints every way to fill the dots gives this matrix.
    """
    index = np.arange(len(gains))
    return np.asarray(gains[np.maximum.outer(index, index)])


def gain_trial(name: str, form: Form, matrix: Array) -> Trial:
    """The number of directions of joint space in which a gain matrix acts."""
    n, rank = len(matrix), int(np.linalg.matrix_rank(matrix))
    missing = f"errors in {n - rank} of {n} directions of joint space have no feedback"
    return Trial(name, form, float(rank), float(n), missing * (rank < n), "at least")


def eq_28_is_the_law(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Eq. (28) is eqs (17) and (23) written out: with an exact model, it follows exactly."""
    claim = Claim(
        "pid-eq-28",
        "Eq. (28), the control torque written out, follows a trajectory",
        "largest error of a joint on a quintic of 1 s, model and plant the same: at most a "
        "microradian, far above the integrator's own error",
        "eqs (17), (23), (28)",
        "rad",
    )
    plant = _appendix(evidence)
    laws: tuple[tuple[str, FeedbackLaw, Form], ...] = (
        ("eq. (28)", FeedbackLaw.PRINTED_28, "printed"),
        ("eq. (28) with θ̈_d", FeedbackLaw.RIGHT, "repaired"),
    )
    yield from judged(claim, (following_trial(name, form, law, plant) for name, law, form in laws))


def following_trial(name: str, form: Form, law: FeedbackLaw, plant: Engine) -> Trial:
    """Largest tracking error of an arm that starts on the trajectory."""
    largest = float(_followed(law, plant, off=0.0).largest().max())
    why = "" if law.feeds_forward else "plus signs, unlike eq. (23), and θ̈_d is dropped"
    return Trial(name, form, largest, _FOLLOWS, why)


def _followed(law: FeedbackLaw, plant: Engine, *, off: float) -> Tracking:
    return track(ComputedTorque(plant, GAINS, law), plant, _TRAJECTORY, q=_TRAJECTORY.start + off)


def _appendix(evidence: Evidence) -> Engine:
    from .._engines.adapters.pinocchio import PinocchioEngine

    return PinocchioEngine(evidence.model("appendix").arm)
