"""The numbers behind a difference as their files have them: file, line, text."""

from __future__ import annotations

import math
from dataclasses import replace

from .._comparison.arm_pair import Side
from .._comparison.diagnosis.diagnosis import Diagnosis, RecognizedMistake
from .._comparison.diagnosis.mistake_search import Mismatch
from .._comparison.difference import Difference
from .._io.urdf.urdf_changes import NumberChange, changed_urdf
from .._robot.serial_arm import SerialArm

__all__ = ["numbers_of_mismatch", "numbers_of_mistake"]

_BODY = ("mass", "centre", "tensor")


def numbers_of_mistake(
    found: RecognizedMistake, d: Difference, diagnosis: Diagnosis
) -> tuple[str, ...]:
    """What is written and what should be, "arm.urdf:12:5: 0 0 -0.28 → 0 0 0.28" each.

    Nothing of an arm that was read from another format than URDF and xacro.
    """
    side: Side = found.side or "b"
    given, repaired = {
        "a": (d.pair.a, diagnosis.repaired_a),
        "b": (d.pair.given_b, diagnosis.repaired_b),
    }[side]
    quantities = {mistake.spoils for mistake in found.mistakes}
    links = set(found.links)
    return tuple(
        f"{change.place}: {' → '.join(_values(change))}"
        for change in _changes(given, repaired)
        if change.link in links and _SPOILED[change.quantity] & quantities
    )


def numbers_of_mismatch(mismatch: Mismatch, d: Difference) -> tuple[str, ...]:
    """What B's file has where A's says otherwise, in the frame of B's file."""
    if mismatch.quantity not in _BODY:
        return ()
    b, i = d.pair.given_b, mismatch.link
    of_a = d.pair.a.links[i].inertia.expressed_in(d.pair.link_maps[i].inverse())
    link = replace(b.links[i], inertia=of_a)
    other = replace(b, links=(*b.links[:i], link, *b.links[i + 1 :]))
    return tuple(
        f"{change.place}: {', against '.join(_values(change))}{_decimal_point(change)}"
        for change in _changes(b, other)
        if change.quantity == mismatch.quantity
    )


def _changes(given: SerialArm, other: SerialArm) -> tuple[NumberChange, ...]:
    changed = changed_urdf(given, other)
    return () if changed is None else changed.changes


#: What mistakes may say that they spoil where these numbers are wrong (`Mistake.spoils`).
_SPOILED = {
    "mass": {"mass", "mass, centre and tensor"},
    "centre": {"centre of mass", "mass, centre and tensor"},
    "tensor": {"tensor", "mass, centre and tensor"},
    "link_vector": {"length"},
    "rotation": {"twist"},
}


def _values(change: NumberChange) -> tuple[str, str]:
    """The number's name and text, and what is to be there; of a list the only one that differs."""
    name = change.what.rpartition("' ")[2]  # its element is told by the place
    apart = _apart(change)
    if len(apart) == 1 and len(change.old.split()) > 1:
        (k, old, new), *_ = apart
        return f"{name} {'xyz'[k]} {old}", new
    return f"{name} {change.old.strip() or 'left out'}", change.new.strip()


def _apart(change: NumberChange) -> list[tuple[int, str, str]]:
    """The words that differ, and which they are."""
    pairs = enumerate(zip(change.old.split(), change.new.split(), strict=False))
    return [(k, old, new) for k, (old, new) in pairs if old != new]


def _decimal_point(change: NumberChange) -> str:
    """That two numbers are the same but for a power of ten."""
    apart = _apart(change)
    if len(apart) != 1:
        return ""
    x, y = (float(word) for word in apart[0][1:])
    if x * y <= 0.0:
        return ""
    places = math.log10(x / y)
    whole = round(places)
    # Printed digits of the one may be cut off in the other.
    return (
        f" (its decimal point is {abs(whole)} place{'s' if abs(whole) > 1 else ''} off)"
        if whole and abs(places - whole) < 1e-4
        else ""
    )
