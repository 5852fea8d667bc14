"""A recording: positions, velocities and torques of a robot's joints over time, as it was read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._robot.transforms import Array

__all__ = ["Recording"]


@dataclass(frozen=True, eq=False)
class Recording:
    """What a recording holds, one row a sample.

    file : as the user gave it
    joints : names of the n joints, or "joint 1" … where the file has none
    t : time by the file's own clock, shape (N,) [s]
    q : positions, shape (N, n) [rad or m]
    qd : velocities, shape (N, n) [rad/s or m/s]; None where the file has none
    tau : torques that were measured, shape (N, n) [N m or N]; None where the file has none
    current : motor currents, shape (N, n) [A]; None where the file has none
    model_tau : torques that the controller computed from its own model, shape (N, n) [N m]; None
        where the file has none
    rows : number of each sample's row in the file, from 1, shape (N,)
    inputs : (name, SHA-256) of every file that was read
    columns : what each column was taken for, as a sentence a line
    """

    file: str
    joints: tuple[str, ...]
    t: Array
    q: Array
    qd: Array | None
    tau: Array | None
    rows: NDArray[np.int64]
    current: Array | None = None
    model_tau: Array | None = None
    inputs: tuple[tuple[str, str], ...] = ()
    columns: tuple[str, ...] = ()

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.joints)

    @property
    def count(self) -> int:
        """Number of samples."""
        return len(self.t)

    @property
    def duration(self) -> float:
        """From the first sample to the last [s]."""
        return float(self.t[-1] - self.t[0]) if self.count else 0.0

    @property
    def rate(self) -> float:
        """Samples a second, by the median step of the clock [Hz]."""
        return 1.0 / float(np.median(np.diff(self.t)))

    def selected(self, rows: NDArray[np.bool_]) -> Recording:
        """Some of the samples, by a mask."""
        return replace(
            self,
            t=self.t[rows],
            q=self.q[rows],
            rows=self.rows[rows],
            **self._optional(lambda values: values[rows]),
        )

    def of_joints(self, order: list[int], names: tuple[str, ...]) -> Recording:
        """The columns of some joints, in another order and under other names."""
        return replace(
            self,
            joints=names,
            q=self.q[:, order],
            **self._optional(lambda values: values[:, order]),
        )

    def _optional(self, change: Callable[[Array], Array]) -> dict[str, Any]:
        names = ("qd", "tau", "current", "model_tau")
        values = {name: getattr(self, name) for name in names}
        return {name: change(value) for name, value in values.items() if value is not None}
