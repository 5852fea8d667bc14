"""The paper's claims on loads: less than before, and low because a link is light.

"Low" is measured by the paper's own cases, which go from heavy to light: less than in any earlier
case with a load. "Because the link is light" states that the joint bears the link's own weight; the
test removes that weight and computes what remains.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._dynamics.equations import gravity_torque
from .._robot.inertia import Inertia
from .._robot.serial_arm import SerialArm
from .case_runs import Run
from .claim import Claim, ClaimOutcome, Trial, judged
from .evidence import Evidence
from .paper_models import PINOCCHIO
from .statics import nothing_to_hold

__all__ = ["because_light", "less_than_case_2", "low"]

#: Cases before 7 whose claim speaks of a torque that moves the arm; case 6 is joint 5 again.
_LOADED = (1, 2, 3, 5)

#: The cases that claim a low torque, and the link whose lightness is given as the reason.
_LIGHT = {7: 5, 8: 6}

#: A weight that causes less than half of a torque is not the reason for it.
_HALF = 0.5


def less_than_case_2(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Case 3: the bent arm needs less torque than the stretched one."""
    claim = Claim(
        "case-3-less",
        "Case 3: the bent arm takes less torque than the stretched arm of case 2",
        "peak of τ2 over that of case 2: below 1",
        "test case 3",
        "1",
    )
    pairs = zip(evidence.of(3), evidence.of(2), strict=True)
    yield from judged(claim, (less_trial(bent, stretched) for bent, stretched in pairs))


def less_trial(bent: Run, stretched: Run) -> Trial:
    """One peak over another."""
    ratio = bent.peak / stretched.peak if stretched.peak else float("nan")
    why = f"{bent.peak:.4g} for {stretched.peak:.4g} N m"
    return Trial(bent.model.name, bent.model.form, ratio, 1.0, why, "below")


def low(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Cases 7 and 8: the torque is low."""
    for number in _LIGHT:
        runs = list(evidence.of(number))
        claim = Claim(
            f"case-{number}-low",
            f"Case {number}: τ{runs[0].case.watched} is low",
            "peak over the smallest peak of the loaded cases before it (1, 2, 3 and 5): below 1",
            f"test case {number}",
            "1",
        )
        before = ([evidence.run(n, run.model.name) for n in _LOADED] for run in runs)
        yield from judged(claim, map(low_trial, runs, before))


def low_trial(run: Run, before: list[Run]) -> Trial:
    """One peak against all those before."""
    least = min(other.peak for other in before)
    ratio = run.peak / least if least else float("nan")
    why = f"{run.peak:.4g} N m; the least before is {least:.4g} N m"
    return Trial(run.model.name, run.model.form, ratio, 1.0, why, "below")


def because_light(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Cases 7 and 8: it is low because the link is light."""
    for number, link in _LIGHT.items():
        claim = Claim(
            f"case-{number}-light",
            f"Case {number}: the torque is low because link {link} is light",
            f"part of the peak that goes when link {link} weighs nothing: at least half, or its "
            "mass is not the reason",
            f"test case {number}",
            "1",
        )
        # The reference engine holds the arm of the appendix, whose mass is taken away already.
        runs = (run for run in evidence.of(number) if run.model.name != PINOCCHIO)
        yield from judged(claim, (light_trial(run, link) for run in runs))


def light_trial(run: Run, link: int) -> Trial:
    """The same case with a weightless link."""
    joint = run.case.watched or 1
    rest = gravity_torque(without_weight(run.model.arm, link), run.q)[:, joint - 1]
    left = float(np.abs(rest).max())
    share = 1.0 - left / run.peak if run.peak else 0.0
    why = f"of {run.peak:.3g} N m, {left:.3g} stay without it"
    if run.peak == 0.0:
        reason = nothing_to_hold(run.model.true_arm, run.q, joint)
        why = f"zero, whatever link {link} weighs{': ' * bool(reason)}{reason}"
    return Trial(run.model.name, run.model.form, share, _HALF, why, "at least")


def without_weight(arm: SerialArm, link: int) -> SerialArm:
    """The arm with link `link`, from 1, weighing nothing."""
    bodies = [body.inertia for body in arm.links]
    bodies[link - 1] = Inertia.zero()
    return arm.with_inertias(bodies)
