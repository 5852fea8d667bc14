"""`diff --repair`: B with its known mistakes repaired, as a URDF; one line on each repair."""

from __future__ import annotations

from collections.abc import Callable

from .._comparison.diagnosis.diagnosis import Diagnosis, RecognizedMistake
from .._comparison.explanation import Explanation
from .._io.urdf.urdf_writer import urdf_of
from .._reports.mistake_sentences import advice, sentence
from .output import emit

__all__ = ["repair"]


def repair(explanation: Explanation, file: str, say: Callable[[str], None]) -> None:
    """Write the repaired B, and say of every mistake whether it is repaired there.

    Nothing is written where there is nothing to repair in B.  Raises UsageError if the file cannot
    be written.
    """
    diagnosis = explanation.diagnosis
    repaired = [found for found in diagnosis.mistakes if _repaired_in_b(found, diagnosis)]
    if repaired:
        emit(urdf_of(diagnosis.repaired_b), file, option="--repair")
    for found in diagnosis.mistakes:
        what = sentence(found, diagnosis.pair)
        say(f"repaired: {what}" if found in repaired else _not_repaired(found, what))
    if diagnosis.unexplained:
        numbers = ", ".join(f"link {s.link + 1}'s {s.quantity}" for s in diagnosis.unexplained)
        say(f"not repaired: no known mistake explains {numbers}")
    name = explanation.difference.pair.b.name
    say(f"wrote {file}" if repaired else f"{file} is not written: nothing to repair in {name}")


def _repaired_in_b(found: RecognizedMistake, diagnosis: Diagnosis) -> bool:
    if found.side == "a":
        return False
    if not found.links:
        return found.side == "b" and not found.is_convention
    before, after = diagnosis.pair.given_b.links, diagnosis.repaired_b.links
    return all(after[link - 1] is not before[link - 1] for link in found.links)


def _not_repaired(found: RecognizedMistake, what: str) -> str:
    if found.is_convention:
        return f"nothing to repair: {what}; {advice(found)}"
    if all(mistake.spoils == "gravity" for mistake in found.mistakes):
        return f"not repaired: {what}; a URDF carries no gravity: give --gravity X Y Z"
    return f"not repaired: {what}; A is the one to repair: swap the arguments"
