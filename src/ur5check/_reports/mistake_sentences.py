"""Recognised mistakes in words, and as findings: where, what happened, and what to do."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from .._arguments import instance
from .._comparison.arm_pair import Pair, Side
from .._comparison.diagnosis.cylinder_fit import Cylinder, fit_cylinder
from .._comparison.diagnosis.diagnosis import Diagnosis, RecognizedMistake
from .._comparison.diagnosis.link_numbers import body_of
from .._comparison.diagnosis.mistake import ArmDifference, ArmMistake, Mistake, Quantity
from .._comparison.diagnosis.mistake_search import Mismatch
from .._comparison.diagnosis.pair_readings import Explained
from .._finding import Finding
from .difference_summary import base_in_words
from .rounding_sentences import constant_in_words
from .wording import joined

__all__ = ["advice", "details", "findings", "remark", "sentence", "subject"]


def findings(diagnosis: Diagnosis) -> tuple[Finding, ...]:
    """Every recognised mistake as a finding, in the order of repairing; two mistakes in one number
    make two findings.
    """
    return tuple(
        Finding(
            rule=mistake.rule_id,
            severity=mistake.severity,
            subject=subject(found, diagnosis.pair),
            message=_message(found, diagnosis.pair),
            consequence=mistake.consequence,
            fix=mistake.repair,
            effect=found.before - found.after,
        )
        for found in diagnosis.mistakes
        for mistake in found.mistakes
    )


def subject(found: RecognizedMistake, pair: Pair) -> str:
    """Where the mistake is: "links 2, 3 and 5 of paper-listing"."""
    names = _names(pair)
    if not found.links:
        return f"robot '{names[found.side or 'b']}'"
    arm = "one of the two" if found.side is None else names[found.side]
    return f"link{'s' if len(found.links) > 1 else ''} {joined([*map(str, found.links)])} of {arm}"


def sentence(found: RecognizedMistake, pair: Pair) -> str:
    """A recognised mistake as a sentence: where it was made, and what it is.

    Parameters
    ----------
    found : RecognizedMistake
        One of `Diagnosis.mistakes`.
    pair : Pair
        `Diagnosis.pair`.

    Returns
    -------
    str

    Raises
    ------
    UsageError
        For other types.

    Examples
    --------
    >>> import ur5check
    >>> arm = ur5check.load("paper")
    >>> pair = ur5check.pair_up(arm, arm.with_gravity(-arm.gravity))
    >>> found = ur5check.diagnose(pair, ur5check.random_states(6, 5, seed=0))
    >>> ur5check.mistake_sentence(found.mistakes[0], found.pair)
    'Gravity points up in one of the two'
    """
    instance("found", found, RecognizedMistake, "see Diagnosis.mistakes")
    instance("pair", pair, Pair, "see Diagnosis.pair")
    if found.difference is not None:
        return _message(found, pair)
    where = subject(found, pair)
    return f"{where[0].upper()}{where[1:]}: {_message(found, pair)}"


def advice(found: RecognizedMistake) -> str:
    """The repairs of a recognised mistake, as imperatives.

    Parameters
    ----------
    found : RecognizedMistake
        One of `Diagnosis.mistakes`.

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
    >>> arm = ur5check.load("paper")
    >>> pair = ur5check.pair_up(arm, arm.with_gravity(-arm.gravity))
    >>> found = ur5check.diagnose(pair, ur5check.random_states(6, 5, seed=0))
    >>> ur5check.mistake_advice(found.mistakes[0])
    'compare under one gravity: --gravity X Y Z'
    """
    instance("found", found, RecognizedMistake, "see Diagnosis.mistakes")
    return "; ".join(dict.fromkeys(mistake.repair for mistake in _in_order_of_repairing(found)))


def details(found: RecognizedMistake) -> tuple[str, ...]:
    """How a mistake was made, link by link.

    Parameters
    ----------
    found : RecognizedMistake
        One of `Diagnosis.mistakes`.

    Returns
    -------
    tuple of str
        Empty for a mistake of the whole arm.

    Raises
    ------
    UsageError
        For another type.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("paper", "paper-listing")
    >>> found = ur5check.diagnose(pair, ur5check.random_states(6, 5, seed=0))
    >>> all(len(ur5check.mistake_details(m)) == len(m.links) for m in found.mistakes if m.explained)
    True
    """
    instance("found", found, RecognizedMistake, "see Diagnosis.mistakes")
    if found.difference is not None:
        return ()
    return tuple(
        f"link {link}: {_detail(explained)}"
        for link, explained in zip(found.links, found.explained, strict=True)
    )


def remark(mismatch: Mismatch, diagnosis: Diagnosis) -> str:
    """A number that no known mistake explains, as a sentence, with the cylinders behind a tensor.

    Parameters
    ----------
    mismatch : Mismatch
        One of `Diagnosis.unexplained`.
    diagnosis : Diagnosis
        See `diagnose`.

    Returns
    -------
    str

    Raises
    ------
    UsageError
        For other types.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("appendix", "erd-ur5")
    >>> found = ur5check.diagnose(pair, ur5check.random_states(6, 5, seed=0))
    >>> ur5check.mismatch_sentence(found.unexplained[0], found)[:56]
    "No single known mistake explains link 3's tensor (append"
    """
    instance("mismatch", mismatch, Mismatch, "see Diagnosis.unexplained")
    instance("diagnosis", diagnosis, Diagnosis, "see ur5check.diagnose")
    number = f"link {mismatch.link + 1}'s {_WORDS[mismatch.quantity]}"
    start = f"No single known mistake explains {number}"
    cylinders = []
    if mismatch.quantity == "tensor":
        for side, name in _names(diagnosis.pair).items():
            body = body_of(diagnosis.aligned[side], mismatch.link)
            fitted = fit_cylinder(body.mass, body.tensor)
            if fitted is not None:
                cylinders.append(f"{name} has {_cylinder_in_words(fitted)}")
    return f"{start} ({'; '.join(cylinders) or f'{mismatch.gap:.2g} apart'})"


_WORDS: dict[Quantity, str] = {
    "mass": "mass",
    "centre": "centre of mass",
    "tensor": "tensor",
    "link_vector": "length",
    "rotation": "twist",
    "body": "inertia",
}


def _names(pair: Pair) -> dict[Side, str]:
    return {"a": pair.a.label, "b": pair.b.label}


def _in_order_of_repairing(found: RecognizedMistake) -> Sequence[Mistake]:
    return found.explained[0].candidate.mistakes if found.explained else found.mistakes


def _message(found: RecognizedMistake, pair: Pair) -> str:
    """What happened, as a clause."""
    if found.difference is not None:
        values = _values(found.difference, _names(pair))
        clauses = (
            mistake.sentence for mistake in found.mistakes if isinstance(mistake, ArmMistake)
        )
        return "; ".join(clause.format_map(values) for clause in clauses)
    candidate = found.explained[0].candidate
    what = ", and ".join(mistake.says for mistake in candidate.mistakes)
    # Made in the same way in every link: part of the message.
    if len({e.candidate.hows for e in found.explained}) == 1:
        what += f" ({', '.join(candidate.hows)})"
    return what


def _values(found: ArmDifference, names: Mapping[Side, str]) -> dict[str, str]:
    """What the sentences of mistakes of the whole arm may contain."""
    having = [
        name for name, motors in zip(names.values(), found.motors, strict=True) if motors.any()
    ]
    joints = [str(number) for number, _ in found.joints]
    return {
        "a": names["a"],
        "b": names["b"],
        "arm": names[found.side or "b"],
        "joints": f"joint{'s' if len(found.joints) > 1 else ''} {joined(joints)}",
        "angles": joined([f"{np.degrees(value):+.4g}°" for _, value in found.joints]),
        "base": base_in_words(found.base),
        "gravity": joined([f"{np.linalg.norm(g):.6g}" for g in found.gravity]),
        "rounded": "" if found.rounded is None else constant_in_words(found.rounded),
        "motors": f"in {having[0]} only" if len(having) == 1 else "different in the two",
    }


def _detail(explained: Explained) -> str:
    """How the mistake was made in one link, and the cylinder behind a tensor."""
    how = ", ".join(explained.candidate.hows)
    if explained.candidate.mismatch.quantity != "tensor":
        return how
    written = fit_cylinder(explained.body.mass, explained.body.tensor)
    repaired = fit_cylinder(explained.body.mass, explained.candidate.value)
    if repaired is None:
        return how
    instead = ""
    if written is not None and written != repaired:
        instead = f" (as written: {_cylinder_in_words(written)})"
    return f"{how}; repaired, {_cylinder_in_words(repaired)}{instead}"


def _cylinder_in_words(cylinder: Cylinder) -> str:
    return (
        f"a cylinder of radius {cylinder.radius:.4g} m and length {cylinder.length:.4g} m "
        f"along {'xyz'[cylinder.axis]}"
    )
