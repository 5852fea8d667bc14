"""Which mistake explains a number?  Every known one is tried on it, alone and then in pairs.

A number (a mass, a centre, a tensor, a length, a twist) is wrong if the two files disagree about
it.  A mistake explains it if repairing the mistake makes them agree:

- *to the digits*: to one part in ten thousand, the resolution of four printed digits.  Of the few
  dozen values that a number could be repaired to, none comes that close by chance.
- *to the noise*: when two models differ everywhere by a few per cent, as two measurements do,
  repairing can only bring a number back among the others.  The number must then differ by more
  than five times that noise before, and by less than five times it after.

Otherwise no known mistake explains the number.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..._robot.transforms import Array
from .link_numbers import Body, LinkPair, changed_bodies
from .mistake import LinkMistake, Quantity, changed, value_of
from .mistakes import LINK_MISTAKES

__all__ = [
    "DIGITS",
    "Candidate",
    "Mismatch",
    "disagreements",
    "explanations",
    "stands_out",
    "usual_gap",
]

#: Numbers that agree to four digits agree.
DIGITS = 1e-4

_STANDS_OUT = 5.0  # times the noise, before repairing
_VANISHES = 5.0  # times the noise, after: repairing may depend on several noisy numbers
_MOST_NOISE = 0.06  # models that differ more than this everywhere are not two measurements of one
_HELPS = 5.0  # repairing must bring a number at least so much closer

_INERTIAL: tuple[Quantity, ...] = ("mass", "centre", "tensor")
_GEOMETRIC: tuple[Quantity, ...] = ("link_vector", "rotation")


@dataclass(frozen=True)
class Mismatch:
    """A number on which the two sides disagree.

    link : from 0;  gap : relative disagreement
    """

    link: int
    quantity: Quantity
    gap: float


@dataclass(frozen=True, eq=False)
class Candidate:
    """A mistake (or two in one number) that explains a disagreement.

    mistakes, hows : what was done wrong, in the order of repairing
    value : the repaired number;  after : the gap that is left
    choices : how many repaired values were tried for this number
    """

    mismatch: Mismatch
    mistakes: tuple[LinkMistake, ...]
    hows: tuple[str, ...]
    value: Any
    after: float
    choices: int

    @property
    def ids(self) -> tuple[str, ...]:
        """The mistakes' ids, in the order of the list of mistakes."""
        return tuple(mistake.id for mistake in self.in_order_of_the_list())

    def in_order_of_the_list(self) -> tuple[LinkMistake, ...]:
        """The mistakes, the likelier first."""
        return tuple(mistake for mistake in LINK_MISTAKES if mistake in self.mistakes)


def disagreements(link_pair: LinkPair, geometry: bool) -> list[Mismatch]:
    """How far suspect and truth are apart on every number; geometry where axes do not coincide.

    A centre of mass is measured against the arm's size too, so that a micrometre on a centre that
    lies at the origin is not all of it.
    """
    size = max(float(np.linalg.norm(body.link_vector)) for body in link_pair.truth)
    floors = {"centre": 0.01 * size, "link_vector": 0.01 * size}
    return [
        Mismatch(i, quantity, _gap(quantity, own, truth, floors.get(quantity, 0.0)))
        for i, (own, truth) in enumerate(zip(link_pair.bodies, link_pair.truth, strict=True))
        for quantity in (*_INERTIAL, *_GEOMETRIC)[: 5 if geometry else 3]
    ]


def explanations(link_pair: LinkPair, mismatch: Mismatch, noise: float) -> list[Candidate]:
    """Everything that explains a disagreement about as well as the best, the likelier first.

    noise : the median gap between these two models
    """
    alone = list(_singles(link_pair, mismatch.link, mismatch.quantity))
    found = _good_enough(mismatch, alone, DIGITS)
    if not found and stands_out(mismatch, noise):
        pairs = list(_pairs(link_pair, mismatch.link, mismatch.quantity))
        found = _good_enough(mismatch, pairs, DIGITS, len(alone) + len(pairs))
    if not found and DIGITS < noise < _MOST_NOISE and stands_out(mismatch, noise):
        found = _good_enough(mismatch, alone, _VANISHES * noise)
    return found


