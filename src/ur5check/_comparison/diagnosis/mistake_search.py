"""Which mistake explains a number?  Every known one is tried on it, alone and then in pairs.

A number (a mass, a centre, a tensor, a length, a twist) is wrong if the two files disagree about
it.  A mistake explains it if mending the mistake makes them agree:

- *to the digits*: to one part in ten thousand, which is what four printed digits can tell.  Of the
  few dozen values that a number could be mended to, none comes that close by chance.
- *to the noise*: when two models differ everywhere by a few per cent, as honest measurements do,
  mending can only bring a number back among the others.  The mistake must then stand out from that
  noise by a factor of five, and vanish in it.

Otherwise no known mistake explains the number, and that is what is said.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..._robot.transforms import Array
from .link_numbers import Body, Scene, changed_bodies
from .mistake import Mistake, Quantity, changed, value_of
from .mistakes import CATALOGUE

__all__ = [
    "DIGITS",
    "Suspicion",
    "Verdict",
    "disagreements",
    "explanations",
    "stands_out",
    "usual_gap",
]

#: Numbers that agree to four digits agree.
DIGITS = 1e-4

_STANDS_OUT = 5.0  # times the noise, before mending
_VANISHES = 5.0  # times the noise, after: mending may lean on several noisy numbers
_MOST_NOISE = 0.06  # models that differ more than this everywhere are not two measurements of one
_HELPS = 5.0  # mending must bring a number at least so much closer

_INERTIAL: tuple[Quantity, ...] = ("mass", "centre", "tensor")
_GEOMETRIC: tuple[Quantity, ...] = ("reach", "turn")


@dataclass(frozen=True)
class Suspicion:
    """A number on which the two sides disagree.

    link : from 0;  gap : relative disagreement
    """

    link: int
    quantity: Quantity
    gap: float


@dataclass(frozen=True, eq=False)
class Verdict:
    """A mistake (or two in one number) that explains a disagreement.

    mistakes, hows : what was done wrong, in the order of mending
    value : the mended number;  after : the gap that is left
    choices : how many mended values were tried for this number
    """

    suspicion: Suspicion
    mistakes: tuple[Mistake, ...]
    hows: tuple[str, ...]
    value: Any
    after: float
    choices: int

    @property
    def ids(self) -> tuple[str, ...]:
        """The mistakes' ids, in the catalogue's order."""
        return tuple(m.id for m in CATALOGUE if m in self.mistakes)


def disagreements(scene: Scene, geometry: bool) -> list[Suspicion]:
    """How far suspect and truth are apart on every number; geometry where axes do not coincide.

    A centre of mass is measured against the arm's size too, so that a micrometre on a centre that
    lies at the origin is not all of it.
    """
    size = max(float(np.linalg.norm(body.reach)) for body in scene.truth)
    floors = {"centre": 0.01 * size, "reach": 0.01 * size}
    return [
        Suspicion(i, quantity, _gap(quantity, own, truth, floors.get(quantity, 0.0)))
        for i, (own, truth) in enumerate(zip(scene.bodies, scene.truth, strict=True))
        for quantity in (*_INERTIAL, *_GEOMETRIC)[: 5 if geometry else 3]
    ]


def explanations(scene: Scene, suspicion: Suspicion, noise: float) -> list[Verdict]:
    """Everything that explains a disagreement about as well as the best, the likelier first.

    noise : the gap that is usual between these two models
    """
    alone = list(_singles(scene, suspicion.link, suspicion.quantity))
    found = _good_enough(suspicion, alone, DIGITS)
    if not found and stands_out(suspicion, noise):
        pairs = list(_pairs(scene, suspicion.link, suspicion.quantity))
        found = _good_enough(suspicion, pairs, DIGITS, len(alone) + len(pairs))
    if not found and DIGITS < noise < _MOST_NOISE and stands_out(suspicion, noise):
        found = _good_enough(suspicion, alone, _VANISHES * noise)
    return found


def usual_gap(suspicions: Iterable[Suspicion]) -> float:
    """The median disagreement of inertial numbers: what two honest measurements leave.

    Lengths are left aside: they are copied from data sheets, not measured.
    """
    return float(np.median([s.gap for s in suspicions if s.quantity in _INERTIAL]))


def stands_out(suspicion: Suspicion, noise: float) -> bool:
    """Whether a number is further off than honest measurement would have it."""
    return suspicion.gap > max(DIGITS, _STANDS_OUT * noise if noise < _MOST_NOISE else 0.0)


_Tried = tuple[tuple[Mistake, ...], tuple[str, ...], Any, float]


def _singles(scene: Scene, i: int, quantity: Quantity) -> Iterator[_Tried]:
    tried = [
        (mistake, how, value)
        for mistake in CATALOGUE
        if mistake.quantity == quantity
        for how, value in mistake.remedies(scene, i)
    ]
    gaps = _gaps(quantity, [value for *_, value in tried], scene.truth[i])
    for (mistake, how, value), gap in zip(tried, gaps.tolist(), strict=True):
        yield (mistake,), (how,), value, gap


def _pairs(scene: Scene, i: int, quantity: Quantity) -> Iterator[_Tried]:
    """Two different mistakes in one number, one mended after the other."""
    for (first,), (how,), value, _ in _singles(scene, i, quantity):
        if first.alone:
            continue
        half_mended = changed_bodies(scene, i, changed(scene.bodies[i], quantity, value))
        for (second,), (then,), mended, gap in _singles(half_mended, i, quantity):
            if second is not first and not second.alone:
                yield (first, second), (how, then), mended, gap


def _good_enough(
    suspicion: Suspicion, tried: list[_Tried], bound: float, choices: int | None = None
) -> list[Verdict]:
    """Those within the bound that mend about as well as the best, one for each set of mistakes."""
    good = [t for t in tried if t[3] <= bound and t[3] < suspicion.gap / _HELPS]
    best = min((gap for *_, gap in good), default=0.0)
    verdicts: dict[tuple[str, ...], Verdict] = {}
    for mistakes, hows, value, gap in good:
        if gap <= max(2.0 * best, DIGITS / 100):
            verdict = Verdict(suspicion, mistakes, hows, value, gap, choices or len(tried))
            verdicts.setdefault(verdict.ids, verdict)
    return list(verdicts.values())


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
    if quantity == "turn":
        return difference
    scale = np.maximum(_lengths(found), max(float(_lengths(true)), floor))
    return np.divide(difference, scale, out=np.zeros_like(scale), where=scale > 0.0)


def _lengths(vectors: Array) -> Array:
    return np.asarray(np.sqrt((vectors * vectors).sum(axis=-1)))
