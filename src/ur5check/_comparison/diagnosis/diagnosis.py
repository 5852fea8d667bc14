"""Which known mistakes were made between two arms, with evidence: the largest first, or none."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..._dynamics.recursion import rnea
from ..._robot.inertia import Inertia
from ..._robot.serial_arm import SerialArm
from ..._robot.states import States
from ..alignment import arm_in_coordinates_of
from ..arm_pair import Pair, Side, check_pair
from ..difference import SAME_TORQUE
from .arm_mistakes import ARM_MISTAKES, ROUNDED
from .link_numbers import body_of, with_body
from .mistake import ArmDifference, ArmMistake, Mistake, changed
from .mistake_search import Candidate, Mismatch
from .pair_readings import Explained, Kind, Reading, best_reading

__all__ = ["Diagnosis", "RecognizedMistake", "diagnose"]


@dataclass(frozen=True, eq=False)
class RecognizedMistake:
    """One mistake, in every link in which it was made.

    mistakes : its record; two where two mistakes were made in the same numbers
    side : the arm it was made in; None where repairing either would do
    before, after : RMS of Δτ over all joints and states [N m], with the mistakes above this one
        repaired, and with this one repaired too
    choices : how many values were tried for each number
    equals : ids of other mistakes that explain the same numbers as well
    explained : the numbers that it explains, in the order of links; empty for the whole arm
    difference : what is different between the whole arms; None for a mistake in links
    """

    mistakes: tuple[Mistake, ...]
    side: Side | None
    before: float
    after: float
    choices: int
    equals: tuple[str, ...] = ()
    explained: tuple[Explained, ...] = ()
    difference: ArmDifference | None = None

    @property
    def id(self) -> str:
        """The mistake's id; ids joined by " + " where there are two."""
        return " + ".join(mistake.id for mistake in self.mistakes)

    @property
    def links(self) -> tuple[int, ...]:
        """Numbers from 1; empty for the whole arm."""
        if self.difference is not None:
            return self.difference.links
        return tuple(explained.candidate.mismatch.link + 1 for explained in self.explained)

    @property
    def is_convention(self) -> bool:
        """Whether the two models only count differently: no file has to be repaired."""
        return all(mistake.severity == "note" for mistake in self.mistakes)


@dataclass(frozen=True, eq=False)
class Diagnosis:
    """All mistakes that were recognised, and the difference that remains.

    Attributes
    ----------
    pair : Pair
        The arms, in the reading that needs fewest assumptions.
    mistakes : tuple of RecognizedMistake
        In the order of repairing.
    unexplained : tuple of Mismatch
        Numbers on which the arms disagree and which no known mistake explains.
    before, after : float
        RMS of Δτ over joints and states as the arms are, and with everything repaired [N m].
    repaired_a : SerialArm
        Arm a as it was given, less the mistakes that are taken to be its own.
    repaired_b : SerialArm
        Arm b as it was given, with every mistake repaired that repairing b can repair.
    aligned : mapping of {"a", "b"} to SerialArm
        Both arms in the pair's coordinates, with everything repaired.
    """

    pair: Pair
    mistakes: tuple[RecognizedMistake, ...]
    unexplained: tuple[Mismatch, ...]
    before: float
    after: float
    repaired_a: SerialArm
    repaired_b: SerialArm
    aligned: Mapping[Side, SerialArm]


def diagnose(pair: Pair, states: States) -> Diagnosis:
    """Look for known mistakes between two arms, and measure how much of Δτ each accounts for.

    Rounded constants come first: what follows is searched for in arms that have them exact.

    Parameters
    ----------
    pair : Pair
        See `pair_up`.
    states : States, shape (N, n)
        In the coordinates of the pair's first arm.

    Returns
    -------
    Diagnosis

    Raises
    ------
    InputError
        For other types, no state, or states of another number of joints.

    Examples
    --------
    >>> import ur5check
    >>> arm = ur5check.load("paper")
    >>> pair = ur5check.pair_up(arm, arm.with_gravity(-arm.gravity))
    >>> found = ur5check.diagnose(pair, ur5check.random_states(6, 10, seed=0))
    >>> [mistake.id for mistake in found.mistakes]
    ['gravity-sign']
    """
    check_pair(pair, states)
    reading, rivals = best_reading(pair.without_rounding())
    before = _rms(pair.a, pair.b, states)
    sequence = _RepairSequence(reading, states, before)
    sequence.write_out(pair)
    for mistake in ARM_MISTAKES:
        difference = mistake.find(reading.pair, reading.rule)
        if difference is not None:
            sequence.repair_arm(mistake, difference, rivals)
    groups: dict[Kind, list[Explained]] = {}
    for explained in reading.explained:
        groups.setdefault(explained.kind, []).append(explained)
    while groups:
        after = {key: sequence.would_leave(group) for key, group in groups.items()}
        key = min(after, key=lambda k: after[k])
        sequence.repair_links(groups.pop(key))
    return Diagnosis(
        reading.pair,
        tuple(sequence.repaired),
        reading.unexplained,
        before,
        sequence.left,
        sequence.given["a"],
        sequence.given["b"],
        sequence.arms,
    )


