"""A trajectory from a file: instants and joint positions, with smooth motion between them.

Columns are `t` [s] and, for joint i = 1 … n, `q1` or `q_NAME` [rad]; velocities `qd1` [rad/s] and
accelerations `qdd1` [rad/s²] may stand beside them, all or none.  With them, each piece between two
rows is the quintic that meets all six values; without, one quintic spline goes through all rows.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..._errors import StateError
from ..._io.numeric_columns import NumberColumns, read_columns
from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array
from .trajectory import Reference

__all__ = ["Sampled", "read_trajectory"]

_DEGREE = 5  # of a spline: its acceleration is smooth


@dataclass(frozen=True, eq=False)
class Sampled:
    """Piecewise quintics through rows of a file; t = 0 at the first row.

    pieces : q, q̇ and q̈ as functions of time;  duration : [s]
    file, sha256 : where it came from
    """

    pieces: tuple[Any, Any, Any]
    n: int
    duration: float
    file: str
    sha256: str

    def at(self, t: ArrayLike) -> Reference:
        """See `Trajectory`; before and after it the arm is wanted at rest at its ends."""
        t = np.asarray(t, dtype=np.float64)
        inside = (t >= 0.0) & (t <= self.duration)
        q, qd, qdd = (piece(np.clip(t, 0.0, self.duration)) for piece in self.pieces)
        moving = inside[..., None]
        return Reference(q, np.where(moving, qd, 0.0), np.where(moving, qdd, 0.0))


def read_trajectory(file: str | Path, arm: SerialArm) -> Sampled:
    """The trajectory of `arm`'s joints in a .csv or .parquet file.

    Raises StateError for what is no finite number, for times that do not increase, for columns that
    are missing, and for too few rows; UsageError for Parquet without pyarrow.
    """
    table = read_columns(file)
    t = table["t"]
    late = np.flatnonzero(np.diff(t) <= 0.0)
    if len(late):
        row = int(late[0]) + 1
        raise StateError(
            f"{table.file}: row {row + 1}: column 't' is {t[row]:g} after {t[row - 1]:g}; times "
            "must increase"
        )
    q = _joints(table, arm, "q")
    rates = [part for part in ("qd", "qdd") if any(_named(table, arm, part))]
    if len(rates) == 1:
        raise StateError(
            f"{table.file}: has columns of {rates[0]} alone; give velocities and accelerations, or "
            "neither"
        )
    fewest = 2 if rates else _DEGREE + 1
    if len(t) < fewest:
        raise StateError(f"{table.file}: has {len(t)} rows; a trajectory needs {fewest} or more")
    x = _through(t - t[0], q, [_joints(table, arm, part) for part in rates])
    pieces = (x, x.derivative(1), x.derivative(2))
    return Sampled(pieces, arm.n, float(t[-1] - t[0]), table.file, table.sha256)


def _through(t: Array, q: Array, rates: list[Array]) -> Any:
    from scipy.interpolate import BPoly, make_interp_spline

    if rates:
        return BPoly.from_derivatives(t, np.stack([q, *rates], axis=1))
    return make_interp_spline(t, q, k=_DEGREE)


def _named(table: NumberColumns, arm: SerialArm, part: str) -> list[str]:
    """Names of those columns of a part that are there."""
    names = [(f"{part}{i}", f"{part}_{name}") for i, name in enumerate(arm.joint_names, 1)]
    return [name for pair in names for name in pair if name in table]


def _joints(table: NumberColumns, arm: SerialArm, part: str) -> Array:
    """One part of all joints, shape (K, n)."""
    columns = []
    for i, joint in enumerate(arm.joint_names, 1):
        numbered, named = f"{part}{i}", f"{part}_{joint}"
        if numbered in table and named in table:
            raise StateError(
                f"{table.file}: columns {numbered!r} and {named!r} are the same number; leave one"
            )
        columns.append(table[named if named in table else numbered])
    return np.stack(columns, axis=1)
