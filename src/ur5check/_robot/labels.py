"""Labels that tell models apart, wherever several are spoken of at once."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import PurePath
from string import ascii_uppercase

from .serial_arm import SerialArm

__all__ = ["labelled"]


def labelled(arms: Sequence[SerialArm]) -> tuple[SerialArm, ...]:
    """The arms with labels of which no two are equal, in the same order.

    An arm is labelled by its name; where two have the same name, by the name of its file; where
    these are equal too (or there is no file), by a letter: A for the first arm, B for the second.
    Arms whose labels differ already keep them.
    """
    labels = [arm.label for arm in arms]
    labels = _replaced(labels, [_file_name(arm) for arm in arms])
    labels = _replaced(labels, [_letter(i) for i in range(len(arms))])
    return tuple(
        arm if arm.label == label else replace(arm, given_label=label)
        for arm, label in zip(arms, labels, strict=True)
    )


def _replaced(labels: list[str], others: list[str]) -> list[str]:
    """`others` in the place of labels that occur more than once, if that sets these apart."""
    count = Counter(labels)
    result = []
    for label in dict.fromkeys(labels):
        group = [i for i, other in enumerate(labels) if other == label]
        names = [others[i] for i in group]
        taken = set(count) - {label}
        if len(group) > 1 and all(names) and len(set(names)) == len(names) and not taken & {*names}:
            result += list(zip(group, names, strict=True))
        else:
            result += [(i, label) for i in group]
    return [label for _, label in sorted(result)]


def _file_name(arm: SerialArm) -> str:
    return PurePath(arm.source.inputs[0][0]).name if arm.source.inputs else ""


def _letter(i: int) -> str:
    return ascii_uppercase[i] if i < len(ascii_uppercase) else f"model {i + 1}"