class _RepairSequence:
    """Repairs one mistake after the other and measures the torque difference after each.

    arms : both in the pair's coordinates, for the torques;  given : both as given, to be written
    left : RMS of Δτ [N m] that is left
    """

    def __init__(self, reading: Reading, states: States, before: float) -> None:
        pair = reading.pair
        self.arms: dict[Side, SerialArm] = {"a": pair.a, "b": pair.b}
        self.given: dict[Side, SerialArm] = {"a": pair.a, "b": pair.given_b}
        self.T_ba = pair.alignment.T_ab.inverse()
        self.states = states
        self.left = before
        self.repaired: list[RecognizedMistake] = []

    def write_out(self, pair: Pair) -> None:
        """Rounded constants of the pair, which the reading's arms have exact already.

        Eleven digits of π/2 change no torque, and are no mistake.
        """
        arms: dict[Side, SerialArm] = {"a": pair.a, "b": pair.b}
        for correction in pair.corrections:
            arm = correction.arm
            if correction.side == "b":
                arm = arm_in_coordinates_of(pair.a, arm, pair.alignment)
            before, arms[correction.side] = arms[correction.side], arm
            after = _rms(arms["a"], arms["b"], self.states)
            size = _rms(arm, arm.with_inertias([Inertia.zero()] * arm.n), self.states)
            if _rms(before, arm, self.states) <= SAME_TORQUE * size:
                continue
            difference = ArmDifference(
                correction.side,
                links=tuple(link for link in correction.links if link),
                rounded=correction.cause,
            )
            mistake = ROUNDED[correction.cause.constant == "1/12"]
            self.repaired.append(
                RecognizedMistake(
                    (mistake,), correction.side, self.left, after, 1, difference=difference
                )
            )
            self.left = after

    def repair_arm(
        self, mistake: ArmMistake, difference: ArmDifference, rivals: tuple[str, ...]
    ) -> None:
        if mistake.repaired is not None:
            for arms, T in ((self.arms, self.T_ba.identity()), (self.given, self.T_ba)):
                arms["b"] = mistake.repaired(arms["b"], difference, T)
        after = self.left
        if mistake.changes_torque:
            after = _rms(self.arms["a"], self.arms["b"], self.states)
        self.repaired.append(
            RecognizedMistake(
                (mistake,),
                difference.side,
                self.left,
                after,
                difference.choices,
                # Gravity is read off as it is; everything else depends on the reading.
                () if mistake.affects == "gravity" else rivals,
                difference=difference,
            )
        )
        self.left = after

    def would_leave(self, group: list[Explained]) -> float:
        """RMS of Δτ [N m] with these numbers repaired."""
        repaired = _with_repaired(self.arms, group)
        return _rms(repaired["a"], repaired["b"], self.states)

    def repair_links(self, group: list[Explained]) -> None:
        after = self.would_leave(group)
        self.arms = _with_repaired(self.arms, group)
        for explained in group:
            if explained.side == "a":
                self.given["a"] = _repaired(self.given["a"], explained, explained.candidate)
            if explained.in_b is not None:
                self.given["b"] = _repaired(self.given["b"], explained, explained.in_b)
        first = group[0]
        self.repaired.append(
            RecognizedMistake(
                first.candidate.in_order_of_the_list(),
                None if all(e.either for e in group) else first.side,
                self.left,
                after,
                max(e.candidate.choices for e in group),
                tuple(other for other in first.equals if all(other in e.equals for e in group)),
                tuple(sorted(group, key=lambda e: e.candidate.mismatch.link)),
            )
        )
        self.left = after


def _with_repaired(arms: dict[Side, SerialArm], group: list[Explained]) -> dict[Side, SerialArm]:
    arms = dict(arms)
    for explained in group:
        arms[explained.side] = _repaired(arms[explained.side], explained, explained.candidate)
    return arms


def _repaired(arm: SerialArm, explained: Explained, candidate: Candidate) -> SerialArm:
    mismatch = candidate.mismatch
    body = body_of(arm, mismatch.link, explained.body.after_rotation)
    repaired = changed(body, mismatch.quantity, candidate.value)
    return with_body(arm, mismatch.link, repaired)


def _rms(a: SerialArm, b: SerialArm, states: States) -> float:
    """RMS of the torque difference over all joints and states [N m]."""
    tau_a, tau_b = (rnea(arm, states.q, states.qd, states.qdd) for arm in (a, b))
    return float(np.sqrt(((tau_a - tau_b) ** 2).mean()))
