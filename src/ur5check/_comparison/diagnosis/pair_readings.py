"""Ways to read a pair of arms, and what would explain each number under each of them.

The same two files can be read in several ways: joints reversed and shifted so that the axes
coincide, or joint angles as they stand and a sign lost in a length; a DH table by the standard rule
or by the modified one.  The reading that leaves fewest numbers unexplained, with fewest mistakes,
is taken.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array
from ..alignment import SAME_ANGLE, SAME_LENGTH
from ..arm_pair import Pair, Side, pair_as_written, pair_up
from .dh_convention import read_by_the_other_rule
from .link_numbers import Body, LinkPair
from .mistake_search import (
    DIGITS,
    Candidate,
    Mismatch,
    disagreements,
    explanations,
    stands_out,
    usual_gap,
)

__all__ = ["Explained", "Reading", "best_reading"]

#: Below this, two numbers are the same: rounding of the frames they are compared in.
_SAME = DIGITS / 100

#: (side, ids of the mistakes)
Kind = tuple[Side, tuple[str, ...]]


@dataclass(frozen=True, eq=False)
class Explained:
    """One number that a mistake explains.

    side : the arm it is taken to be in;  either : nothing decides which of the two
    body : the link as that side has it
    equals : other mistakes that explain it as well, their ids joined by " + "
    in_b : how repairing b would do it, if it would
    """

    side: Side
    either: bool
    candidate: Candidate
    body: Body
    equals: tuple[str, ...]
    in_b: Candidate | None

    @property
    def kind(self) -> Kind:
        return self.side, self.candidate.ids


@dataclass(frozen=True, eq=False)
class Reading:
    """One way to read a pair.

    rule : the side whose DH table was read by the other rule, if any
    noise : the disagreement that is usual between the two sources' inertial numbers
    """

    pair: Pair
    rule: Side | None
    explained: tuple[Explained, ...]
    unexplained: tuple[Mismatch, ...]
    noise: float

    @property
    def moved(self) -> Array:
        """Which joints this reading reverses or shifts, shape (n,)."""
        alignment = self.pair.alignment
        return np.asarray((alignment.signs < 0) | (np.abs(alignment.offsets) > SAME_ANGLE))

    @property
    def unexplained_count(self) -> int:
        """How many unexplained numbers stand out from the noise."""
        return sum(stands_out(mismatch, self.noise) for mismatch in self.unexplained)

    @property
    def cost(self) -> tuple[int, int]:
        """What stays unexplained, then how many assumptions the reading makes.

        Each kind of mistake, each number that it explains, a turned base and another DH convention
        are one assumption.  So is a joint that is reversed or shifted, and two more if the shift
        is no whole number of degrees: people choose round zeros.
        """
        alignment = self.pair.alignment
        kinds = {explained.kind for explained in self.explained}
        degrees = np.degrees(alignment.offsets)
        odd = self.moved & (np.abs(degrees - np.rint(degrees)) > 1e-6)
        assumptions = len(kinds) + len(self.explained) + int(self.moved.sum()) + 2 * int(odd.sum())
        assumptions += int(alignment.T_ab.angle() > SAME_ANGLE) + (self.rule is not None)
        return self.unexplained_count, assumptions

    @property
    def ids(self) -> tuple[str, ...]:
        """The mistakes in links that this reading assumes."""
        return tuple(dict.fromkeys(" + ".join(e.candidate.ids) for e in self.explained))


def best_reading(pair: Pair) -> tuple[Reading, tuple[str, ...]]:
    """The reading of a pair with fewest assumptions.

    Also the mistakes that other readings would assume instead, where they leave no more
    unexplained.
    """
    readings = [_read(pair)]
    others: list[tuple[Side, SerialArm, SerialArm]]
    if readings[0].moved.any() or (readings[0].unexplained_count and not pair.number_by_number):
        readings.append(_read(pair_as_written(pair.a, pair.given_b)))
    if readings[0].moved.any() or not pair.alignment.exact:
        others = [("b", pair.a, other) for other in read_by_the_other_rule(pair.given_b)]
        others += [("a", other, pair.given_b) for other in read_by_the_other_rule(pair.a)]
        for side, a, b in others:
            turned = _read(pair_up(a, b), side)
            # The other convention is taken only where it makes all axes coincide as they stand.
            if turned.pair.alignment.exact and not turned.moved.any():
                readings.append(turned)
    best = min(readings, key=lambda reading: reading.cost)
    rivals = [
        r for r in readings if r is not best and r.unexplained_count <= best.unexplained_count
    ]
    return best, tuple(dict.fromkeys(name for rival in rivals for name in rival.ids))


def _read(pair: Pair, rule: Side | None = None) -> Reading:
    link_pairs: dict[Side, LinkPair] = {"b": LinkPair.of(pair, "b"), "a": LinkPair.of(pair, "a")}
    mismatches = disagreements(link_pairs["b"], geometry=pair.number_by_number)
    noise = usual_gap(mismatches)
    candidates = []
    unexplained = _geometry_without_numbers(pair)
    for mismatch in _whole_bodies_first(mismatches, link_pairs):
        options = _options(link_pairs, mismatch, noise) if mismatch.gap > _SAME else []
        if options:
            candidates.append(options)
        elif mismatch.gap > DIGITS:
            unexplained.append(mismatch)
    return Reading(pair, rule, tuple(_fewest_kinds(candidates)), tuple(unexplained), noise)


def _geometry_without_numbers(pair: Pair) -> list[Mismatch]:
    """Axes that do not coincide, where the sources' lengths cannot be compared."""
    alignment = pair.alignment
    if alignment.exact or pair.number_by_number:
        return []
    apart = np.maximum(alignment.axis_angle / SAME_ANGLE, alignment.axis_distance / SAME_LENGTH)
    return [Mismatch(int(i), "link_vector", 1.0) for i in np.flatnonzero(apart > 1.0)]


