"""A check: a statement, the largest violation that was measured, and its tolerance."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Literal, TypeVar

import numpy as np

from .._robot.states import States
from .._robot.transforms import Array

__all__ = ["About", "Check", "Measurement", "Outcome", "Status", "Tolerance", "run"]

#: A law tests the algorithm and holds for any numbers; a body can be impossible; two models can
#: have different numbers.  The three are never mixed in a report.
About = Literal["algorithm", "body", "numbers"]
Status = Literal["pass", "fail"]

Subject = TypeVar("Subject", contravariant=True)

_EPS = float(np.finfo(np.float64).eps)


@dataclass(frozen=True)
class Tolerance:
    """The largest violation of a statement that passes, and the reason.

    With `per_joint`, the limit is factor · n · ε · scale: rounding, which grows with the number of
    joints that a number passes through and with the size of what is added up.  Without, it is
    factor · scale.
    """

    factor: float
    reason: str
    per_joint: bool = True

    def limit(self, scale: float, n: int) -> float:
        """The largest value that passes."""
        return self.factor * scale * (n * _EPS if self.per_joint else 1.0)


@dataclass(frozen=True, eq=False)
class Measurement:
    """Measured values: one per state (or link), in the check's unit.

    scale : size of the quantities compared, in the same unit
    details : sentences for a report
    per_state : whether values[k] belongs to state k
    """

    values: Array
    scale: float
    details: tuple[str, ...] = ()
    per_state: bool = True


@dataclass(frozen=True)
class Check(Generic[Subject]):
    """A statement that can fail.

    id : its name in reports, tests and docs
    statement : in words;  formula : as a formula;  source : where it comes from
    positive : the value must exceed the limit, where otherwise it must not
    """

    id: str
    about: About
    statement: str
    formula: str
    source: str
    unit: str
    tolerance: Tolerance
    measure: Callable[[Subject], Measurement]
    positive: bool = False


@dataclass(frozen=True, eq=False)
class Outcome:
    """The result of a check on one subject.

    Attributes
    ----------
    id : str
        Of the check.
    about : {"algorithm", "body", "numbers"}
        What it judges: the computation, a body, or the difference of two models.
    subject : str
        What was checked.
    statement, formula : str
    status : {"pass", "fail"}
    value : float
        The worst one, in `unit`.
    tolerance : float
        The limit that it was compared with, in `unit`.
    unit : str
    samples : int
        Number of values measured.
    worst_state : dict or None
        "q", "qd" and "qdd" of the worst value; None if the check is not about states.
    positive : bool
        Whether the value must exceed the limit, where otherwise it must not.
    details : tuple of str
        For the report.
    """

    id: str
    about: About
    subject: str
    statement: str
    formula: str
    status: Status
    value: float
    tolerance: float
    unit: str
    samples: int
    worst_state: dict[str, list[float]] | None
    positive: bool = False
    details: tuple[str, ...] = ()

    @property
    def passed(self) -> bool:
        """Whether the status is "pass"."""
        return self.status == "pass"


def run(check: Check[Subject], subject: Subject, *, name: str, n: int, states: States) -> Outcome:
    """Measure, judge, and keep the worst.  A value that is no number fails."""
    measured = check.measure(subject)
    values = np.asarray(measured.values, dtype=np.float64)
    limit = check.tolerance.limit(measured.scale, n)
    # The worst value; where one is nan, that one.
    order = -values if check.positive else values
    worst = int(np.argmax(np.where(np.isnan(values), np.inf, order)))
    value = float(values[worst])
    passed = value > limit if check.positive else value <= limit
    return Outcome(
        id=check.id,
        about=check.about,
        subject=name,
        statement=check.statement,
        formula=check.formula,
        status="pass" if passed else "fail",
        value=value,
        tolerance=limit,
        unit=check.unit,
        samples=len(values),
        worst_state=states[worst] if measured.per_state else None,
        positive=check.positive,
        details=measured.details,
    )
