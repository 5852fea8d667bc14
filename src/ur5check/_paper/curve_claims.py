"""The paper's claims on its curves: a sine, as expected, zero and constant."""

from __future__ import annotations

from collections.abc import Iterator

from .case_runs import Run
from .cases import CASES
from .claim import Claim, ClaimOutcome, Trial, judged
from .evidence import Evidence
from .statics import nothing_to_hold

__all__ = ["as_expected", "posture_torque", "sine", "zero_and_constant"]


def sine(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Cases 1 and 5: the torque is a sine."""
    for case in (case for case in CASES if case.claim == "a sine curve"):
        claim = Claim(
            f"case-{case.number}-sine",
            f"Case {case.number}: τ{case.watched} is a sine curve",
            "offset and residual of the fitted sine over its amplitude: rounding only",
            f"test case {case.number}",
            "1",
        )
        yield from judged(claim, map(sine_trial, evidence.of(case.number)))


def sine_trial(run: Run) -> Trial:
    """One curve compared with its fitted sine; zero amplitude fails."""
    fit = run.harmonic
    if fit is None or fit.amplitude <= run.rounding:
        return _trial(run, float("nan"), 0.0, "there is no curve")
    why = f"amplitude {fit.amplitude:.4g} N m"
    return _trial(run, fit.departure, 2.0 * run.rounding / fit.amplitude, why)


def as_expected(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Cases 1 to 8: the torque is the moment of the weights.

    The paper says "as expected" without an expected value. At rest a motor balances the moment of
    the weights, which is computed from lever arms, not by the recursion.
    """
    for case in (case for case in CASES if case.watched is not None):
        claim = Claim(
            f"case-{case.number}-expected",
            f"Case {case.number}: τ{case.watched} is as expected",
            "largest distance from the moment of the model's own weights on the UR5's geometry: at "
            "most 1 % of its peak, less than a plot shows",
            f"test case {case.number}",
            "N m",
        )
        yield from judged(claim, map(expectation_trial, evidence.of(case.number)))


def expectation_trial(run: Run) -> Trial:
    """The watched torque compared with the moment of the weights."""
    if run.as_expected:
        reason = nothing_to_hold(run.model.true_arm, run.q, run.case.watched or 1)
        nothing = f"nothing to hold{': ' * bool(reason)}{reason}"
        why = f"peak {run.peak:.4g} N m" if run.expected_peak else nothing
    elif not run.expected_peak:
        why = f"peak {run.peak:.4g} N m, with nothing to hold"
    else:
        turned = ", of opposite sign" if run.opposed else ""
        part = 100.0 * (run.peak / run.expected_peak - 1.0)
        size = f"{abs(part):.1f} % too {'large' if part > 0.0 else 'small'}"
        why = f"peak {run.peak:.4g} for {run.expected_peak:.4g} N m: {size}{turned}"
    return _trial(run, run.error, run.tolerance, why)


def zero_and_constant(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Case 4: no torque about a vertical axis."""
    claim = Claim(
        "case-4-zero",
        "Case 4: τ1 is zero and constant",
        "largest torque over the turn: rounding of the other joints' torques",
        "test case 4",
        "N m",
    )
    yield from judged(claim, map(zero_trial, evidence.of(4)))


def zero_trial(run: Run) -> Trial:
    """No torque at all, all along."""
    largest = float(abs(run.watched).max())
    why = nothing_to_hold(run.model.true_arm, run.q, run.case.watched or 1)
    return _trial(run, largest, run.rounding, why)


def posture_torque(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Case 9: the torques that were sent to the simulator are those that hold the arm."""
    claim = Claim(
        "case-9-holds",
        "Case 9: the torques sent to the simulator hold the arm",
        "largest distance, over the six joints, from the moment of the model's own weights: at "
        "most 1 % of its largest",
        "test case 9",
        "N m",
    )
    yield from judged(claim, map(posture_trial, evidence.of(9)))


def posture_trial(run: Run) -> Trial:
    """Six torques compared with the moments of the weights."""
    shown = run.expected_watched if run.as_expected else run.watched - run.expected_watched
    joint = int(abs(shown).argmax())
    tau, wanted = run.watched[joint], run.expected_watched[joint]
    why = f"τ{joint + 1} = {tau:+.4g} N m"
    if not run.as_expected:
        turned = ": the wrong sign" if tau * wanted < 0.0 else ""
        why += f" for {wanted:+.4g} N m{turned}"
    return _trial(run, run.error, run.tolerance, why)


def _trial(run: Run, value: float, limit: float, why: str) -> Trial:
    return Trial(run.model.name, run.model.form, value, limit, why)
