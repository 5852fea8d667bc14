"""`diff --mend`: B with its known mistakes mended, as a URDF, and in words what was done to it."""

from __future__ import annotations

from collections.abc import Callable

from .._comparison.diagnosis.diagnosis import Diagnosis, Finding
from .._comparison.explanation import Explanation
from .._io.urdf.urdf_writer import urdf_of
from .output import emit

__all__ = ["mend"]

#: What no file of B has to be mended for: an agreement between those who exchange states.
_AGREEMENTS = ("base-turned", "joint-reversed", "zero-shifted")


def mend(explanation: Explanation, file: str, say: Callable[[str], None]) -> None:
    """Write the mended B, and say of every finding what became of it.

    Nothing is written where there is nothing to mend in B.  Raises UsageError if the file cannot be
    written.
    """
    diagnosis = explanation.diagnosis
    mended = [finding for finding in diagnosis.findings if _mended_in_b(finding, diagnosis)]
    if mended:
        emit(urdf_of(diagnosis.mended_b), file, option="--mend")
    for finding in diagnosis.findings:
        say(f"mended: {finding.sentence}" if finding in mended else _not_mended(finding))
    if diagnosis.unexplained:
        numbers = ", ".join(f"link {s.link + 1}'s {s.quantity}" for s in diagnosis.unexplained)
        say(f"not mended: no known mistake explains {numbers}")
    name = explanation.difference.pair.b.name
    say(f"wrote {file}" if mended else f"{file} is not written: nothing to mend in {name}")


def _mended_in_b(finding: Finding, diagnosis: Diagnosis) -> bool:
    if finding.side == "a":
        return False
    if not finding.links:
        return finding.side == "b" and finding.id not in _AGREEMENTS
    before, after = diagnosis.pair.given_b.links, diagnosis.mended_b.links
    return all(after[link - 1] is not before[link - 1] for link in finding.links)


def _not_mended(finding: Finding) -> str:
    if finding.id in _AGREEMENTS:
        return f"nothing to mend: {finding.sentence}; {finding.advice}"
    if finding.id.startswith("gravity-"):
        return f"not mended: {finding.sentence}; a URDF carries no gravity: give --gravity X Y Z"
    return f"not mended: {finding.sentence}; A is the one to mend: swap the arguments"
