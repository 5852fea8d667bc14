"""The claims: the verdict on each, and on each for every model."""

from __future__ import annotations

from ..._paper.claim import ClaimOutcome
from ..._paper.reproduction import Reproduction
from ..document import Column, Row, Section, Table
from ..wording import residue

__all__ = ["claims_section"]

_BOUNDS = {"at most": "≤", "at least": "≥", "below": "<", "above": ">"}


def claims_section(r: Reproduction, *, written_out: bool) -> Section:
    """One row a claim; written out, also one row a model it was tested on, and the tests."""
    tables = [_summary(r)]
    if written_out:
        tables += [_every_model(r), _tests(r)]
    return Section("The claims", tables=tuple(tables))


def _summary(r: Reproduction) -> Table:
    return Table(
        (
            Column("claim"),
            Column("verdict"),
            Column("as printed", number=True),
            Column("must be", number=True),
            Column("unit"),
            Column("why"),
        ),
        tuple(
            _row(claim.text, verdict, r.outcomes(claim.id)) for claim, verdict in r.verdicts.items()
        ),
        note="Confirmed: what the paper printed passes. After repair: it fails as printed, and "
        "passes once the mistake is repaired. Refuted: it fails, and no repair makes it pass.",
    )


def _row(text: str, verdict: str, outcomes: tuple[ClaimOutcome, ...]) -> Row:
    printed = [o for o in outcomes if o.form == "printed"]
    shown = printed[0]
    why = "; ".join(o.why for o in printed if o.why)
    cells = (text, verdict, residue(shown.value), _limit(shown), shown.unit, why)
    return Row(cells, bad=verdict == "refuted")


def _every_model(r: Reproduction) -> Table:
    return Table(
        (
            Column("claim"),
            Column("model"),
            Column("value", number=True),
            Column("must be", number=True),
            Column("unit"),
            Column("verdict"),
            Column("why"),
        ),
        tuple(
            Row(
                (o.id, o.model, residue(o.value), _limit(o), o.unit, o.verdict, o.why),
                bad=not o.holds,
            )
            for o in r.claims
        ),
        title="Every claim, model by model",
    )


def _tests(r: Reproduction) -> Table:
    return Table(
        (Column("claim"), Column("what is measured, and its limit"), Column("where in the paper")),
        tuple(Row((claim.id, claim.test, claim.source)) for claim in r.verdicts),
        title="How each claim was tested",
    )


def _limit(o: ClaimOutcome) -> str:
    return f"{_BOUNDS[o.bound]} {residue(o.limit)}"
