"""An explained difference in about five lines: what, why, what is left, where it is worst."""

from __future__ import annotations

import numpy as np

from .._comparison import difference_summary as difference_summary
from .._comparison.diagnosis.diagnosis import Diagnosis, Finding
from .._comparison.explanation import Explanation

__all__ = ["summarize"]

_WORTH_A_LINE = 0.01  # of the RMS difference: mistakes that cost less are left to the table
_MOST_MISTAKES = 4


def summarize(explanation: Explanation) -> tuple[str, ...]:
    """The verdict, the mistakes that explain it, what they leave, the worst posture."""
    difference = explanation.difference
    told = difference_summary.summarize(difference)
    if difference.agrees:
        same = explanation.equivalence
        return told if same.same_numbers else (told[0], same.sentence, *told[1:])
    verdict, geometry, *_ = told
    lines = [verdict]
    if difference.pair.alignment.exact:
        lines.append(geometry)
    lines += _mistakes(explanation.diagnosis)
    lines.append(_rest(explanation))
    lines.append(_worst(explanation))
    return tuple(line for line in lines if line)


def removed(finding: Finding, diagnosis: Diagnosis) -> float:
    """Part of the whole RMS difference that repairing a finding removes."""
    if diagnosis.before == 0.0:
        return 0.0
    return (finding.before - finding.after) / diagnosis.before


def _mistakes(diagnosis: Diagnosis) -> list[str]:
    summary = [f for f in diagnosis.findings if removed(f, diagnosis) > _WORTH_A_LINE]
    if not summary:
        return ["No single known mistake explains the difference."]
    return [
        f"{f.sentence}; repairing it removes {removed(f, diagnosis):.0%} of the difference."
        for f in summary[:_MOST_MISTAKES]
    ]


def _rest(explanation: Explanation) -> str:
    diagnosis = explanation.diagnosis
    if not diagnosis.findings:
        return difference_summary.contributions_in_words(explanation.difference)
    left = f"{diagnosis.after:.2g} N m RMS of {diagnosis.before:.3g} are left"
    if diagnosis.after <= 1e-9 * diagnosis.before:
        return "With everything repaired nothing is left."
    unnamed = [
        f"link {s.link + 1}'s {s.quantity}"
        for s in sorted(diagnosis.unexplained, key=lambda s: -s.gap)
    ]
    if not unnamed:
        return f"With everything repaired {left}: digits."
    numbers = difference_summary.listed(unnamed)
    return f"With that repaired {left}; no known mistake explains {numbers}."


def _worst(explanation: Explanation) -> str:
    difference = explanation.difference
    single = [case for case in explanation.worst if case.joint is not None and not case.static]
    worst = max(single, key=lambda case: case.value)
    joint = worst.joint
    if joint is None:
        return ""
    posture = " ".join(f"{angle:.0f}" for angle in np.degrees(worst.state["q"]))
    share = "" if worst.effort_share is None else f", {worst.effort_share:.0%} of its limit"
    name = difference.pair.a.joints[joint - 1].name
    return (
        f"Worst within limits: joint {joint} ({name}) is {worst.value:.3g} N m off{share}, "
        f"at q = ({posture})°."
    )
