"""`ur5check validate` as JSON."""

from __future__ import annotations

from typing import Literal

import msgspec

from .._validation.configuration import Configuration
from .._validation.law import Outcome
from .._validation.validation import Validation
from .._validation.verdict import VerdictSet
from .diff_json import Comparison, comparison_value
from .json_report import Report, head
from .json_values import Model, Number, State, model_value, state
from .validate_summary import summarize
from .verdict_json import Agreement, FileVerdict, agreement_value, file_verdict
from .verdict_summary import inputs_of_verdicts, summarize_verdicts

__all__ = ["ValidateReport", "validate_json"]


class ValidateVerdict(msgspec.Struct, frozen=True, kw_only=True):
    """The parts of the verdict; null where no file was judged, no pair compared or no arm computed.

    Algorithm, bodies and explained are about the arms that were computed.
    """

    files: bool | None
    agreement: bool | None
    algorithm: bool | None
    bodies: bool | None
    explained: bool | None


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
    """Verdicts on files, which pairs agree; laws, bodies and differences of their arms."""

    passed: bool
    fail_level: Literal["error", "warning", "note"]
    configuration: str | None
    files: list[FileVerdict]
    agreements: list[Agreement]
    verdict: ValidateVerdict
    summary: list[str]
    models: list[ValidatedModel]
    checks: list[CheckValue]
    differences: list[Comparison]


def validate_json(
    v: Validation,
    *,
    verdicts: VerdictSet | None = None,
    configuration: Configuration | None = None,
    command: str = "",
) -> ValidateReport:
    """The report of `ur5check validate`.

    v : the laws of the arms that were computed;  configuration : what is accepted
    """
    judged = verdicts or VerdictSet(())
    accepts = configuration or Configuration()
    computed = bool(v.models)
    return ValidateReport(
        **head(
            [model.arm for model in v.models] if verdicts is None else (),
            command,
            seed=v.seed,
            samples=v.samples,
            files=inputs_of_verdicts(judged, accepts),
        ),
        passed=v.passed if verdicts is None else verdicts.passed,
        fail_level=judged.models[0].fail_level if judged.models else "error",
        configuration=accepts.path or None,
        files=[file_verdict(x) for x in judged.models],
        agreements=[agreement_value(pair) for pair in judged.pairs],
        verdict=ValidateVerdict(
            files=all(x.passed for x in judged.models) if judged.models else None,
            agreement=all(pair.passed for pair in judged.pairs) if judged.pairs else None,
            algorithm=v.algorithm_right if computed else None,
            bodies=v.bodies_possible if computed else None,
            explained=v.explained if v.pairs else None,
        ),
        summary=[
            *([] if verdicts is None else [summarize_verdicts(verdicts)]),
            *(summarize(v) if computed else []),
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
