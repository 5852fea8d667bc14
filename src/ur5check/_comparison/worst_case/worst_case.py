"""The state within the limits at which Δτ = τ_a − τ_b is largest, as far as a search finds it.

Random states show the size of a difference but not its maximum: the worst state lies on corners
of the box of velocities and accelerations, where random states do not. The best of many random
states are therefore the starts of an ascent; the result is never below them. A maximum that no
start reached stays unknown, so that the value is a lower bound. At rest there is an upper one too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..._arguments import instance, integer, number
from ..._dynamics.equations import gravity_torque
from ..._dynamics.recursion import rnea
from ..._robot.states import MAX_ACCELERATION, States
from ..._robot.transforms import Array
from ..arm_pair import Pair
from .coordinate_ascent import TorqueGap, ascend
from .gravity_bound import gravity_bounds
from .state_box import StateBox, state_box

__all__ = ["WorstCase", "worst_cases", "worst_torque"]

#: Each start is the best of this many random states.
STATES_PER_START = 50

#: Ascents for one result, times n; benchmarks/bench_worst_case.py measures what they find.
STARTS_PER_JOINT = 32

#: Random states that a single result is compared with.
_FEW_STATES = 10_000

#: Two ascents reached the same maximum if their values differ by less than this part: an ascent
#: ends some 1e-7 below its own, and two different maxima are hardly ever so close.
SAME_MAXIMUM = 1e-6

Indices = NDArray[np.intp]

#: Two torques, each rounded some 32 times a joint by ε of the largest.
ROUNDING = 64 * float(np.finfo(np.float64).eps)


@dataclass(frozen=True)
class WorstCase:
    """The largest torque difference that was found, and its state.

    Attributes
    ----------
    what : {"one joint", "all joints together"}
    joint : int or None
        From 1; None for all together.
    static : bool
        Whether the arm stands still: gravity torque only.
    value : float
        |Δτ_j| for one joint; for all together √Σ (Δτ_j / effort_j)², or √Σ Δτ_j² where an effort
        limit is not known.  A search found it: the maximum is at least this.
    unit : str
        "N m" or "N"; "of the effort limits" for shares of them.
    bound : float or None
        The maximum is at most this; None where no bound is known (in motion).
    effort_share : float or None
        The value as a share of the effort limit; None where that is not known.
    state : dict
        "q", "qd" and "qdd", n numbers each [rad], [rad/s], [rad/s²].
    best_random : float
        The value at the best of the random states.
    starts : int
        Ascents begun, from independent random states; 0 where the two arms differ by rounding only.
    reached : int
        How many of them ended at this value, to a millionth; most are given up after two sweeps,
        where they lie below others.
    """

    what: Literal["one joint", "all joints together"]
    joint: int | None
    static: bool
    value: float
    bound: float | None
    unit: str
    effort_share: float | None
    state: dict[str, list[float]]
    best_random: float
    starts: int
    reached: int

    @property
    def undetected_share(self) -> float | None:
        """Share of starts above which a higher maximum would have been found.

        With a probability of 95 %, 1 − 0.05^(1 / starts), where two sweeps tell its ascents from
        others.  None without a search.
        """
        return 1.0 - 0.05 ** (1.0 / self.starts) if self.starts else None


@dataclass(frozen=True, eq=False)
class _Question:
    """The objective: √Σ (w_j Δτ_j)², with one weight 1 and the others 0 for one joint."""

    joint: int | None  # from 0
    weights: Array
    unit: str
    effort: float  # what the value is a share of; nan where that is not known

    def values(self, delta: Array) -> Array:
        """From Δτ of shape (N, n), shape (N,)."""
        if self.joint is not None:
            return np.abs(delta[:, self.joint])
        return np.asarray(np.linalg.norm(self.weights * delta, axis=-1))


def worst_cases(
    pair: Pair,
    *,
    seed: int = 0,
    acceleration: float = MAX_ACCELERATION,
    starts: int | None = None,
    random_states: int = 100_000,
) -> tuple[WorstCase, ...]:
    """The largest torque differences of a pair that a search finds: 2 n + 2 results.

    First in motion, joint by joint and then all joints together; then in the same order at rest,
    with gravity torque only.  The states lie within the joint limits (docs/worst-case.md).

    Parameters
    ----------
    pair : Pair
        See `pair_up`.
    seed : int
        Of the random states, not negative.
    acceleration : float
        Bound on |q̈| [rad/s²], positive.
    starts : int, optional
        Ascents for each result, at least 1; 32 n when None.
    random_states : int
        Number of random states that the results are compared with, at least 1.

    Returns
    -------
    tuple of WorstCase

    Raises
    ------
    UsageError
        For an invalid argument.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("appendix", "erd-ur5")
    >>> found = ur5check.worst_cases(pair, starts=1, random_states=100)
    >>> len(found), found[0].value >= found[0].best_random
    (14, True)
    """
    instance("pair", pair, Pair, "see ur5check.pair_up")
    starts = STARTS_PER_JOINT * pair.a.n if starts is None else integer("starts", starts, least=1)
    random_states = integer("random_states", random_states, least=1)
    seed = integer("seed", seed, least=0)
    acceleration = number("acceleration", acceleration, positive=True)
    box = state_box(pair, acceleration)
    moving = box.draw(random_states, seed)
    rest = np.zeros_like(moving.q)
    pool = box.draw(STATES_PER_START * starts, (seed, 1))
    at_rest = States(moving.q, rest, rest)
    questions = _questions(pair)
    return (
        *_answers(pair, box, moving, pool, questions, static=False),
        *_answers(pair, box, at_rest, pool, questions, static=True),
    )


def worst_torque(
    pair: Pair, joint: int, *, seed: int = 0, acceleration: float = MAX_ACCELERATION
) -> WorstCase:
    """The result of `worst_cases` for one joint (from 1) in motion, at a tenth of its cost.

    It is compared with fewer random states.
    """
    box = state_box(pair, acceleration)
    states = box.draw(_FEW_STATES, seed)
    pool = box.draw(STATES_PER_START * STARTS_PER_JOINT * pair.a.n, (seed, 1))
    (case,) = _answers(pair, box, states, pool, [_questions(pair)[joint - 1]], static=False)
    return case


def _questions(pair: Pair) -> list[_Question]:
    efforts, n = pair.effort_limits, pair.a.n
    units = ["N" if joint.kind == "prismatic" else "N m" for joint in pair.a.joints]
    single = [_Question(j, np.eye(n)[j], units[j], float(efforts[j])) for j in range(n)]
    if np.isnan(efforts).any():
        unit = " and ".join(sorted(set(units), reverse=True))
        return [*single, _Question(None, np.ones(n), unit, np.nan)]
    return [*single, _Question(None, 1.0 / efforts, "of the effort limits", 1.0)]


def _answers(
    pair: Pair,
    box: StateBox,
    states: States,
    pool: States,
    questions: Sequence[_Question],
    *,
    static: bool,
) -> list[WorstCase]:
    """One result for each question; the ascents of all of them are made together."""
    delta, rounding = _delta(pair, states, static)
    starts = len(pool) // STATES_PER_START
    bounds = gravity_bounds(pair, box) if static else None
    rounded = [rounding * float(np.linalg.norm(question.weights)) for question in questions]
    best = [int(question.values(delta).argmax()) for question in questions]
    searched = [
        k
        for k, question in enumerate(questions)
        if question.values(delta[[best[k]]])[0] > rounded[k]
    ]
    ends: dict[int, States] = {}
    if searched:
        gap = TorqueGap(pair, static)
        begin = _starts(gap, box, pool, [questions[k] for k in searched])
        weights = np.repeat([questions[k].weights for k in searched], starts, axis=0)
        reached = ascend(gap, box, begin, weights, results=len(searched))
        ends = {k: _at(reached, np.arange(starts) + i * starts) for i, k in enumerate(searched)}
    cases = []
    for k, question in enumerate(questions):
        candidates = _at(states, np.array([best[k]]))
        if k in ends:
            candidates = _joined([candidates, ends[k]])
        values = question.values(_delta(pair, candidates, static)[0])
        winner, j = int(values.argmax()), question.joint
        value = float(values[winner])
        cases.append(
            WorstCase(
                "all joints together" if j is None else "one joint",
                None if j is None else j + 1,
                static,
                value,
                None if bounds is None else float(np.linalg.norm(question.weights * bounds)),
                question.unit,
                None if np.isnan(question.effort) else value / question.effort,
                candidates[winner],
                float(values[0]),
                len(values) - 1,
                int((values[1:] >= value * (1.0 - SAME_MAXIMUM)).sum()),
            )
        )
    return cases


def _starts(gap: TorqueGap, box: StateBox, pool: States, questions: list[_Question]) -> States:
    """Starts for each question: each the best of a share of the pool of its own, so that they are
    independent, with velocities at corners of the box and the best accelerations.
    """
    q, count = pool.q, len(pool) // STATES_PER_START
    qd = np.where(pool.qd < 0.0, -box.rate, box.rate) * (not gap.static)
    sizes, qdd = gap.with_best_accelerations(q, qd, box.acceleration)
    begin = []
    for question in questions:
        heights = (question.weights * sizes) ** 2
        best = heights.sum(axis=1).reshape(-1, count).argmax(axis=0) * count + np.arange(count)
        begin.append(States(q[best], qd[best], qdd[best, heights[best].argmax(axis=1)]))
    return _joined(begin)


def _joined(several: list[States]) -> States:
    return States(
        *(np.concatenate([getattr(each, part) for each in several]) for part in ("q", "qd", "qdd"))
    )


def _at(states: States, indices: Indices) -> States:
    return States(states.q[indices], states.qd[indices], states.qdd[indices])


def _delta(pair: Pair, states: States, static: bool) -> tuple[Array, float]:
    """Δτ, shape (N, n), by the hand-written recursion, and the part that may be rounding [N m].

    static : whether all velocities and accelerations are zero, so that their terms are omitted
    """
    tau_a, tau_b = (
        gravity_torque(arm, states.q) if static else rnea(arm, states.q, states.qd, states.qdd)
        for arm in (pair.a, pair.b)
    )
    rounding = ROUNDING * pair.a.n * float(max(np.abs(tau_a).max(), np.abs(tau_b).max()))
    return np.asarray(tau_a - tau_b), rounding