def usual_gap(mismatches: Iterable[Mismatch]) -> float:
    """The median disagreement of inertial numbers: that of two measurements.

    Lengths are left out: they are copied from data sheets, not measured.
    """
    return float(np.median([m.gap for m in mismatches if m.quantity in _INERTIAL]))


def stands_out(mismatch: Mismatch, noise: float) -> bool:
    """Whether a number differs by more than the noise of two measurements explains."""
    return mismatch.gap > max(DIGITS, _STANDS_OUT * noise if noise < _MOST_NOISE else 0.0)


_Tried = tuple[tuple[LinkMistake, ...], tuple[str, ...], Any, float]


def _singles(link_pair: LinkPair, i: int, quantity: Quantity) -> Iterator[_Tried]:
    tried = [
        (mistake, how, value)
        for mistake in LINK_MISTAKES
        if mistake.quantity == quantity
        for how, value in mistake.repairs(link_pair, i)
    ]
    gaps = _gaps(quantity, [value for *_, value in tried], link_pair.truth[i])
    for (mistake, how, value), gap in zip(tried, gaps.tolist(), strict=True):
        yield (mistake,), (how,), value, gap


def _pairs(link_pair: LinkPair, i: int, quantity: Quantity) -> Iterator[_Tried]:
    """Two different mistakes in one number, one repaired after the other."""
    for (first,), (how,), value, _ in _singles(link_pair, i, quantity):
        if first.alone:
            continue
        half_repaired = changed_bodies(link_pair, i, changed(link_pair.bodies[i], quantity, value))
        for (second,), (then,), repaired, gap in _singles(half_repaired, i, quantity):
            if second is not first and not second.alone:
                yield (first, second), (how, then), repaired, gap


def _good_enough(
    mismatch: Mismatch, tried: list[_Tried], bound: float, choices: int | None = None
) -> list[Candidate]:
    """Those within the bound that repair about as well as the best, one for each set of
    mistakes.
    """
    good = [t for t in tried if t[3] <= bound and t[3] < mismatch.gap / _HELPS]
    best = min((gap for *_, gap in good), default=0.0)
    candidates: dict[tuple[str, ...], Candidate] = {}
    for mistakes, hows, value, gap in good:
        if gap <= max(2.0 * best, DIGITS / 100):
            candidate = Candidate(mismatch, mistakes, hows, value, gap, choices or len(tried))
            candidates.setdefault(candidate.ids, candidate)
    return list(candidates.values())


def _gap(quantity: Quantity, own: Body, truth: Body, floor: float = 0.0) -> float:
    return float(_gaps(quantity, [value_of(own, quantity)], truth, floor)[0])


def _gaps(quantity: Quantity, values: Sequence[Any], truth: Body, floor: float = 0.0) -> Array:
    """How far each value is from the truth, relative to the larger; a twist by its angle [rad].

    All at once, shape (len(values),): pairs of mistakes try tens of thousands of values.
    """
    if quantity == "body":
        parts = ([value_of(body, part) for body in values] for part in _INERTIAL)
        gaps = [_gaps(part, found, truth) for part, found in zip(_INERTIAL, parts, strict=True)]
        return np.asarray(np.max(gaps, axis=0))
    true = np.ravel(value_of(truth, quantity))
    found = np.array(values, dtype=np.float64).reshape(-1, len(true))
    difference = _lengths(found - true)
    if quantity == "rotation":
        return difference
    scale = np.maximum(_lengths(found), max(float(_lengths(true)), floor))
    return np.divide(difference, scale, out=np.zeros_like(scale), where=scale > 0.0)


def _lengths(vectors: Array) -> Array:
    return np.asarray(np.sqrt((vectors * vectors).sum(axis=-1)))
