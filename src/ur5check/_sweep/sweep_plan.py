"""Everything the result of a sweep depends on; threads, workers and checkpoints receive it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._arguments import number_array
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

#: A reach map of a million states is enough: a tool position takes longer than the statistics.
_MAP_STATES = 1_000_000
_MAP_EVERY = 64


@dataclass(frozen=True, eq=False)
class Plan:
    """Two arms in the same joint coordinates, states, tolerance and reach map.

    tolerance : of |Δτ| per joint, shape (n,) [N m], or None
    grid : of the reach map, in a's base frame
    map_every : the map takes every so-many-th state
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
        """The path that computes the torques."""
        return _difference(self).engine

    def statistics(self, start: int, stop: int) -> Statistics:
        """Of blocks start … stop − 1; the reach map of all is computed together, at the end."""
        seen: list[tuple[Array, Array]] = []
        total = merged(self._statistics(k, seen) for k in range(start, stop))
        q, sizes = (np.concatenate(part) for part in zip(*seen, strict=True))
        return total.on_map(self.cells_of(q), sizes, self.grid.cells)

    def _statistics(self, k: int, seen: list[tuple[Array, Array]]) -> Statistics:
        """Of block k without a map; appends to `seen` what the map needs."""
        states = self.sample.block(k)
        delta = _difference(self).of(states.q, states.qd, states.qdd)
        seen.append((states.q[:: self.map_every].copy(), np.abs(delta[:: self.map_every])))
        return statistics_of(delta, states, BLOCK * k, tolerance=self.tolerance)

    def cells_of(self, q: Array) -> NDArray[np.intp]:
        """The reach map's cell of the tool at positions q, shape (N, n)."""
        return self.grid.cell(tool_position(self.a, q))

    def description(self) -> dict[str, Any]:
        """As plain values for the checkpoint, with names for its error message."""
        return {
            "version": __version__,
            "numpy": np.__version__,
            "engine": self.engine,
            "model A": _numbers(self.a),
            "model B": _numbers(self.b),
            "states": self.sample.count,
            "sample": self.sample.description(),
            "tolerance": None if self.tolerance is None else self.tolerance.tolist(),
            "reach map": [self.grid.reach, self.map_every],
        }


def plan_of(pair: Pair, sample: Sample, tolerance: ArrayLike | None) -> Plan:
    """The plan for a pair of arms.  Raises UsageError for an invalid tolerance."""
    of = sample.description()
    box = of.get("box") or box_value(state_box(pair, 0.0))
    extent = np.abs([box["lower"], box["upper"]]).max(axis=0)
    # Every so-many-th posture of a grid could have the same angle of a joint.
    every = 1 if of["kind"] == "grid" else min(max(sample.count // _MAP_STATES, 1), _MAP_EVERY)
    return Plan(
        _bare(pair.a),
        _bare(pair.b),
        sample,
        None if tolerance is None else _tolerances(tolerance, pair.a.n),
        reach_grid(pair.a, extent),
        every,
    )


def _tolerances(tolerance: ArrayLike, n: int) -> Array:
    """Tolerances of n joints, shape (n,), from one or n of them."""
    tolerances = number_array("tolerance", tolerance, error=UsageError).astype(np.float64)
    if tolerances.shape not in ((), (1,), (n,)):
        raise UsageError(
            f"tolerance has {tolerances.size} entries; give one, or one for each of {n} joints"
        )
    if not (np.isfinite(tolerances).all() and (tolerances >= 0.0).all()):
        raise UsageError(
            f"tolerance must be finite and not negative [N m], not {tolerances.tolist()}"
        )
    return np.broadcast_to(tolerances, (n,)).copy()


def _bare(arm: SerialArm) -> SerialArm:
    """The arm without its file or `pin.Model`, to be sent to another process."""
    return replace(arm, source=Source())


@lru_cache(maxsize=8)
def _difference(plan: Plan) -> TorqueDifference:
    """Made once per process: a kernel may have to be compiled."""
    return torque_difference(plan.a, plan.b)


def _numbers(arm: SerialArm) -> dict[str, Any]:
    """All numbers that the torques depend on."""
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