def _whole_bodies_first(
    mismatches: Sequence[Mismatch], link_pairs: dict[Side, LinkPair]
) -> Iterable[Mismatch]:
    """One mismatch for a whole body where one mistake explains all its numbers at once."""
    covered = set()
    for mass in mismatches:
        if mass.quantity == "mass" and mass.gap > DIGITS:
            whole = Mismatch(mass.link, "body", mass.gap)
            if _options(link_pairs, whole, 0.0):
                covered.add(mass.link)
                yield whole
    for mismatch in mismatches:
        if mismatch.link not in covered or mismatch.quantity in ("link_vector", "rotation"):
            yield mismatch


def _options(link_pairs: dict[Side, LinkPair], mismatch: Mismatch, noise: float) -> list[Explained]:
    """Everything that explains one number, b's mistakes first."""
    found = {
        side: explanations(link_pair, mismatch, noise) for side, link_pair in link_pairs.items()
    }
    fewest = min((len(v.mistakes) for vs in found.values() for v in vs), default=0)
    simple = {side: [v for v in vs if len(v.mistakes) == fewest] for side, vs in found.items()}
    # A value taken from the other side explains only what nothing else does.
    if any(not _last_resort(v) for vs in simple.values() for v in vs):
        simple = {side: [v for v in vs if not _last_resort(v)] for side, vs in simple.items()}
    in_b = {candidate.ids: candidate for candidate in simple["b"]}
    tied = in_b.keys() & {candidate.ids for candidate in simple["a"]}
    likelier = _less_plausible(link_pairs, mismatch)
    options = []
    for side, candidates in simple.items():
        for candidate in candidates:
            if candidate.ids in tied and likelier not in (None, side):
                continue
            equals = dict.fromkeys(" + ".join(v.ids) for v in candidates if v.ids != candidate.ids)
            options.append(
                Explained(
                    side,
                    candidate.ids in tied and likelier is None,
                    candidate,
                    link_pairs[side].bodies[mismatch.link],
                    tuple(equals),
                    in_b.get(candidate.ids),
                )
            )
    return options


def _last_resort(candidate: Candidate) -> bool:
    return candidate.ids == ("centre-of-shape",)


def _less_plausible(link_pairs: dict[Side, LinkPair], mismatch: Mismatch) -> Side | None:
    """The side with the implausible number, where repairing either would do.

    Implausible is a radius of gyration larger than the link is long (or 10 cm), and a centre of
    mass that lies off the link by half its length (or 10 cm).
    """
    body_a, body_b = (link_pairs[side].bodies[mismatch.link] for side in ("a", "b"))
    if mismatch.quantity == "tensor":
        odd_a, odd_b = (_gyration(b) > max(0.1, _length(b)) for b in (body_a, body_b))
    elif mismatch.quantity in ("centre", "link_vector"):
        odd_a, odd_b = (b.centre_off_link() > max(0.1, 0.5 * _length(b)) for b in (body_a, body_b))
    else:
        return None
    return None if odd_a == odd_b else "a" if odd_a else "b"


def _gyration(body: Body) -> float:
    """The largest radius of gyration [m]."""
    largest = float(np.abs(np.diag(body.tensor)).max())
    return float(np.sqrt(largest / body.mass)) if body.mass > 0.0 else 0.0


def _length(body: Body) -> float:
    return float(np.linalg.norm(body.link_vector))


def _fewest_kinds(candidates: list[list[Explained]]) -> list[Explained]:
    """One explanation a number, chosen so that few kinds of mistake explain many numbers.

    Greedy: the kind that explains most numbers takes them all; ties go to the earlier in the list
    of mistakes, and to side b.  A number that repairing either side explains takes the side of
    those whose side is known.
    """
    chosen: list[Explained] = []
    left = list(candidates)
    while left:
        counts = Counter(option.kind for options in left for option in options)
        known = Counter(o.kind for options in left for o in options if not o.either)
        kind = max(counts, key=lambda k: (counts[k], known[k]))  # the first among equals
        taken = [next((o for o in options if o.kind == kind), None) for options in left]
        chosen += [option for option in taken if option is not None]
        left = [options for options, t in zip(left, taken, strict=True) if t is None]
    return chosen
