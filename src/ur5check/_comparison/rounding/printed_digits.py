"""The largest torque error due to the last printed digit of every number: a bound, no finding.

A number printed to h may be off by up to h/2 either way, uniformly, and independently of the
others.  To first order τ moves by Σ_k (∂τ/∂p_k) e_k with |e_k| ≤ h_k/2, so over states

    RMS = √⟨Σ_k (∂τ/∂p_k)² h_k²/12⟩,     never more than  Σ_k |∂τ/∂p_k| h_k/2.

For inertial numbers ∂τ/∂p is Y ∂π/∂p; for the lengths of P_i it is a difference of two torques.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..._robot.inertia import Inertia, parameter_map
from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array, Transform
from ..rounded_constants.decimals import half_units
from ..rounded_constants.frame_change import (
    arm_with_link,
    link_vector_is_written_at_link_tip,
    with_link_tip_frame,
)

__all__ = [
    "Mask",
    "PrintedNumbers",
    "printed_numbers",
    "torque_of_inertial_digits",
    "torque_of_lengths",
]

_SAME_NUMBER = 1e-12

Mask = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class PrintedNumbers:
    """The written numbers of an arm, and half a unit in the last place of each.

    bodies, body_halves : mass, centre (3), tensor (6: xx yy zz xy xz yz) of each link in its
        source frame, shape (n, 10) [kg, m, kg m²]
    lengths, length_halves : the translation of each P_i, where it was written, shape (n, 3) [m]
    """

    bodies: Array
    body_halves: Array
    lengths: Array
    length_halves: Array

    def without(self, other: PrintedNumbers, same_frame: Mask) -> PrintedNumbers:
        """The same, with no uncertainty where the other arm has the very same number.

        same_frame : for each link, whether both sources write it in one frame, shape (n,); where
            they do not, only masses mean the same
        """
        comparable = np.ones((len(same_frame), 10), dtype=bool)
        comparable[:, 1:] = same_frame[:, None]
        body = _same(self.bodies, other.bodies) & comparable
        length = _same(self.lengths, other.lengths) & same_frame[:, None]
        return replace(
            self,
            body_halves=np.where(body, 0.0, self.body_halves),
            length_halves=np.where(length, 0.0, self.length_halves),
        )


def printed_numbers(arm: SerialArm) -> PrintedNumbers:
    """All numbers of an arm as its source has them.

    Masses are a table, tensors another; centres and lengths are two, but both hold metres, which a
    file writes to one number of decimals.
    """
    bodies, lengths = [], []
    for link in arm.links:
        body = link.inertia.expressed_in(link.source_frame.inverse())
        entries = [body.tensor[entry] for entry in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
        bodies.append([body.mass, *body.com, *entries])
        P = link.link_tip_frame
        lengths.append(P.R.T @ P.p if link_vector_is_written_at_link_tip(link) else P.p)
    numbers, link_vector = np.array(bodies, dtype=np.float64), np.array(lengths)
    mass, com, tensor = numbers[:, :1], numbers[:, 1:4], numbers[:, 4:]
    metres = np.concatenate([arm.base.p, link_vector.ravel(), com.ravel()])
    halves = np.concatenate([_halves(mass), _halves(com, metres), _halves(tensor)], axis=1)
    return PrintedNumbers(numbers, halves, link_vector, _halves(link_vector, metres))


def torque_of_inertial_digits(arm: SerialArm, numbers: PrintedNumbers, Y: Array) -> Array:
    """The effect of half a unit of each uncertain inertial number, shape (K, N, n) [N m].

    Y : `torque_regressor` of the arm at N states, shape (N, n, 10 n)
    """
    parts = [
        Y[..., 10 * i : 10 * i + 10] @ (parameter_map(link.source_frame) @ change)
        for i, link in enumerate(arm.links)
        for change in _changes(numbers.bodies[i], numbers.body_halves[i])
    ]
    return np.array(parts).reshape(-1, *Y.shape[:-1])


def torque_of_lengths(
    arm: SerialArm, numbers: PrintedNumbers, torque: Callable[[SerialArm], Array]
) -> Array:
    """The effect of half a unit of each uncertain length, shape (K, N, n) [N m].

    torque : of an arm, shape (N, n)
    """
    before = torque(arm)
    parts = []
    for i, link in enumerate(arm.links):
        rotation = link.link_tip_frame.R if link_vector_is_written_at_link_tip(link) else np.eye(3)
        for k in np.flatnonzero(numbers.length_halves[i]):
            shift = rotation[:, k] * numbers.length_halves[i, k]
            moved = with_link_tip_frame(
                link, Transform(link.link_tip_frame.R, link.link_tip_frame.p + shift)
            )
            parts.append(torque(arm_with_link(arm, i, moved)) - before)
    return np.array(parts).reshape(-1, *before.shape)


def _changes(body: Array, halves: Array) -> Iterator[Array]:
    """Change of the ten parameters, in the source frame, for half a unit of each number."""
    pi = _parameters(body)
    for k in np.flatnonzero(halves):
        moved = body.copy()
        moved[k] += halves[k]
        yield _parameters(moved) - pi


def _parameters(body: Array) -> Array:
    m, cx, cy, cz, xx, yy, zz, xy, xz, yz = (float(x) for x in body)
    return Inertia.from_entries(
        m, (cx, cy, cz), ixx=xx, iyy=yy, izz=zz, ixy=xy, ixz=xz, iyz=yz
    ).parameters()


def _halves(table: Array, beside: Array | None = None) -> Array:
    others = [] if beside is None else beside.tolist()
    return np.array(half_units(table.ravel().tolist(), others)).reshape(table.shape)


def _same(ours: Array, theirs: Array) -> Mask:
    apart = np.abs(ours - theirs)
    return np.asarray(apart <= _SAME_NUMBER * np.maximum(1.0, np.abs(ours)), dtype=np.bool_)
