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
    """Everything that `diff` found; `reports` shows it.

    pair : both arms, in a's joint coordinates
    states, seed : where the torques were compared
    tool : forward kinematics;  parameters : link by link;  torques : per joint
    attribution : the torque difference split among parameters, at every state
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
    def gravity_only(self) -> bool:
        """Whether tensors of an arm are unknown, so that the arms are compared at rest."""
        return bool(self.pair.a.unknown_tensors or self.pair.b.unknown_tensors)

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
    a, b : the name of a shipped model, a path, a `pin.Model` or a `SerialArm` (see `load`)
    samples, seed : how many random states, drawn from which seed (see `random_states`)
    gravity : in each arm's base frame, shape (3,) [m/s²]; each arm's own when None

    Raises
    ------
    InputError : a model that cannot be read, or two arms that cannot be compared.
    """
    first, second = (under_gravity(load(source), gravity) for source in (a, b))
    return compare(first, second, random_states(first.n, samples, seed), seed)


def under_gravity(arm: SerialArm, gravity: ArrayLike | None) -> SerialArm:
    """The arm under `gravity`, in its base frame; as it is when None."""
    return arm if gravity is None else arm.with_gravity(gravity_of(arm, gravity))


def compare(a: SerialArm, b: SerialArm, states: States, seed: int) -> Difference:
    """`diff` on two arms at given states."""
    pair = pair_up(a, b)
    if a.unknown_tensors or b.unknown_tensors:
        still = np.zeros_like(states.q)
        states = States(states.q, still, still)
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
