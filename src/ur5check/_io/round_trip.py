"""Numbers that read back as themselves: written, read and written again, the text is the same.

A rotation passes through angles or a quaternion, an inertia from the frame at the link's joint to
that at its tip frame.  Each way rounds, so a number may come back with another last digit, and a
file that is converted again and again would wander.  So these numbers stand on decimal grids that
are wider than the way there and back can move them: 0.27999999999999997 is 0.28 again, and stays
so.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .._robot.inertia import Inertia
from .._robot.serial_arm import Link
from .._robot.transforms import Array, Transform, cos_sin
from .number_text import roll_pitch_yaw

__all__ = ["Pose", "angle", "on_grid", "quaternion_pose", "round_trip_inertia", "rpy_pose"]

_EPS = float(np.finfo(np.float64).eps)
# Decimals of an angle [rad] and of a quaternion's component: 5e-16 is 2 ε, what one way costs.
_DECIMALS = 15
# An inertia goes from one frame to another and back through two rotations a side, each a sum of
# three products, by a matrix that is orthogonal to about ε: some 8 ε of the largest length or
# moment involved, at most.  A grid must be twice as wide.
_MOVED = 20 * _EPS
_NO_LENGTH = 1e-30  # [m]: a finer grid would be one of subnormal doubles
_MOST_PASSES = 8  # the first pass suffices, unless a number stood between two grid points

Numbers = tuple[float, ...]


@dataclass(frozen=True)
class Pose:
    """A fixed pose as it is written.

    xyz : [m];  turn : roll, pitch and yaw [rad], or a quaternion, scalar first
    read : the pose that a reader makes of them
    """

    xyz: Numbers
    turn: Numbers
    read: Transform


def rpy_pose(T: Transform, decimals: int = _DECIMALS) -> Pose:
    """For a format that turns by roll, pitch and yaw."""

    def write(R: Array) -> Numbers:
        return tuple(angle(value, decimals) for value in roll_pitch_yaw(R))

    return _pose(T, write, lambda turn: Transform.from_rpy((0.0, 0.0, 0.0), turn).R)


def quaternion_pose(T: Transform) -> Pose:
    """For a format that turns by quaternions."""
    return _pose(T, _quaternion, lambda turn: Transform.from_quaternion((0.0, 0.0, 0.0), turn).R)


def round_trip_inertia(link: Link, link_tip_frame: Transform) -> Inertia:
    """The link's inertia in the frame at its joint.

    link_tip_frame : P_i as a reader will compute it from the written numbers
    """
    here = _at_joint(link.inertia, link.link_tip_frame)
    for _ in range(_MOST_PASSES):
        again = _at_joint(here.expressed_in(link_tip_frame.inverse()), link_tip_frame)
        if _same(again, here):
            break
        here = again
    return here


def _pose(
    T: Transform, write: Callable[[Array], Numbers], read: Callable[[Numbers], Array]
) -> Pose:
    turn = write(T.R)
    for _ in range(_MOST_PASSES):
        again = write(read(turn))
        if again == turn:
            break
        turn = again
    return Pose(tuple(map(float, T.p)), turn, Transform(read(turn), T.p))


def angle(value: float, decimals: int = _DECIMALS) -> float:
    """An angle [rad] on the grid; a multiple of π/2 keeps all its digits, or it would be none."""
    if 0.0 in cos_sin(value):
        return round(value / (np.pi / 2)) * (np.pi / 2)
    return round(value, decimals)


def _quaternion(R: Array) -> Numbers:
    """From a row of 4 q qᵀ, the one with the largest diagonal entry (Shepperd 1978); w ≥ 0.

    The row is exact for quarter turns, and so is its division by one length.
    """
    antisymmetric = (R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1])
    K = np.zeros((4, 4))
    K[0, 0] = 1.0 + np.trace(R)
    K[0, 1:] = K[1:, 0] = antisymmetric
    K[1:, 1:] = R + R.T + (1.0 - np.trace(R)) * np.eye(3)
    row = K[int(np.argmax(np.diag(K)))]
    q = row / np.linalg.norm(row)
    q = np.round(q, _DECIMALS)
    return tuple(float(x) for x in (q if q[np.flatnonzero(q)[0]] > 0.0 else -q))


def _at_joint(inertia: Inertia, link_tip_frame: Transform) -> Inertia:
    """Held at the tip frame, as held at the joint, without the rounding of the way."""
    return on_grid(inertia.expressed_in(link_tip_frame), link_tip_frame)


def on_grid(here: Inertia, way: Transform) -> Inertia:
    """An inertia without the rounding that `way`, which took it here, has left in it."""
    start = way.inverse().R @ (here.com - way.p)
    length = max(float(np.abs(vector).max()) for vector in (start, here.com, way.p))
    largest = float(np.abs(here.tensor).max())
    return Inertia(
        here.mass,
        _on_grid(here.com, max(_MOVED * length, _NO_LENGTH)),
        _on_grid(here.tensor, _MOVED * largest),
    )


def _on_grid(values: Array, least: float) -> Array:
    """Rounded to multiples of the next of 1, 2, 5, 10, … × 10ᵏ from `least` on."""
    if least == 0.0:
        return values
    exponent = math.floor(math.log10(least))
    step = next(step for step in (1, 2, 5, 10) if step * 10.0**exponent >= least)
    counts = np.round(values / (step * 10.0**exponent)).flat
    return np.array([float(f"{int(n) * step}e{exponent}") for n in counts]).reshape(values.shape)


def _same(a: Inertia, b: Inertia) -> bool:
    return np.array_equal(a.com, b.com) and np.array_equal(a.tensor, b.tensor)
