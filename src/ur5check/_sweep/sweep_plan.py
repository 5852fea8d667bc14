"""Everything that a sweep's result depends on, as one value: what threads, workers and checkpoints
are handed, and what makes two results comparable to the digit."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._comparison.arm_pair import Pair
from .._comparison.worst_case.state_box import state_box
from .._errors import UsageError
from .._robot.serial_arm import SerialArm, Source
from .._robot.transforms import Array
from .._version import __version__
from .reach_map import ReachGrid, reach_grid, tool_position
from .state_sample import BLOCK, Sample, blocks_of, box_value
from .statistics import Statistics, merged, statistics_of
from .torque_difference import TorqueDifference, torque_difference

__all__ = ["Plan", "plan_of"]

#: A map wants a million states, not a billion: a tool's position costs several times its
#: statistics.
_MAP_STATES = 1_000_000
_MAP_EVERY = 64


@dataclass(frozen=True, eq=False)
class Plan:
    """Arms in one set of joint coordinates, states, and what is asked of them.

    over : limit on |Δτ| per joint, shape (n,) [N m]; None if none was asked for
    grid : of the reach map, in a's base frame;  map_every : it sees every so-many-th state
    """

    a: SerialArm
    b: SerialArm
    sample: Sample
    tolerance: Array | None
    grid: ReachGrid
    map_every: int

    @property
    def blocks(self) -> int:
        return blocks_of(self.sample)

    @property
    def engine(self) -> str:
        """What computes the torques."""
        return _difference(self).engine

    def statistics(self, start: int, stop: int) -> Statistics:
        """Blocks start … stop − 1, one after the other; their map is drawn at the end, at once."""
        seen: list[tuple[Array, Array]] = []
        total = merged(self._statistics(k, seen) for k in range(start, stop))
        q, sizes = (np.concatenate(part) for part in zip(*seen, strict=True))
        return total.on_map(self.cells_of(q), sizes, self.grid.cells)

    def _statistics(self, k: int, seen: list[tuple[Array, Array]]) -> Statistics:
        """Block k without its map; what the map will want of it is put by."""
        states = self.sample.block(k)
        delta = _difference(self).of(states.q, states.qd, states.qdd)
        seen.append((states.q[:: self.map_every].copy(), np.abs(delta[:: self.map_every])))
        return statistics_of(delta, states, BLOCK * k, tolerance=self.tolerance)

    def cells_of(self, q: Array) -> NDArray[np.intp]:
        """Where the tool is at these positions, shape (N, n)."""
        return self.grid.cell(tool_position(self.a, q))

    def description(self) -> dict[str, Any]:
        """The same as plain values, by what a user would call them."""
        return {
            "version": __version__,
            "numpy": np.__version__,
            "engine": self.engine,
            "model A": _numbers(self.a),
            "model B": _numbers(self.b),
            "states": self.sample.count,
            "sample": self.sample.description(),
            "limit": None if self.tolerance is None else self.tolerance.tolist(),
            "reach map": [self.grid.reach, self.map_every],
        }


def plan_of(pair: Pair, sample: Sample, tolerance: ArrayLike | None) -> Plan:
    """The plan for a pair of arms.  Raises UsageError for a limit that is none."""
    of = sample.description()
    box = of.get("box") or box_value(state_box(pair, 0.0))
    travel = np.abs([box["lower"], box["upper"]]).max(axis=0)
    # Of a grid, every so-many-th posture might be one and the same angle of a joint.
    every = 1 if of["kind"] == "grid" else min(max(sample.count // _MAP_STATES, 1), _MAP_EVERY)
    return Plan(
        _bare(pair.a),
        _bare(pair.b),
        sample,
        None if tolerance is None else _limits(tolerance, pair.a.n),
        reach_grid(pair.a, travel),
        every,
    )


def _limits(tolerance: ArrayLike, n: int) -> Array:
    """Limits of n joints, shape (n,), from one or n of them."""
    limits = np.asarray(tolerance, dtype=np.float64)
    if limits.shape not in ((), (1,), (n,)):
        raise UsageError(f"over has {limits.size} limits; give one, or one for each of {n} joints")
    if not (np.isfinite(limits).all() and (limits >= 0.0).all()):
        raise UsageError(f"over must be sizes of torques [N m], not {limits.tolist()}")
    return np.broadcast_to(limits, (n,)).copy()


def _bare(arm: SerialArm) -> SerialArm:
    """The arm without the file or `pin.Model` it came from: what goes to another machine."""
    return replace(arm, source=Source())


@lru_cache(maxsize=8)
def _difference(plan: Plan) -> TorqueDifference:
    """Made once in each process: a kernel may have to be compiled first."""
    return torque_difference(plan.a, plan.b)


def _numbers(arm: SerialArm) -> dict[str, Any]:
    """All that torque depends on."""
    return {
        "joints": [
            [joint.kind, joint.axis.tolist(), joint.armature, joint.damping, joint.friction]
            for joint in arm.joints
        ],
        "links": [
            [link.link_tip_frame.matrix().tolist(), link.inertia.parameters().tolist()]
            for link in arm.links
        ],
        "base": arm.base.matrix().tolist(),
        "gravity": arm.gravity.tolist(),
    }
