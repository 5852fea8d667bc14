"""An explained difference in about five lines: size, mistakes, remainder, worst state."""

from __future__ import annotations

import numpy as np

from .._arguments import instance
from .._comparison.diagnosis.diagnosis import Diagnosis, RecognizedMistake
from .._comparison.explanation import Explanation
from .._comparison.identifiability.equivalence import TOLERANCE, Equivalence
from .._comparison.identifiability.identifiability import CERTAIN_GAP, WEAKEST, Identifiability
from . import difference_summary
from .diff_sections.stated_uncertainty import uncertainty_in_words
from .mistake_sentences import sentence
from .wording import joined

__all__ = ["doubt_in_words", "equivalence_in_words", "removed", "summarize"]

_WORTH_A_LINE = 0.01  # of the RMS difference: mistakes that cost less are left to the table
_MOST_MISTAKES = 4


def summarize(explanation: Explanation) -> tuple[str, ...]:
    """The verdict, the mistakes that explain it, the remainder, the worst state."""
    difference = explanation.difference
    summary = difference_summary.summarize(difference)
    if difference.rounding_explains:
        causes = difference_summary.rounding_in_words(difference)
        return summary[0], *causes, summary[1 + len(causes)], _worst(explanation)
    if difference.same_torques:
        same = explanation.equivalence
        if same.same_numbers:
            return summary
        return summary[0], equivalence_in_words(same), *summary[1:]
    verdict, geometry, *_ = summary
    lines = [verdict]
    if difference.pair.alignment.exact:
        lines.append(geometry)
    lines += _mistakes(explanation)
    lines.append(_rest(explanation))
    lines.append(_worst(explanation))
    if difference.band is not None:
        lines.append(uncertainty_in_words(difference, difference.band))
    lines.append(difference_summary.others_in_words(difference))
    lines += difference_summary.faults_in_words(difference)
    return tuple(line for line in lines if line)


def equivalence_in_words(equivalence: Equivalence) -> str:
    """Whether two arms differ only in parameters without effect on torque, as a sentence.

    Parameters
    ----------
    equivalence : Equivalence
        See `ur5check.equivalence`.

    Returns
    -------
    str

    Raises
    ------
    UsageError
        For another type.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("paper", "paper")
    >>> found = ur5check.equivalence(pair, ur5check.random_states(6, 5, seed=0))
    >>> ur5check.equivalence_in_words(found)
    'Same numbers, same dynamics.'
    """
    instance("equivalence", equivalence, Equivalence, "see ur5check.equivalence")
    if not equivalence.dynamically_equivalent:
        if float(equivalence.visible.max()) <= TOLERANCE * equivalence.largest:
            return "The inertias are dynamically equivalent; geometry or gravity is not."
        most = equivalence.visible.max()
        return f"The inertias are not dynamically equivalent: up to {most:.3g} N m apart."
    if equivalence.same_numbers:
        return "Same numbers, same dynamics."
    return "Different numbers, same dynamics: the difference lies in the null space of Y."


def doubt_in_words(found: Identifiability) -> str:
    """Why a rank is not certain."""
    return (
        f"rank {found.rank} of {found.columns} is not certain: the weakest direction kept is "
        f"{found.weakest:.1e} of the strongest and {found.gap:.1e} times what is dropped "
        f"(wanted: more than {WEAKEST:.0e} and {CERTAIN_GAP:.0e}); some axis or length is all "
        "but special, by a rounded angle or a tiny offset"
    )


def removed(found: RecognizedMistake, diagnosis: Diagnosis) -> float:
    """Part of the whole RMS difference that repairing a mistake removes."""
    if diagnosis.before == 0.0:
        return 0.0
    return (found.before - found.after) / diagnosis.before


def _mistakes(explanation: Explanation) -> list[str]:
    diagnosis = explanation.diagnosis
    worth_a_line = [f for f in diagnosis.mistakes if removed(f, diagnosis) > _WORTH_A_LINE]
    if not worth_a_line and explanation.budget.digits_suffice:
        return ["No mistake is needed to explain the difference: the last printed digits suffice."]
    if not worth_a_line:
        return ["No single known mistake explains the difference."]
    return [
        f"{sentence(f, diagnosis.pair)}; repairing it removes {removed(f, diagnosis):.0%} of the "
        "difference."
        for f in worth_a_line[:_MOST_MISTAKES]
    ]


def _rest(explanation: Explanation) -> str:
    diagnosis = explanation.diagnosis
    if not diagnosis.mistakes:
        return difference_summary.contributions_in_words(explanation.difference)
    left = f"{diagnosis.after:.2g} of {diagnosis.before:.3g} N m RMS remain"
    if diagnosis.after <= 1e-9 * diagnosis.before:
        return "After all repairs no difference remains."
    unnamed = [
        f"link {s.link + 1}'s {s.quantity}"
        for s in sorted(diagnosis.unexplained, key=lambda s: -s.gap)
    ]
    if not unnamed:
        return f"After all repairs {left}: rounding of the numbers."
    numbers = joined(unnamed)
    return f"After these repairs {left}; no known mistake explains {numbers}."


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
        f"Worst state within limits: at least {worst.value:.3g} N m at joint {joint} ({name})"
        f"{share}, at q = ({posture})°; {worst.reached} of {worst.starts} searches ended there."
    )
