"""`ur5check paper`: the paper's computations repeated, with a verdict on each claim."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from .._arguments import callback
from .._result import Result
from .._robot.serial_arm import SerialArm
from .case_runs import Run
from .claim import Claim, ClaimOutcome, Verdict, overall
from .claims import CLAIMS, ClaimFunction
from .evidence import Evidence, Progress, gather
from .inertia_formulas import TensorFormula
from .listing_mistakes import ListingMistakes, MistakeEffect, mistake_effect
from .paper_models import PINOCCHIO, PRINTED

__all__ = ["Reproduction", "judge", "reproduce"]


@dataclass(frozen=True, eq=False, repr=False)
class Reproduction(Result):
    """The paper's results, computed again.

    Attributes
    ----------
    cases : tuple of Run
        Each case for each model, case by case.
    claims : tuple of ClaimOutcome
        Each claim for each model it was tested on, claim by claim.
    formulas : tuple of TensorFormula
        The formula that gives each printed inertia tensor.
    listing_mistakes : ListingMistakes
        The mistakes of the paper's listing.
    effects : tuple of MistakeEffect
        What they do to each case.
    arms : tuple of SerialArm
        Those that were read.
    """

    cases: tuple[Run, ...]
    claims: tuple[ClaimOutcome, ...]
    formulas: tuple[TensorFormula, ...]
    listing_mistakes: ListingMistakes
    effects: tuple[MistakeEffect, ...]
    arms: tuple[SerialArm, ...]

    @property
    def verdicts(self) -> dict[Claim, Verdict]:
        """The verdict on each claim."""
        return {claim: overall(self.outcomes(claim.id)) for claim in self._claims()}

    @property
    def engines_apart(self) -> float:
        """Largest |τ − τ_Pinocchio| on the appendix, over all cases [N m]."""
        return max(float(np.abs(a.torque - b.torque).max()) for a, b in self._both())

    @property
    def trustworthy(self) -> bool:
        """Whether our recursion and the reference engine agree on the appendix, in every case."""
        return all(np.abs(a.torque - b.torque).max() <= a.rounding for a, b in self._both())

    def outcomes(self, claim: str) -> tuple[ClaimOutcome, ...]:
        """The outcomes of one claim, model by model.

        Parameters
        ----------
        claim : str
            Its id.

        Returns
        -------
        tuple of ClaimOutcome
        """
        return tuple(outcome for outcome in self.claims if outcome.id == claim)

    def run(self, number: int, model: str) -> Run:
        """One case for one model.

        Parameters
        ----------
        number : int
            Of the case, 1 … 9.
        model : str
            Its name.

        Returns
        -------
        Run
        """
        return next(r for r in self.cases if r.case.number == number and r.model.name == model)

    def _claims(self) -> Iterable[Claim]:
        return dict.fromkeys(outcome.claim for outcome in self.claims)

    def _both(self) -> Iterable[tuple[Run, Run]]:
        numbers = dict.fromkeys(run.case.number for run in self.cases)
        return ((self.run(n, "appendix"), self.run(n, PINOCCHIO)) for n in numbers)


def reproduce(progress: Progress | None = None) -> Reproduction:
    """Run the nine cases, find the formulas of the inertia tensors, and judge every claim.

    Parameters
    ----------
    progress : callable, optional
        Called with a line before each longer step.

    Returns
    -------
    Reproduction

    Raises
    ------
    InputError
        If a shipped model cannot be read, or for an invalid argument.
    EngineError
        If Pinocchio cannot take a model.

    References
    ----------
    Paper, section "Results & Simulation".

    Examples
    --------
    >>> import ur5check
    >>> ur5check.reproduce().trustworthy
    True
    """
    return judge(gather(callback("progress", progress)))


def judge(evidence: Evidence, claims: Iterable[ClaimFunction] = CLAIMS) -> Reproduction:
    """Test the claims on the evidence."""
    evidence.say("judging the claims")
    outcomes = tuple(outcome for claim in claims for outcome in claim(evidence))
    printed = (run for run in evidence.runs if run.model.name == PRINTED)
    effects = (mistake_effect(evidence.listing_mistakes, run) for run in printed)
    arms = tuple(model.arm for model in evidence.models)
    return Reproduction(
        evidence.runs,
        outcomes,
        evidence.formulas,
        evidence.listing_mistakes,
        tuple(effect for effect in effects if effect is not None),
        arms,
    )
