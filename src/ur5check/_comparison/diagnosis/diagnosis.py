"""What went wrong between two arms: findings with evidence, the largest first, or plainly none."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..._dynamics.recursion import rnea
from ..._robot.serial_arm import SerialArm
from ..._robot.states import States
from ..arm_pair import Pair, Side
from .arm_mistakes import WholeArm, whole_arm
from .link_numbers import body_of, with_body
from .mistake import changed
from .mistake_search import Candidate, Mismatch
from .mistake_sentences import finding_in_words, remark, whole_arm_in_words
from .pair_readings import Explained, Kind, Reading, best_reading

__all__ = ["Diagnosis", "Finding", "diagnose"]


@dataclass(frozen=True, eq=False)
class Finding:
    """One mistake, wherever it was made.

    id : of the list of mistakes; ids joined by " + " where two mistakes were made in the same
        numbers
    side : the arm it was made in; None where repairing either would do
    links : numbers from 1; empty for the whole arm
    sentence : what happened, and where;  advice : how to repair it;  details : link by link
    before, after : RMS of Δτ over all joints and states [N m], with the findings above this one
        repaired, and with this one repaired too
    choices : how many values were tried for each number
    equals : other mistakes that explain the same numbers as well
    """

    id: str
    side: Side | None
    links: tuple[int, ...]
    sentence: str
    advice: str
    before: float
    after: float
    choices: int
    equals: tuple[str, ...] = ()
    details: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Diagnosis:
    """All findings, and what they leave.

    pair : the arms in the reading that was believed
    unexplained : numbers on which the arms disagree and no known mistake says why, and a sentence
        on each in `remarks`
    before, after : RMS of Δτ as the arms are, and with everything repaired [N m]
    mended_a : a as it was given, less the mistakes that are taken to be its own
    mended_b : b as it was given, with every mistake repaired that repairing b can repair
    """

    pair: Pair
    findings: tuple[Finding, ...]
    unexplained: tuple[Mismatch, ...]
    remarks: tuple[str, ...]
    before: float
    after: float
    repaired_a: SerialArm
    repaired_b: SerialArm


def diagnose(pair: Pair, states: States) -> Diagnosis:
    """Look for known mistakes between two arms, and show what repairing them does to the
    torques.
    """
    reading, rivals = best_reading(pair)
    repair_sequence = _RepairSequence(reading, states, _rms(pair.a, pair.b, states))
    for finding in whole_arm(reading):
        repair_sequence.repair_whole(finding, rivals)
    groups: dict[Kind, list[Explained]] = {}
    for explained in reading.explained:
        groups.setdefault(explained.kind, []).append(explained)
    while groups:
        after = {key: repair_sequence.would_leave(group) for key, group in groups.items()}
        key = min(after, key=lambda k: after[k])
        repair_sequence.repair_links(groups.pop(key))
    return Diagnosis(
        reading.pair,
        tuple(repair_sequence.findings),
        reading.unexplained,
        tuple(
            remark(
                s,
                {side: body_of(arm, s.link) for side, arm in repair_sequence.arms.items()},
                repair_sequence.names,
            )
            for s in reading.unexplained
        ),
        _rms(pair.a, pair.b, states),
        repair_sequence.left,
        repair_sequence.given["a"],
        repair_sequence.given["b"],
    )


class _RepairSequence:
    """Repairing one finding after the other, and watching the torque difference go.

    arms : both in the pair's coordinates, for the torques;  given : both as given, to be written
    """

    def __init__(self, reading: Reading, states: States, before: float) -> None:
        pair = reading.pair
        self.arms: dict[Side, SerialArm] = {"a": pair.a, "b": pair.b}
        self.given: dict[Side, SerialArm] = {"a": pair.a, "b": pair.given_b}
        self.names: dict[Side, str] = {"a": pair.a.label, "b": pair.b.label}
        self.T_ba = pair.alignment.T_ab.inverse()
        self.states = states
        self.left = before
        self.findings: list[Finding] = []

    def repair_whole(self, whole: WholeArm, rivals: tuple[str, ...]) -> None:
        if whole.gravity is not None:
            g_a, _ = whole.gravity
            self.arms["b"] = self.arms["b"].with_gravity(g_a)
            self.given["b"] = self.given["b"].with_gravity(self.T_ba.R @ g_a)
        if whole.motors is not None:
            for arms in (self.arms, self.given):
                arms["b"] = arms["b"].with_armature(whole.motors[0])
        after = self.left
        if whole.repairs_torque:
            after = _rms(self.arms["a"], self.arms["b"], self.states)
        sentence, advice = whole_arm_in_words(whole, self.names)
        self.findings.append(
            Finding(
                whole.id,
                whole.side,
                (),
                sentence,
                advice,
                self.left,
                after,
                whole.choices,
                rivals if not whole.id.startswith("gravity") else (),
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
        sentence, advice, details = finding_in_words(group, self.names)
        self.findings.append(
            Finding(
                " + ".join(first.candidate.ids),
                None if all(e.either for e in group) else first.side,
                tuple(sorted(e.candidate.mismatch.link + 1 for e in group)),
                sentence,
                advice,
                self.left,
                after,
                max(e.candidate.choices for e in group),
                tuple(other for other in first.equals if all(other in e.equals for e in group)),
                details,
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
