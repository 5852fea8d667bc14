"""Findings in words: where, what happened, and what to do."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..arm_pair import Side
from ..difference_summary import base_in_words, listed
from .arm_mistakes import WholeArm
from .cylinder_fit import fit_cylinder
from .link_numbers import Body
from .mistake import Quantity
from .mistake_search import Mismatch
from .pair_readings import Explained

__all__ = ["finding_in_words", "remark", "whole_arm_in_words"]


def finding_in_words(
    group: Sequence[Explained], names: Mapping[Side, str]
) -> tuple[str, str, tuple[str, ...]]:
    """(sentence, advice, a detail for each link) for one mistake, made in one or more links."""
    ordered = sorted(group, key=lambda e: e.candidate.mismatch.link)
    candidate = ordered[0].candidate
    links = [str(e.candidate.mismatch.link + 1) for e in ordered]
    where = f"Link{'s' if len(links) > 1 else ''} {listed(links)}"
    arm = "one of the two" if all(e.either for e in ordered) else names[ordered[0].side]
    what = ", and ".join(mistake.says for mistake in candidate.mistakes)
    hows = {e.candidate.hows for e in ordered}
    if len(hows) == 1:  # made in the same way everywhere: worth saying at once
        what += f" ({', '.join(candidate.hows)})"
    advice = "; ".join(dict.fromkeys(mistake.repair for mistake in candidate.mistakes))
    details = tuple(
        f"link {link}: {_detail(explained)}" for link, explained in zip(links, ordered, strict=True)
    )
    return f"{where} of {arm}: {what}", advice, details


def _detail(explained: Explained) -> str:
    """How the mistake was made in one link, and the cylinder behind a tensor."""
    said = ", ".join(explained.candidate.hows)
    if explained.candidate.mismatch.quantity != "tensor":
        return said
    written = fit_cylinder(explained.body.mass, explained.body.tensor)
    repaired = fit_cylinder(explained.body.mass, explained.candidate.value)
    if repaired is None:
        return said
    instead = f" (as written: {written})" if written is not None and written != repaired else ""
    return f"{said}; repaired, {repaired}{instead}"


def remark(mismatch: Mismatch, bodies: Mapping[Side, Body], names: Mapping[Side, str]) -> str:
    """A number that no known mistake explains, with the cylinders behind a tensor."""
    number = f"link {mismatch.link + 1}'s {_WORDS[mismatch.quantity]}"
    said = f"No single known mistake explains {number}"
    if mismatch.quantity != "tensor":
        return f"{said} ({mismatch.gap:.2g} apart)"
    cylinders = [
        f"{names[side]} has {fitted}"
        for side, body in bodies.items()
        if (fitted := fit_cylinder(body.mass, body.tensor)) is not None
    ]
    return f"{said} ({'; '.join(cylinders) or f'{mismatch.gap:.2g} apart'})"


_WORDS: dict[Quantity, str] = {
    "mass": "mass",
    "centre": "centre of mass",
    "tensor": "tensor",
    "link_vector": "length",
    "rotation": "twist",
    "body": "inertia",
}


def whole_arm_in_words(whole: WholeArm, names: Mapping[Side, str]) -> tuple[str, str]:
    """(sentence, advice) for what concerns the whole arm."""
    b = names["b"]
    joints = listed([str(number) for number, _ in whole.joints]) if whole.joints else ""
    match whole.id:
        case "dh-convention":
            arm = names[whole.side or "b"]
            return (
                f"The DH table of {arm} reads by the other convention (standard, modified)",
                'say which: convention = "standard" or "modified"',
            )
        case "joint-reversed":
            return f"Joint {joints} of {b} turns the other way", "compare at q_b = −q_a there"
        case "zero-shifted":
            angles = listed([f"{np.degrees(value):+.4g}°" for _, value in whole.joints])
            return (
                f"Joint {joints} of {b} counts from another zero ({angles})",
                "add the offset when states are exchanged",
            )
        case "motor-inertia":
            motors = np.zeros((2, 0)) if whole.motors is None else whole.motors
            with_motors = [names["a"]] if motors[0].any() else []
            only = [*with_motors, names["b"]] if motors[1].any() else with_motors
            where = f"in {only[0]} only" if len(only) == 1 else "different in the two"
            return (
                f"The motor inertia of joint {joints} is {where}",
                "reflect it through the gear, n² J, in both models or in neither",
            )
        case "base-turned":
            return (
                f"The base of {b} is {base_in_words(whole.base)}",
                "turn poses, and gravity, when they are exchanged",
            )
        case _:
            sizes = [f"{np.linalg.norm(g):.6g}" for g in whole.gravity or ()]
            words = {
                "gravity-sign": "Gravity points up in one of the two",
                "gravity-value": f"Gravity is {' and '.join(sizes)} m/s² in {names['a']} and {b}",
            }.get(whole.id, "Gravity points another way")
            return words, "compare under one gravity: --gravity X Y Z"
