"""All computations that the claims are judged by."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from .case_runs import Run, run_case
from .cases import CASES
from .inertia_formulas import TensorFormula, tensor_formulas
from .listing_mistakes import ListingMistakes, find_listing_mistakes
from .paper_models import PRINTED, REPAIRED, Model, load_models

__all__ = ["Evidence", "Progress", "gather"]

Progress = Callable[[str], None]


@dataclass(frozen=True, eq=False)
class Evidence:
    """The results that the claims are judged by.

    models : that were computed;  runs : each case for each model, case by case
    listing_mistakes : found by diagnosis, and the listing without them
    formulas : the formula that gives each printed tensor
    say : called with a line before each longer step
    """

    models: tuple[Model, ...]
    runs: tuple[Run, ...]
    listing_mistakes: ListingMistakes
    formulas: tuple[TensorFormula, ...]
    say: Progress

    def model(self, name: str) -> Model:
        """By its name."""
        return next(model for model in self.models if model.name == name)

    def of(self, number: int) -> Iterator[Run]:
        """The runs of a case, model by model."""
        return (run for run in self.runs if run.case.number == number)

    def run(self, number: int, model: str) -> Run:
        """One case for one model."""
        return next(run for run in self.of(number) if run.model.name == model)


def gather(say: Progress) -> Evidence:
    """Read the models, run the cases, look for mistakes and formulas."""
    say("reading the paper's tables, its listing, its appendix and another UR5")
    models = load_models()
    say(f"running {len(CASES)} cases for {len(models)} models")
    runs = tuple(run_case(case, model) for case in CASES for model in models)
    arms = {model.name: model.arm for model in models}
    say("looking for the listing's mistakes")
    listing_mistakes = find_listing_mistakes(arms[PRINTED], arms[REPAIRED])
    say("looking for the formula behind each inertia tensor")
    formulas = tensor_formulas(arms[PRINTED], arms["appendix"])
    return Evidence(models, runs, listing_mistakes, formulas, say)
