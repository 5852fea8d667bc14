"""`diff --repair`: B with its known mistakes repaired, as a URDF, and in words what was done to
it.
"""

from __future__ import annotations

from collections.abc import Callable

from .._comparison.diagnosis.diagnosis import Diagnosis, Finding
from .._comparison.explanation import Explanation
from .._io.urdf.urdf_writer import urdf_of
from .output import emit

__all__ = ["repair"]

#: What no file of B has to be repaired for: an agreement between those who exchange states.
_AGREEMENTS = ("base-turned", "joint-reversed", "zero-shifted")


def repair(explanation: Explanation, file: str, say: Callable[[str], None]) -> None:
    """Write the repaired B, and say of every finding what became of it.

    Nothing is written where there is nothing to repair in B.  Raises UsageError if the file cannot
    be written.
    """
    diagnosis = explanation.diagnosis
    repaired = [finding for finding in diagnosis.findings if _repaired_in_b(finding, diagnosis)]
    if repaired:
        emit(urdf_of(diagnosis.repaired_b), file, option="--repair")
    for finding in diagnosis.findings:
        say(f"repaired: {finding.sentence}" if finding in repaired else _not_repaired(finding))
    if diagnosis.unexplained:
        numbers = ", ".join(f"link {s.link + 1}'s {s.quantity}" for s in diagnosis.unexplained)
        say(f"not repaired: no known mistake explains {numbers}")
    name = explanation.difference.pair.b.name
    say(f"wrote {file}" if repaired else f"{file} is not written: nothing to repair in {name}")


def _repaired_in_b(finding: Finding, diagnosis: Diagnosis) -> bool:
    if finding.side == "a":
        return False
    if not finding.links:
        return finding.side == "b" and finding.id not in _AGREEMENTS
    before, after = diagnosis.pair.given_b.links, diagnosis.repaired_b.links
    return all(after[link - 1] is not before[link - 1] for link in finding.links)


def _not_repaired(finding: Finding) -> str:
    if finding.id in _AGREEMENTS:
        return f"nothing to repair: {finding.sentence}; {finding.advice}"
    if finding.id.startswith("gravity-"):
        return f"not repaired: {finding.sentence}; a URDF carries no gravity: give --gravity X Y Z"
    return f"not repaired: {finding.sentence}; A is the one to repair: swap the arguments"
