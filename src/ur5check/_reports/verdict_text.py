"""The first screen of `validate`: at most 24 lines of 80 columns a file.

Verdict, findings worst first with place and fix, the robot's mass and arm, one line for the
computation.  The rest is for `--full`, Markdown and JSON.
"""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

import numpy as np

from .._finding import Finding
from .._validation.configuration import Sorted
from .._validation.judgement import Judgement
from .._validation.verdict import PairVerdict, Verdict, VerdictSet
from .wording import where

__all__ = ["LINES", "WIDTH", "verdict_text", "verdicts_text"]

LINES, WIDTH = 24, 80


def verdicts_text(verdicts: VerdictSet, *, full: bool = False) -> str:
    """One model: its first screen.  Two: both, shorter, and whether they agree.  Many: a table.

    full : all findings of every file
    """
    models, pairs = verdicts.models, verdicts.pairs
    if len(models) > 2 or len(pairs) > 1:
        table = _summary_table(verdicts)
        if not full:
            return table
        return "\n".join([*(verdict_text(v, lines=None) for v in models), table])
    of_pairs = [line for pair in pairs for line in _pair_lines(pair)]
    lines = None if full else (LINES - len(of_pairs)) // len(models)
    texts = [verdict_text(v, lines=lines) for v in models]
    if of_pairs:
        texts.append("\n".join(of_pairs) + "\n")
    return "\n".join(texts) if full else "".join(texts)


