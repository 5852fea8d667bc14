"""The explanation of a difference as JSON: the part `explanation` of `ur5check diff`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated, Literal

import msgspec
import numpy as np
from msgspec import Meta

from .._comparison.diagnosis.diagnosis import Diagnosis
from .._comparison.explanation import Explanation
from .._comparison.plausibility.plausible_body import Plausibility
from .._comparison.rounding.error_budget import ErrorBudget
from .._comparison.worst_case.worst_case import WorstCase
from .._robot.transforms import Array
from .explanation_summary import doubt_in_words, equivalence_in_words, removed
from .json_values import Number, SideValue, State, Vector, state, vector
from .mistake_sentences import advice, details, remark, sentence
from .rounding_sentences import cause_in_words, places_in_words

__all__ = ["ExplanationValue", "explanation_value"]

LinkNumber = Annotated[int, Meta(ge=1)]


class TermsValue(msgspec.Struct, frozen=True, kw_only=True):
    """RMS of the difference per joint, by term [N m]."""

    gravity: Vector
    coriolis: Vector
    inertial: Vector


class IdentifiabilityValue(msgspec.Struct, frozen=True, kw_only=True):
    """Which inertial parameters joint torques determine."""

    columns: int
    rank: int
    certain: bool
    doubt: str
    gap: float
    identifiable: list[str]
    in_combination: list[str]
    unidentifiable: list[str]
    combinations: list[str]
    equivalent: bool
    sentence: str


class BudgetItemValue(msgspec.Struct, frozen=True, kw_only=True):
    """What one kind of rounded digits amounts to per joint [N m]."""

    cause: str
    side: SideValue
    where: str
    exact: bool
    rms: Vector
    maximum: Vector


class ErrorBudgetValue(msgspec.Struct, frozen=True, kw_only=True):
    """The part of the difference that rounded digits explain, per joint [N m]."""

    items: list[BudgetItemValue]
    total: Vector
    explained: Vector
    remainder: Vector
    digits_suffice: bool


class WorstCaseValue(msgspec.Struct, frozen=True, kw_only=True):
    """The largest difference that was found within the limits, and its state.

    The maximum is at least `value`, and at most `bound` where one is known.  `reached` of `starts`
    independent ascents ended there.
    """

    what: Literal["one joint", "all joints together"]
    joint: str | None
    static: bool
    value: float
    bound: Number
    unit: str
    effort_share: Number
    state: State
    best_random: float
    starts: int
    reached: int
    undetected_share: Number


class MistakeValue(msgspec.Struct, frozen=True, kw_only=True):
    """A known mistake that was recognised."""

    id: str
    rules: list[str]
    side: SideValue | None
    where: list[LinkNumber]
    sentence: str
    details: list[str]
    advice: str
    before: float
    after: float
    removes: float
    choices: int
    equals: list[str]


class UnexplainedValue(msgspec.Struct, frozen=True, kw_only=True):
    """A number that differs and that no known mistake explains."""

    link: LinkNumber
    quantity: str
    gap: float
    sentence: str


class PlausibilityValue(msgspec.Struct, frozen=True, kw_only=True):
    """Something implausible about a body."""

    side: SideValue
    severity: Literal["note", "suspicious", "impossible"]
    link: int | None
    name: str
    quantity: str
    value: Number
    bound: Number
    unit: str
    sentence: str


class ExplanationValue(msgspec.Struct, frozen=True, kw_only=True):
    """Why two models differ."""

    diagnosis: list[MistakeValue]
    unexplained: list[UnexplainedValue]
    terms: TermsValue
    identifiability: IdentifiabilityValue
    error_budget: ErrorBudgetValue
    worst_case: list[WorstCaseValue]
    plausibility: list[PlausibilityValue]


def explanation_value(e: Explanation) -> ExplanationValue:
    """Why two models differ."""
    return ExplanationValue(
        diagnosis=_mistakes(e.diagnosis),
        unexplained=[
            UnexplainedValue(
                link=mismatch.link + 1,
                quantity=mismatch.quantity,
                gap=mismatch.gap,
                sentence=remark(mismatch, e.diagnosis),
            )
            for mismatch in e.diagnosis.unexplained
        ],
        terms=TermsValue(
            gravity=_rms(e.terms.gravity.delta),
            coriolis=_rms(e.terms.coriolis.delta),
            inertial=_rms(e.terms.inertial.delta),
        ),
        identifiability=_identifiability(e),
        error_budget=_budget(e.budget),
        worst_case=[_worst(e, case) for case in e.worst],
        plausibility=[*_plausibility("a", e.plausible_a), *_plausibility("b", e.plausible_b)],
    )


def _rms(delta: Array) -> Vector:
    return vector(np.sqrt((delta**2).mean(axis=0)))


def _identifiability(e: Explanation) -> IdentifiabilityValue:
    found = e.identifiability
    return IdentifiabilityValue(
        columns=found.columns,
        rank=found.rank,
        certain=found.certain,
        doubt="" if found.certain else doubt_in_words(found),
        gap=float(found.gap),
        identifiable=list(found.names_of("identifiable")),
        in_combination=list(found.names_of("in combination")),
        unidentifiable=list(found.names_of("invisible")),
        combinations=list(found.combinations()),
        equivalent=e.equivalence.dynamically_equivalent,
        sentence=equivalence_in_words(e.equivalence),
    )


def _budget(budget: ErrorBudget) -> ErrorBudgetValue:
    return ErrorBudgetValue(
        items=[
            BudgetItemValue(
                cause=cause_in_words(item),
                side=item.side,
                where=places_in_words(item),
                exact=item.exact,
                rms=vector(item.rms),
                maximum=vector(item.maximum),
            )
            for item in budget.items
        ],
        total=vector(budget.total),
        explained=vector(budget.explained),
        remainder=vector(budget.remainder),
        digits_suffice=budget.digits_suffice,
    )


def _worst(e: Explanation, case: WorstCase) -> WorstCaseValue:
    joints = e.difference.pair.a.joints
    return WorstCaseValue(
        what=case.what,
        joint=None if case.joint is None else joints[case.joint - 1].name,
        static=case.static,
        value=case.value,
        bound=case.bound,
        unit=case.unit,
        effort_share=case.effort_share,
        state=state(case.state),
        best_random=case.best_random,
        starts=case.starts,
        reached=case.reached,
        undetected_share=case.undetected_share,
    )


def _mistakes(diagnosis: Diagnosis) -> list[MistakeValue]:
    return [
        MistakeValue(
            id=found.id,
            rules=[mistake.rule_id for mistake in found.mistakes],
            side=found.side,
            where=list(found.links),
            sentence=sentence(found, diagnosis.pair),
            details=list(details(found)),
            advice=advice(found),
            before=found.before,
            after=found.after,
            removes=removed(found, diagnosis),
            choices=found.choices,
            equals=list(found.equals),
        )
        for found in diagnosis.mistakes
    ]


def _plausibility(side: SideValue, found: Iterable[Plausibility]) -> list[PlausibilityValue]:
    return [
        PlausibilityValue(
            side=side,
            severity=one.severity,
            link=one.link,
            name=one.name,
            quantity=one.quantity,
            value=one.value,
            bound=one.bound,
            unit=one.unit,
            sentence=one.sentence,
        )
        for one in found
    ]
