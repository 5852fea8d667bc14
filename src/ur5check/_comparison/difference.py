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

__all__ = ["SAME_BUT_FOR_DIGITS", "SAME_TORQUE", "Difference", "compare", "diff", "under_gravity"]

#: Two arms agree if no torque differs by more than this part of the largest one.  Data sheets and
#: URDFs carry four to six digits; a millionth lies below all of them and well above rounding.
SAME_TORQUE = 1e-6

#: The same where constants written with few digits are all that differs: 1.5708 for π/2 costs some
#: 1e-5 of the largest torque, 1.57 a hundred times as much, which a controller would notice.
SAME_BUT_FOR_DIGITS = 1e-4


@dataclass(frozen=True, eq=False, repr=False)
class Difference(Result):
    """Everything that `diff` found; `reports` shows it.

    pair : both arms, in a's joint coordinates
    states, seed : where the torques were compared
    tool : forward kinematics;  parameters : link by link;  torques : per joint
    attribution : the torque difference split among parameters, at every state
    without_rounding : the largest |Δτ| with constants exact that either arm writes with few
        digits, as 1.5708 for π/2 (`Pair.corrections`); None where there are none [N m]
    """

    pair: Pair
    states: States
    seed: int
    tool: ToolError
    parameters: tuple[LinkParameters, ...]
    torques: TorqueError
    tau_a: Array
    attribution: Attribution
    without_rounding: float | None = None

    @property
    def agrees(self) -> bool:
        """Whether no torque differs by more than SAME_TORQUE of the largest; SAME_BUT_FOR_DIGITS
        where rounded digits explain the difference.
        """
        part = SAME_BUT_FOR_DIGITS if self.rounding_explains else SAME_TORQUE
        return self._largest <= part * float(np.abs(self.tau_a).max())

    @property
    def rounding_explains(self) -> bool:
        """Whether a difference is there, and none with rounded constants exact."""
        same = SAME_TORQUE * float(np.abs(self.tau_a).max())
        rest = self.without_rounding
        return rest is not None and rest <= same < self._largest

    @property
    def _largest(self) -> float:
        return float(self.torques.maximum.max())


def diff(
    a: ArmSource,
    b: ArmSource,
    *,
    samples: int = 10_000,
    seed: int = 0,
    gravity: ArrayLike | None = None,
    as_written: bool = False,
) -> Difference:
    """Compare two arms: geometry, inertias, torques, and the attribution of the difference.

    Parameters
    ----------
    a, b : the name of a shipped model, a path, a `pin.Model` or a `SerialArm` (see `load`)
    samples, seed : how many random states, drawn from which seed (see `random_states`)
    gravity : in each arm's base frame, shape (3,) [m/s²]; each arm's own when None
    as_written : whether joint angles are compared as they stand; else joints are reversed and
        shifted where that makes the axes coincide

    Raises
    ------
    InputError : a model that cannot be read, or two arms that cannot be compared.
    """
    first, second = (under_gravity(load(source), gravity) for source in (a, b))
    states = random_states(first.n, samples, seed)
    return compare(first, second, states, seed, as_written=as_written)


def under_gravity(arm: SerialArm, gravity: ArrayLike | None) -> SerialArm:
    """The arm under `gravity`, in its base frame; as it is when None."""
    return arm if gravity is None else arm.with_gravity(gravity_of(arm, gravity))


def compare(
    a: SerialArm, b: SerialArm, states: States, seed: int, *, as_written: bool = False
) -> Difference:
    """`diff` on two arms at given states."""
    pair = pair_up(a, b, as_written=as_written)
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
        _without_rounding(pair, states),
    )


def _without_rounding(pair: Pair, states: States) -> float | None:
    if not pair.corrections:
        return None
    exact = pair.without_rounding()
    tau_a, tau_b = (rnea(arm, states.q, states.qd, states.qdd) for arm in (exact.a, exact.b))
    return float(np.abs(tau_a - tau_b).max())
