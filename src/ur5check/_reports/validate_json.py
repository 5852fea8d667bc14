"""`ur5check validate` as JSON."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import msgspec

from .._validation.configuration import Configuration
from .._validation.law import Outcome
from .._validation.validation import Validation
from .._validation.verdict import PairVerdict, Verdict
from .diff_json import Comparison, comparison_value
from .json_report import Report, head
from .json_values import Model, Number, State, model_value, state
from .validate_summary import summarize
from .verdict_json import Agreement, FileVerdict, agreement_value, file_verdict
from .verdict_summary import inputs_of_verdicts, summarize_verdicts

__all__ = ["ValidateReport", "validate_json"]


class ValidateVerdict(msgspec.Struct, frozen=True, kw_only=True):
    """What the computation says of the arms, whatever the findings say of the files."""

    algorithm: bool
    bodies: bool
    explained: bool


class ValidatedModel(msgspec.Struct, frozen=True, kw_only=True):
    """A model, the reference engine, and how the engine got the model."""

    model: Model
    reference: str
    route: str


class CheckValue(msgspec.Struct, frozen=True, kw_only=True):
    """One check of one subject."""

    id: str
    about: Literal["algorithm", "body", "numbers"]
    subject: str
    statement: str
    formula: str
    status: Literal["pass", "fail"]
    value: Number
    tolerance: Number
    bound: Literal["at most", "above"]
    unit: str
    samples: int
    worst_state: State | None
    details: list[str]


class ValidateReport(Report, frozen=True, kw_only=True, tag="ur5check.validate/2"):
    """Verdicts on files, whether two of them agree; laws, bodies and differences of their arms."""

    passed: bool
    fail_level: Literal["error", "warning", "note"]
    configuration: str | None
    files: list[FileVerdict]
    agreement: Agreement | None
    verdict: ValidateVerdict
    summary: list[str]
    models: list[ValidatedModel]
    checks: list[CheckValue]
    differences: list[Comparison]


def validate_json(
    v: Validation,
    *,
    verdicts: Sequence[Verdict] = (),
    pair: PairVerdict | None = None,
    configuration: Configuration | None = None,
    command: str = "",
) -> ValidateReport:
    """The report of `ur5check validate`.

    v : the laws of the arms that were computed;  configuration : what is accepted
    """
    arms = [model.arm for model in v.models]
    accepts = configuration or Configuration()
    return ValidateReport(
        **head(
            () if verdicts else arms,
            command,
            seed=v.seed,
            samples=v.samples,
            files=inputs_of_verdicts(verdicts, accepts),
        ),
        passed=all(x.passed for x in verdicts)
        and (v.passed if pair is None else pair.passed and v.algorithm_right),
        fail_level=verdicts[0].fail_level if verdicts else "error",
        configuration=accepts.path or None,
        files=[file_verdict(x) for x in verdicts],
        agreement=None if pair is None else agreement_value(pair),
        verdict=ValidateVerdict(
            algorithm=v.algorithm_right,
            bodies=v.bodies_possible,
            explained=v.explained,
        ),
        summary=[
            *([summarize_verdicts(verdicts, pair)] if verdicts else []),
            *(summarize(v) if v.models else []),
        ],
        models=[
            ValidatedModel(
                model=model_value(model.arm), reference=model.reference, route=model.route
            )
            for model in v.models
        ],
        checks=[_check(outcome) for outcome in v.outcomes],
        differences=[comparison_value(pair.difference) for pair in v.pairs],
    )


def _check(o: Outcome) -> CheckValue:
    return CheckValue(
        id=o.id,
        about=o.about,
        subject=o.subject,
        statement=o.statement,
        formula=o.formula,
        status=o.status,
        value=o.value,
        tolerance=o.tolerance,
        bound="above" if o.positive else "at most",
        unit=o.unit,
        samples=o.samples,
        worst_state=None if o.worst_state is None else state(o.worst_state),
        details=list(o.details),
    )