def verdict_text(v: Verdict, *, lines: int | None = LINES, width: int = WIDTH) -> str:
    """One file's verdict.  lines : how many at most; None for all findings."""
    j, s = v.judgement, v.findings
    head = [_headline(j, s, v.passed, width)]
    foot = [line for text in _facts(j, s) for line in _wrapped(text, width, "           ")]
    if lines is not None:
        foot = _cut(foot, max(lines - 1 if not s.open else lines // 2, 3))
    if not s.open:
        return "\n".join([*head, *foot]) + "\n"
    tight = lines is not None and lines < LINES
    left = None if lines is None else max(lines - len(head) - len(foot) - (0 if tight else 2), 2)
    gap = [] if tight else [""]
    shown = _findings(s.open, j.file, left, width)
    return "\n".join([*head, *gap, *shown, *gap, *foot]) + "\n"


def _cut(lines: list[str], most: int) -> list[str]:
    """The first lines, and how many more there are."""
    if len(lines) <= most:
        return lines
    return [*lines[: most - 1], f"           … {len(lines) - most + 1} more lines (--full)"]


def _pair_lines(pair: PairVerdict) -> list[str]:
    for f, acceptance in pair.findings.accepted:
        return _wrapped(
            f"ACCEPTED  {pair.label}: {f.message}; {acceptance.reason}", WIDTH, "          "
        )
    for f in pair.findings.known:
        return _wrapped(f"KNOWN  {pair.label}: {f.message} (in the baseline)", WIDTH, "       ")
    if pair.passed:
        return [f"AGREE {pair.label}: the same torques"]
    for f in pair.findings.open:
        return [
            *_wrapped(f"DIFFER {pair.label}: {f.message}", WIDTH, "      "),
            f"      fix: {f.fix}",
        ]
    return [f"DIFFER {pair.label}: the difference is not explained"]


def _headline(j: Judgement, s: Sorted, passed: bool, width: int) -> str:
    counts = [
        f"{n} {word}{'s' if n != 1 else ''}"
        for word in ("error", "warning", "note")
        if (n := sum(f.severity == word for f in s.open))
    ]
    text = f"{'PASS' if passed else 'FAIL'}  {j.file}: {', '.join(counts) or 'no findings'}"
    if len(text) > width:  # a long path is cut at its beginning
        over = len(text) - width + 1
        text = f"{text[:6]}…{text[6 + over :]}"
    return text


def _findings(findings: Sequence[Finding], file: str, most: int | None, width: int) -> list[str]:
    shown: list[str] = []
    for k, finding in enumerate(findings):
        block = _finding(finding, file, width, short=most is not None)
        left = len(findings) - k
        needed = len(block) + (1 if left > 1 else 0)
        if most is not None and len(shown) + needed > most:
            shown.append(f"… and {left} more (--full shows all)")
            break
        shown += block
    return shown


def _finding(f: Finding, file: str, width: int, *, short: bool) -> list[str]:
    head, place = f"{f.severity:7} {f.rule}  {f.subject}", where(f.place, file)
    over = len(head) + 2 + len(place) - width
    if over > 0 and len(place) > over + 1:  # a long path is cut at its beginning
        place = f"…{place[over + 1 :]}"
    head = f"{head}  {place}".rstrip()
    message = _wrapped(f.message, width - 4, "")
    if short and len(message) > 2:
        message = [message[0], f"{message[1][: width - 6]} …"]
    tail = []
    if f.fix:
        tail = _wrapped(f"fix: {f.fix}", width - 4, "     ")
        tail = tail[:1] if short and len(tail) > 1 and len(message) > 1 else tail
    if not short and f.consequence:
        tail = [*_wrapped(f"consequence: {f.consequence}", width - 4, "     "), *tail]
    if not short and f.place.via:
        ways = ", ".join(f"{where(p, file)} {p.element}".rstrip() for p in f.place.via)
        tail = [*_wrapped(f"by way of: {ways}", width - 4, "     "), *tail]
    return [head[:width], *(f"    {line}" for line in (*message, *tail))]


def _facts(j: Judgement, s: Sorted) -> list[str]:
    facts = []
    robot = j.robot
    if robot is not None:
        moving = sum(joint.moves for joint in robot.joints)
        facts.append(
            f"robot      {robot.name}: {len(robot.links)} links, {moving} moving joints, "
            f"{robot.mass:.4g} kg"
        )
    if j.arm is not None:
        mass = sum(link.inertia.mass for link in j.arm.links)
        facts.append(
            f"arm        {j.arm.source.base} → {j.arm.source.tip}, {j.arm.n} joints, "
            f"{mass:.4g} kg moved"
        )
    elif j.arm_note:
        facts.append(f"arm        none: {j.arm_note}")
    if j.laws is not None:
        outcomes = [o for o in j.laws.outcomes if o.about == "algorithm"]
        failed = j.failed_laws
        torque = next((o.value for o in outcomes if o.id == "torque-reference"), float(np.nan))
        agree = (
            f"hand-written recursion and {j.laws.reference} agree: {len(outcomes)} laws, "
            f"{j.samples:,} states, {torque:.0e} N m"
            if not failed
            else f"the computation is WRONG: {', '.join(failed)}; please report this"
        )
        facts.append(f"computed   {agree}")
    elif j.laws_note and j.arm is not None:
        facts.append(f"computed   not checked: {j.laws_note}")
    if j.engines:
        found = sum(f.rule.startswith("ENG") for f in j.findings)
        facts.append(f"engines    {', '.join(j.engines)}: {found or 'no'} findings")
    for finding, acceptance in s.accepted:
        facts.append(f"accepted   {finding.rule} {finding.subject}: {acceptance.reason}")
    if s.known:
        count = f"{len(s.known)} finding{'s' if len(s.known) > 1 else ''}"
        facts.append(f"baseline   {count} known, not counted")
    for stale in s.stale:
        facts.append(f"stale      {stale.rule} {stale.subject} is accepted but does not occur")
    return facts


def _wrapped(text: str, width: int, indent: str) -> list[str]:
    return textwrap.wrap(
        text, width, subsequent_indent=indent, break_long_words=True, break_on_hyphens=False
    )


def _summary_table(verdicts: VerdictSet, width: int = WIDTH) -> str:
    """A row a file, how many passed, and which pairs do not agree."""
    rows = []
    for v in verdicts.models:
        j, found = v.judgement, v.findings.open
        counts = [sum(f.severity == word for f in found) for word in ("error", "warning", "note")]
        first = next((f"{f.rule} {f.subject}" for f in found if f.severity == "error"), "")
        mass = "" if j.robot is None else f"{j.robot.mass:.4g}"
        name = j.file if len(j.file) <= 34 else f"…{j.file[-33:]}"
        row = f"{'PASS' if v.passed else 'FAIL'}  {name:34} " + "".join(f"{n:4}" for n in counts)
        rows.append(f"{row} {mass:>8}  {first}"[:width].rstrip())
    head = f"      {'file':34}  err warn note       kg  first error"
    failed = sum(not v.passed for v in verdicts.models)
    total = len(verdicts.models)
    rows.append(f"{total} files: {total - failed} pass, {failed} fail")
    return "\n".join([head, *rows, *_table_of_pairs(verdicts)]) + "\n"


def _table_of_pairs(verdicts: VerdictSet) -> list[str]:
    if verdicts.reference is None:
        return _wrapped(
            "agreement: of two models only; --against REFERENCE compares each with one, "
            "ur5check diff A B explains",
            WIDTH,
            "           ",
        )
    rows = [
        line
        for pair in verdicts.pairs
        if pair.findings.all or not pair.passed
        for line in _pair_lines(pair)
    ]
    differ = sum(not pair.passed for pair in verdicts.pairs)
    agree = len(verdicts.pairs) - differ
    file = verdicts.reference.judgement.file
    return [*rows, f"against {file}: {agree} agree or accepted, {differ} differ"]
