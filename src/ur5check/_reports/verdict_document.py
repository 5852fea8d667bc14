"""`validate` as a document: every finding of every model, then the tables of the computation."""

from __future__ import annotations

from .._finding import Finding
from .._validation.configuration import Configuration
from .._validation.validation import Validation
from .._validation.verdict import Verdict, VerdictSet
from .document import Column, Document, Row, Section, Table
from .document import Verdict as Headline
from .provenance import Provenance
from .validate_document import validate_document
from .verdict_summary import inputs_of_verdicts, summarize_verdicts
from .wording import where

__all__ = ["verdict_document"]


def verdict_document(
    verdicts: VerdictSet,
    laws: Validation,
    configuration: Configuration,
    *,
    command: str = "",
) -> Document:
    """The report of `ur5check validate`.  laws : of the arms that were computed"""
    text = summarize_verdicts(verdicts)
    sections = [_section(v) for v in verdicts.models]
    inputs = inputs_of_verdicts(verdicts, configuration)
    first = verdicts.models[0].judgement
    if laws.models:
        whole = validate_document(laws, command=command)
        sections += whole.sections
    return Document(
        "Verdict on " + ", ".join(v.judgement.model for v in verdicts.models[:4]),
        Headline("PASS" if verdicts.passed else "FAIL", text, verdicts.passed),
        (),
        tuple(sections),
        Provenance(inputs, first.seed, first.samples, command),
    )


def _section(v: Verdict) -> Section:
    j, s = v.judgement, v.findings
    lines = [f"{'PASS' if v.passed else 'FAIL'}: {len(s.open)} findings."]
    if j.robot is not None:
        lines.append(f"{j.robot.name}: {len(j.robot.links)} links, {j.robot.mass:.4g} kg.")
    if j.arm_note or (j.laws is None and j.laws_note):
        lines.append(f"Not computed: {j.arm_note or j.laws_note}.")
    lines += [f"Accepted: {f.rule} {f.subject}: {a.reason}" for f, a in s.accepted]
    lines += [f"In the baseline: {f.rule} {f.subject}: {f.message}" for f in s.known]
    lines += [f"Stale: {a.rule} {a.subject} is accepted but does not occur." for a in s.stale]
    columns = tuple(
        Column(title) for title in ("severity", "rule", "place", "subject", "finding", "fix")
    )
    rows = tuple(Row(_cells(f, j.file), bad=f.severity == "error") for f in s.open)
    return Section(j.file, tuple(lines), (Table(columns, rows),) if rows else ())


def _cells(f: Finding, file: str) -> tuple[str, ...]:
    return f.severity, f.rule, where(f.place, file), f.subject, f.message, f.fix
