"""The state within the limits at which Δτ = τ_a − τ_b is largest.

Random states show the size of a difference but not its maximum: the worst state lies on corners
of the box of velocities and accelerations, where random states do not. The best of many random
states are therefore the starts of a gradient ascent; the result is never below them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..._arguments import instance, integer, number
from ..._dynamics.equations import gravity_torque
from ..._dynamics.recursion import rnea
from ..._robot.states import MAX_ACCELERATION, States
from ..._robot.transforms import Array
from ..arm_pair import Pair
from .gradient_ascent import Ascent, Gain, Gap, joint_gain, squared_sum
from .state_box import StateBox, state_box

__all__ = ["WorstCase", "worst_cases"]

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
    effort_share : float or None
        The value as a share of the effort limit; None where that is not known.
    state : dict
        "q", "qd" and "qdd", n numbers each [rad], [rad/s], [rad/s²].
    best_random : float
        The value at the best of the random states.
    starts : int
        Ascents begun; 0 where the two arms differ by rounding only.
    evaluations : int
        Evaluations of Δτ and its gradient.
    """

    what: Literal["one joint", "all joints together"]
    joint: int | None
    static: bool
    value: float
    unit: str
    effort_share: float | None
    state: dict[str, list[float]]
    best_random: float
    starts: int
    evaluations: int


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

    def gain(self, delta: Array) -> Gain:
        """The objective from a state with this Δτ, shape (n,); the sign of Δτ_j is kept."""
        if self.joint is None:
            return squared_sum(self.weights)
        return joint_gain(self.joint, 1.0 if delta[self.joint] >= 0.0 else -1.0, len(delta))


def worst_cases(
    pair: Pair,
    *,
    seed: int = 0,
    acceleration: float = MAX_ACCELERATION,
    starts: int = 12,
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
    starts : int
        Ascents for each result, at least 1.
    random_states : int
        Number of random states, the best of which begin the ascents; at least 1.

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
    starts = integer("starts", starts, least=1)
    random_states = integer("random_states", random_states, least=1)
    seed = integer("seed", seed, least=0)
    acceleration = number("acceleration", acceleration, positive=True)
    box, gap = state_box(pair, acceleration), Gap(pair)
    moving = box.draw(random_states, seed)
    rest = np.zeros_like(moving.q)
    cases = []
    for states in (moving, States(moving.q, rest, rest)):
        search = _Search(pair, box, gap, states, states is not moving)
        cases += [search.answer(question, starts) for question in _questions(pair)]
    return tuple(cases)


def _questions(pair: Pair) -> list[_Question]:
    efforts, n = pair.effort_limits, pair.a.n
    units = ["N" if joint.kind == "prismatic" else "N m" for joint in pair.a.joints]
    single = [_Question(j, np.eye(n)[j], units[j], float(efforts[j])) for j in range(n)]
    if np.isnan(efforts).any():
        unit = " and ".join(sorted(set(units), reverse=True))
        return [*single, _Question(None, np.ones(n), unit, np.nan)]
    return [*single, _Question(None, 1.0 / efforts, "of the effort limits", 1.0)]


class _Search:
    """The random states of a pair, moving or at rest, and the ascents that begin there."""

    def __init__(self, pair: Pair, box: StateBox, gap: Gap, states: States, static: bool) -> None:
        self.pair, self.gap, self.states, self.static = pair, gap, states, static
        self.ascent = Ascent(gap, *box.ends(static=static))
        self.delta, self.rounding = _delta(pair, states, static)

    def answer(self, question: _Question, starts: int) -> WorstCase:
        sizes = question.values(self.delta)
        before = self.gap.evaluations
        # The best of each slice, not the best of all: those lie around one maximum.
        slices = min(starts, len(sizes))
        chosen = [int(part + slices * sizes[part::slices].argmax()) for part in range(slices)]
        best = max(chosen, key=lambda k: float(sizes[k]))
        candidates = [self._x(best)]
        if sizes[best] > self.rounding * float(np.linalg.norm(question.weights)):
            candidates += self._tops(chosen, question)
        # Judged by the recursion, with the best random state among the candidates.
        found = States(*np.reshape(candidates, (-1, 3, self.pair.a.n)).swapaxes(0, 1))
        values = question.values(_delta(self.pair, found, self.static)[0])
        winner, j = int(values.argmax()), question.joint
        value = float(values[winner])
        return WorstCase(
            "all joints together" if j is None else "one joint",
            None if j is None else j + 1,
            self.static,
            value,
            question.unit,
            None if np.isnan(question.effort) else value / question.effort,
            found[winner],
            float(values[0]),
            len(candidates) - 1,
            self.gap.evaluations - before,
        )

    def _tops(self, chosen: list[int], question: _Question) -> list[Array]:
        """Results of the ascents from these states; the highest is refined."""
        gains = [question.gain(self.delta[k]) for k in chosen]
        tops = [
            self.ascent.climb(self.ascent.better_corner(self._x(k), gain), gain)
            for k, gain in zip(chosen, gains, strict=True)
        ]
        first = max(range(len(tops)), key=lambda i: tops[i][0])
        tops[first] = self.ascent.climb(tops[first][1], gains[first], digits=14)
        return [x for _, x in tops]

    def _x(self, k: int) -> Array:
        """Random state number k as x = (q, q̇, q̈)."""
        return np.concatenate([self.states.q[k], self.states.qd[k], self.states.qdd[k]])


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
