"""`diff --repair`: B with its known mistakes repaired, as a URDF; a line on each changed number.

What was read from a URDF or xacro keeps its text but for the wrong numbers
(`_io.urdf.urdf_changes`); of anything else a new URDF of the arm is written.
"""

from __future__ import annotations

from collections.abc import Callable

from .._comparison.diagnosis.diagnosis import Diagnosis, RecognizedMistake
from .._comparison.difference import Difference
from .._io.urdf.urdf_changes import changed_urdf
from .._io.urdf.urdf_writer import urdf_of
from .._reports.mistake_sentences import advice, sentence
from .output import emit

__all__ = ["repair"]


def repair(d: Difference, diagnosis: Diagnosis, file: str, say: Callable[[str], None]) -> None:
    """Write the repaired B, and say of every mistake whether it is repaired there.

    Nothing is written where there is nothing to repair in B.  Raises UsageError if the file cannot
    be written.
    """
    given = d.pair.given_b
    repaired = [found for found in diagnosis.mistakes if _repaired_in_b(found, diagnosis)]
    changed = changed_urdf(given, diagnosis.repaired_b)
    open_links = dict(changed.unwritten) if changed else {}
    done = [found for found in repaired if not open_links.keys() & found.links]
    if changed is not None:
        text, written = changed.text, bool(changed.changes)
    else:
        text, written = urdf_of(diagnosis.repaired_b) if done else "", bool(done)
    if written:
        emit(text, file, option="--repair")
    for found in diagnosis.mistakes:
        what = sentence(found, diagnosis.pair)
        if found in done:
            say(f"repaired: {what}")
        elif found in repaired:
            why = "; ".join(open_links[link] for link in found.links if link in open_links)
            say(f"not repaired: {what}; correct it by hand: {why}")
        else:
            say(_not_repaired(found, what))
    if diagnosis.unexplained:
        numbers = ", ".join(f"link {s.link + 1}'s {s.quantity}" for s in diagnosis.unexplained)
        say(f"not repaired: no known mistake explains {numbers}")
    for change in changed.changes if changed else ():
        say(f"{change.place}: {change.what}: {change.old or 'left out'} → {change.new}")
    if not written:
        say(f"{file} is not written: nothing to repair in {given.name}")
        return
    of = ""
    if changed is None:
        of = f": a new URDF, since {given.label} is no URDF"
    elif given.source.kind == "xacro":
        of = ": the expanded xacro"
    say(f"wrote {file}{of}")


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
