"""What `diff` shows."""

from __future__ import annotations

from .._comparison.attribution import Attribution
from .._comparison.difference import Difference
from .._comparison.explanation import Explanation
from .diff_sections.attribution_table import contributions_section
from .diff_sections.implausible_bodies import bodies_section
from .diff_sections.mistakes_found import findings_section
from .diff_sections.numbers_side_by_side import numbers_section
from .diff_sections.rounded_digits import digits_section
from .diff_sections.stated_uncertainty import uncertainty_section
from .diff_sections.unidentifiable import unseen_section
from .diff_sections.worst_configuration import worst_section
from .difference_summary import summarize as summarize_difference
from .document import Document, Section, Verdict
from .explanation_summary import summarize as summarize_explanation
from .provenance import Provenance, inputs_of
from .wording import titled

__all__ = ["diff_document"]


def diff_document(
    d: Difference,
    explanation: Explanation | None = None,
    *,
    parameters: Attribution | None = None,
    written_out: bool = False,
    command: str = "",
) -> Document:
    """The report of `ur5check diff`.

    explanation : of d; None in a quick report
    parameters : d's attribution to each parameter, with --by-parameter
    written_out : whether the combinations that torque sees are written out
    """
    verdict, *lines = (
        summarize_difference(d) if explanation is None else summarize_explanation(explanation)
    )
    a, b = d.pair.a, d.pair.given_b
    return Document(
        f"{titled(a)} against {titled(b)}",
        Verdict("AGREE" if d.agrees else "DIFFER", verdict, d.agrees),
        tuple(lines),
        _sections(d, explanation, parameters, written_out),
        Provenance(inputs_of((a, b)), d.seed, len(d.states), command),
    )


def _sections(
    d: Difference, e: Explanation | None, parameters: Attribution | None, written_out: bool
) -> tuple[Section, ...]:
    uncertainty = () if d.band is None else (uncertainty_section(d, d.band),)
    if e is None:
        return numbers_section(d), *uncertainty, contributions_section(d, None, parameters)
    return (
        findings_section(e),
        numbers_section(d),
        *uncertainty,
        contributions_section(d, e.terms, parameters),
        unseen_section(e, written_out=written_out),
        digits_section(e),
        worst_section(e),
        bodies_section(e),
    )
