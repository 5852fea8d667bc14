"""What `validate` shows.  Three separate questions: is the algorithm right,
could the bodies exist, are the numbers of two models explained?
"""

from __future__ import annotations

from .._validation.law import Outcome
from .._validation.validation import ModelValidation, PairValidation, Validation
from .document import Column, Document, Row, Section, Table, Verdict
from .law_table import law_table
from .pair_parts import alignment_lines, contribution_table, torque_table
from .provenance import Provenance, inputs_of
from .validate_summary import summarize
from .wording import coordinates, figures, residue, titled

__all__ = ["validate_document"]

_ROUTES = {
    "SerialArm": "built joint by joint from our model",
    "URDF text, own parser": "which parses the URDF text itself",
    "pin.Model": "the model itself",
}


def validate_document(v: Validation, *, command: str = "") -> Document:
    """The report of `ur5check validate`."""
    sections = [_algorithm(v), _bodies(v)]
    if v.pairs:
        sections.append(_numbers(v))
    failures = [o for o in v.outcomes if not o.passed and o.id != "fk-alignment"]
    if failures:
        sections.insert(0, _failures(failures))
    first, *others = [titled(model.arm) for model in v.models]
    against = f" against {', '.join(others)}" if others else ""
    return Document(
        f"Validation of {first}{against}",
        _verdict(v),
        summarize(v),
        tuple(sections),
        Provenance(inputs_of(model.arm for model in v.models), v.seed, v.samples, command),
    )


def _verdict(v: Validation) -> Verdict:
    parts = [
        "the algorithm is right" if v.algorithm_right else "the algorithm is WRONG",
        "the bodies could exist" if v.bodies_possible else "a body COULD NOT EXIST",
    ]
    if v.pairs:
        explained = "explained" if v.explained else "NOT explained"
        parts.append(f"the differences of the models are {explained}")
    text = f"{'; '.join(parts)}."
    return Verdict("PASS" if v.passed else "FAIL", text, v.passed)


def _failures(failures: list[Outcome]) -> Section:
    rows = [
        Row(
            (
                o.subject,
                f"{o.statement} ({o.id})",
                residue(o.value),
                f"{'>' if o.positive else '≤'} {residue(o.tolerance)}",
                o.unit,
            ),
            bad=True,
        )
        for o in failures
    ]
    columns = (
        Column("model"),
        Column("should hold"),
        Column("worst", number=True),
        Column("must be", number=True),
        Column("unit"),
    )
    tables = [Table(columns, tuple(rows))]
    states = [row for o in failures if o.worst_state for row in _state(o)]
    if states:
        heads = (Column("check"), Column("on"), Column("state"), Column("joint by joint"))
        tables.append(Table(heads, tuple(states), title="Where it is worst"))
    return Section("What fails", tables=tuple(tables))


def _state(outcome: Outcome) -> list[Row]:
    rows = []
    check, model = outcome.id, outcome.subject
    for key, symbol in (("q", "q [rad]"), ("qd", "qd [rad/s]"), ("qdd", "qdd [rad/s²]")):
        values = (outcome.worst_state or {}).get(key, [])
        rows.append(Row((check, model, symbol, " ".join(f"{x:8.4f}" for x in values))))
        check, model = "", ""
    return rows


def _algorithm(v: Validation) -> Section:
    laws = [o for o in v.outcomes if o.about == "algorithm"]
    held = sum(o.passed for o in laws)
    lines = [
        f"{held} of {len(laws)} checks hold: {len(laws) // len(v.models)} laws, true of any arm "
        f"whatever its numbers, on {len(v.models)} model{'s' if len(v.models) > 1 else ''}."
    ]
    lines += [
        f"Reference engine of {m.arm.label}: {m.reference}, {_ROUTES.get(m.route, m.route)}."
        for m in v.models
    ]
    return Section("The algorithm", tuple(lines), (law_table(v),))


def _bodies(v: Validation) -> Section:
    return Section("The bodies", tables=tuple(_body_table(model) for model in v.models))


def _body_table(model: ModelValidation) -> Table:
    failed = [o for o in model.outcomes if o.about == "body" and not o.passed]
    rows = []
    for link in model.arm.links:
        moments = link.inertia.principal_moments()
        own = link.inertia.expressed_in(link.source_frame.inverse())
        cells = (link.name, figures(own.mass), coordinates(own.com))
        rows.append(Row((*cells, *(figures(float(moment)) for moment in moments))))
    verdict = "NOT all could exist" if failed else f"all {model.arm.n} could exist"
    return Table(
        (
            Column("link"),
            Column("mass [kg]", number=True),
            Column("centre of mass [m]"),
            *(Column(f"{axis} [kg m²]", number=True) for axis in ("I₁", "I₂", "I₃")),
        ),
        tuple(rows),
        title=f"{model.arm.label}: {verdict}",
        note=" ".join(f"{detail}." for o in failed for detail in o.details),
    )


def _numbers(v: Validation) -> Section:
    lines: list[str] = []
    tables: list[Table] = []
    for pair in v.pairs:
        d = pair.difference
        if len(v.pairs) > 1:
            lines.append(f"{d.pair.a.label} against {d.pair.b.label}:")
        lines += alignment_lines(d)
        lines.append(_residual(pair))
        tables.append(torque_table(d))
        contributions = contribution_table(d)
        if contributions.rows:
            tables.append(contributions)
    return Section("The numbers", tuple(lines), tuple(tables))


def _residual(pair: PairValidation) -> str:
    (outcome,) = (o for o in pair.outcomes if o.id == "residual")
    attribution = "is complete" if outcome.passed else "IS NOT COMPLETE"
    a, b = pair.difference.pair.a.label, pair.difference.pair.b.label
    return (
        f"The attribution {attribution}: the difference between our torques of {a} and the "
        f"reference engine's of {b} leaves a residual of {residue(outcome.value)} {outcome.unit} "
        f"(rounding allows {residue(outcome.tolerance)})."
    )
