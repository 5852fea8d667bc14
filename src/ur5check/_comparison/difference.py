"""`ur5check.diff`: what differs between two arms, by how much, and from which parameters."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._dynamics.batching import gravity_of
from .._dynamics.recursion import rnea
from .._io.loading import ArmSource, load
from .._result import Result
from .._robot.serial_arm import SerialArm
from .._robot.states import States, random_states
from .._robot.transforms import Array
from .arm_pair import Pair, pair_up
from .attribution import Attribution, attribute
from .motion_difference import ToolError, TorqueError, compare_tools, compare_torques
from .parameter_table import LinkParameters, compare_parameters

__all__ = ["SAME_TORQUE", "Difference", "compare", "diff", "under_gravity"]

#: Two arms agree if no torque differs by more than this part of the largest one.  Data sheets and
#: URDFs carry four to six digits; a millionth lies below all of them and well above rounding.
SAME_TORQUE = 1e-6


@dataclass(frozen=True, eq=False, repr=False)
class Difference(Result):
    """Everything that `diff` found.

    Attributes
    ----------
    pair : Pair
        Both arms, in a's joint coordinates.
    states : States, shape (N, n)
        Where the torques were compared.
    seed : int
        Of the states.
    tool : ToolError
        Of the forward kinematics.
    parameters : tuple of LinkParameters, length n
    torques : TorqueError
        Statistics of Δτ = τ_a − τ_b, joint by joint.
    tau_a : ndarray, shape (N, n)
        Torques of arm a [N m].
    attribution : Attribution
        The torque difference split among parameters, at every state.
    """

    pair: Pair
    states: States
    seed: int
    tool: ToolError
    parameters: tuple[LinkParameters, ...]
    torques: TorqueError
    tau_a: Array
    attribution: Attribution

    @property
    def agrees(self) -> bool:
        """Whether no torque differs by more than SAME_TORQUE of the largest."""
        return float(self.torques.maximum.max()) <= SAME_TORQUE * float(np.abs(self.tau_a).max())


def diff(
    a: ArmSource,
    b: ArmSource,
    *,
    samples: int = 10_000,
    seed: int = 0,
    gravity: ArrayLike | None = None,
) -> Difference:
    """Compare two arms: geometry, inertias, torques, and the attribution of the difference.

    Parameters
    ----------
    a, b : name, path, pin.Model or SerialArm
        See `load`.
    samples : int
        Number of random states, at least 1.
    seed : int
        Of the states, not negative (see `random_states`).
    gravity : array-like, shape (3,), optional
        In each arm's base frame [m/s²]; each arm's own when None.

    Returns
    -------
    Difference

    Raises
    ------
    InputError
        For a model that cannot be read, two arms that cannot be compared, or an invalid argument.

    Examples
    --------
    >>> import ur5check
    >>> difference = ur5check.diff("appendix", "erd-ur5", samples=100)
    >>> difference.agrees, difference.torques.rms.shape
    (False, (6,))
    """
    first, second = (under_gravity(load(source), gravity) for source in (a, b))
    return compare(first, second, random_states(first.n, samples, seed), seed)


def under_gravity(arm: SerialArm, gravity: ArrayLike | None) -> SerialArm:
    """The arm under `gravity`, in its base frame; as it is when None."""
    return arm if gravity is None else arm.with_gravity(gravity_of(arm, gravity))


def compare(a: SerialArm, b: SerialArm, states: States, seed: int) -> Difference:
    """`diff` on two arms at given states."""
    pair = pair_up(a, b)
    tau_a = rnea(pair.a, states.q, states.qd, states.qdd)
    attribution = attribute(pair, states)
    return Difference(
        pair,
        states,
        seed,
        compare_tools(pair, states),
        compare_parameters(pair),
        compare_torques(pair, attribution.delta, tau_a),
        tau_a,
        attribution,
    )
