"""Identifiability: the base parameters of an arm.

τ = Y(q, q̇, q̈) π, and Y over all states has fewer independent columns than the 10 n parameters.
A change of π within the null space of Y changes no torque at any state; only the r base
parameters

    π_base = π[base] + β π[dependent],     τ = Y[base] π_base

can be identified from motion and torque (Mayeda, Yoshida & Osuka, IEEE T-RA 6(3), 1990; Gautier &
Khalil, "Direct calculation of minimum set of inertial parameters of serial robots", IEEE T-RA 6(3),
1990, pp. 368–373).  The closed-form rules of these papers need a DH table; `base_parameters` gets
the same sets from numbers, for any chain.

Which parameters stand for their combination is a choice.  Ours is that of the textbooks: low links
before high ones, and in a link the tensor, then the first moments, then the mass.  So the mass of a
forearm appears as a part of the upper arm's inertia, and not the other way round.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from ..._arguments import choice
from ..._dynamics.base_parameters import SAME_DIRECTION, decompose
from ..._dynamics.regressor import torque_regressor
from ..._robot.as_arm import ArmSource, as_arm
from ..._robot.inertia import PARAMETERS, parameter_map
from ..._robot.states import random_states
from ..._robot.transforms import Array, frozen

__all__ = [
    "CERTAIN_GAP",
    "WEAKEST",
    "Identifiability",
    "Label",
    "identify",
]

Label = Literal["identifiable", "in combination", "invisible"]

#: The rank is certain where singular values fall by more than this.  Exact geometry gives some
#: 1e11, and rounded angles of 11 digits still 1e8.
CERTAIN_GAP = 1e6

#: A kept direction weaker than this part of the strongest comes from a rounded angle (π/2 with
#: four digits is 1e-4 off) rather than from the design.  The UR5's weakest is 0.08.
WEAKEST = 1e-4

# Places of `PARAMETERS` in the order in which we want them as base parameters.
_WANTED = (4, 5, 6, 7, 8, 9, 1, 2, 3, 0)
_KIND = (0, 1, 1, 1, 2, 2, 2, 2, 2, 2)  # mass, first moment, tensor: their units differ


@dataclass(frozen=True, eq=False)
class Identifiability:
    """Which of an arm's 10 n parameters its torques identify.

    Attributes
    ----------
    names : tuple of str, length 10 n
        "m1", "mx1" … "Izz1", "m2" …, in the order of `SerialArm.parameters`.
    rank : int
        Number of base parameters.
    gap : float
        Smallest kept over largest dropped singular value.
    singular_values : ndarray, shape (10 n,)
        Of Y over seeded random states, columns scaled by kind.
    base, dependent : tuple of int, lengths rank and 10 n − rank
        Places of the parameters that stand for a combination, and of the others.
    beta : ndarray, shape (rank, 10 n − rank)
        π_base = π[base] + beta @ π[dependent].
    null_space : ndarray, shape (10 n, 10 n − rank)
        Column k raises dependent parameter k by one and changes the base parameters so that no
        torque changes.
    labels : tuple of str, length 10 n
        "identifiable", "in combination" or "invisible".
    """

    names: tuple[str, ...]
    rank: int
    gap: float
    singular_values: Array
    base: tuple[int, ...]
    dependent: tuple[int, ...]
    beta: Array
    null_space: Array
    labels: tuple[Label, ...]

    @property
    def columns(self) -> int:
        """Number of parameters, 10 n."""
        return len(self.names)

    @property
    def weakest(self) -> float:
        """The smallest kept singular value, as a share of the largest of all."""
        return float(self.singular_values[self.rank - 1] / self.singular_values[0])

    @property
    def certain(self) -> bool:
        """Whether the rank is certain: `gap` above CERTAIN_GAP, and `weakest` above WEAKEST."""
        return self.gap > CERTAIN_GAP and self.weakest > WEAKEST

    def names_of(self, label: Label) -> tuple[str, ...]:
        """The parameters with a label.

        Parameters
        ----------
        label : {"identifiable", "in combination", "invisible"}

        Returns
        -------
        tuple of str
        """
        pairs = zip(self.names, self.labels, strict=True)
        return tuple(name for name, own in pairs if own == label)

    def base_parameters(self, pi: ArrayLike) -> Array:
        """The base parameters π_base of parameters, or of a difference of parameters.

        Parameters
        ----------
        pi : array-like, shape (10 n,)
            In the frames that `identify` was given.

        Returns
        -------
        ndarray, shape (rank,)
            [kg], [kg m] or [kg m²], as the parameters at `base`.

        Raises
        ------
        ModelError
            For another shape, or entries that are not finite numbers.
        """
        pi = frozen(pi, (self.columns,))
        return np.asarray(pi[list(self.base)] + self.beta @ pi[list(self.dependent)])

    def combinations(self) -> tuple[str, ...]:
        """Each base parameter written out, as "Izz1 + Iyy2 + 0.1806·m3"; coefficients to 4 digits.

        A coefficient below SAME_DIRECTION, in SI units, is a rounded digit and is left out.

        Returns
        -------
        tuple of str, length rank
        """
        return tuple(
            self.names[place]
            + "".join(
                _term(coefficient, self.names[other])
                for coefficient, other in zip(row, self.dependent, strict=True)
                if abs(coefficient) > SAME_DIRECTION
            )
            for place, row in zip(self.base, self.beta, strict=True)
        )


def identify(
    arm: ArmSource,
    *,
    seed: int = 0,
    gravity: ArrayLike | None = None,
    frame: Literal["link", "source"] = "link",
    rotors: bool = False,
) -> Identifiability:
    """The base parameters of an arm.  Its inertias play no part, only geometry and gravity.

    Parameters
    ----------
    arm : name, path, pin.Model or SerialArm
        See `load`.
    seed : int
        Of the random states at which Y is evaluated; the result does not depend on it.
    gravity : array-like, shape (3,), optional
        In the arm's base frame [m/s²]; its own when None.
    frame : {"link", "source"}
        Parameters in the frames i, as `SerialArm.parameters` has them, or in the frames in which
        the arm's own file writes them (for a URDF those at the joints).
    rotors : bool
        Whether motor inertias are unknown too: what has the same torques as one of them is then
        not identifiable.

    Returns
    -------
    Identifiability

    Raises
    ------
    InputError
        For an arm that cannot be read, or an invalid argument.

    References
    ----------
    Gautier & Khalil 1990; Mayeda, Yoshida & Osuka 1990; Gautier 1991.

    Examples
    --------
    >>> import ur5check
    >>> found = ur5check.identify("paper")
    >>> found.rank, found.columns
    (36, 60)
    """
    arm = as_arm(arm)
    choice("frame", frame, ("link", "source"))
    states = random_states(arm.n, 40 + 40 * arm.n, seed)
    Y = torque_regressor(arm, states.q, states.qd, states.qdd, gravity)
    if rotors:
        for j, qdd in enumerate(states.qdd.T):
            Y[:, j] -= np.outer(qdd, qdd @ Y[:, j]) / (qdd @ qdd)
    Y = Y.reshape(-1, 10 * arm.n)
    if frame == "source":
        for block, link in zip(np.split(Y, arm.n, axis=1), arm.links, strict=True):
            block[:] = block @ parameter_map(link.source_frame)
    found = decompose(Y, _scale(Y), [10 * i + k for i in range(arm.n) for k in _WANTED])
    null_space = np.zeros((10 * arm.n, len(found.dependent)))
    null_space[list(found.dependent)] = np.eye(len(found.dependent))
    null_space[list(found.base)] = -found.beta
    return Identifiability(
        tuple(f"{name}{i}" for i in range(1, arm.n + 1) for name in PARAMETERS),
        found.rank,
        found.gap,
        found.singular_values,
        found.base,
        found.dependent,
        found.beta,
        null_space,
        tuple(_label(*sizes) for sizes in zip(found.seen, found.unseen, strict=True)),
    )


def _scale(Y: Array) -> Array:
    """For each column, the largest column of its kind over all links.

    A column is not scaled by its own size: one that a rounded angle has raised from zero to 1e-9
    would look as large as any.
    """
    sizes = np.linalg.norm(Y, axis=0).reshape(-1, 10)
    kinds = np.array(_KIND)
    largest = np.array([sizes[:, kinds == kind].max() for kind in range(3)])
    largest[largest == 0.0] = 1.0
    return np.tile(largest[kinds], len(sizes))


def _label(seen: float, unseen: float) -> Label:
    if seen < SAME_DIRECTION:
        return "invisible"
    return "identifiable" if unseen < SAME_DIRECTION else "in combination"


def _term(coefficient: float, name: str) -> str:
    size = f"{float(f'{abs(coefficient):.10g}'):.4g}"  # rounding must not decide where 0.39225 goes
    return f" {'+' if coefficient > 0 else '−'} {'' if size == '1' else f'{size}·'}{name}"
