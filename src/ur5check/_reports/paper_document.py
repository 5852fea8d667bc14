"""What `paper` shows."""

from __future__ import annotations

from collections.abc import Mapping

from .._paper.reproduction import Reproduction
from .document import Document, Verdict
from .paper_sections.claim_table import claims_section
from .paper_sections.nine_cases import cases_section, listing_mistakes_section
from .paper_sections.tensor_formulas import formulas_section
from .paper_summary import summarize, summary
from .provenance import Provenance, inputs_of
from .wording import residue

__all__ = ["paper_document"]


def paper_document(
    r: Reproduction,
    *,
    pictures: Mapping[int, str] | None = None,
    written_out: bool = False,
    command: str = "",
) -> Document:
    """The report of `ur5check paper`.

    pictures : of each case, where its picture is, as seen from the report
    written_out : whether every claim is shown for every model, with how it was tested
    """
    return Document(
        "The paper, claim by claim",
        _verdict(r),
        tuple(summarize(r)),
        (
            claims_section(r, written_out=written_out),
            cases_section(r, pictures or {}),
            listing_mistakes_section(r),
            formulas_section(r),
        ),
        Provenance(inputs_of(r.arms), r.listing_mistakes.seed, r.listing_mistakes.samples, command),
    )


def _verdict(r: Reproduction) -> Verdict:
    if not r.trustworthy:
        text = (
            "our recursion and Pinocchio do not agree on the appendix "
            f"({residue(r.engines_apart)} N m apart); the results below are not valid."
        )
        return Verdict("FAIL", text, False)
    return Verdict("REPRODUCED", summary(r), True)
