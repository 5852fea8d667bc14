"""`ur5check.diff`: what differs between two arms, by how much, and from which parameters."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from .._dynamics.batching import gravity_of
from .._dynamics.recursion import rnea
from .._errors import UsageError
from .._io.loading import ArmSource, load
from .._io.uncertainty import read_uncertainty
from .._result import Result
from .._robot.serial_arm import SerialArm
from .._robot.states import States, random_states
from .._robot.transforms import Array
from .arm_pair import Pair, pair_up
from .attribution import Attribution, attribute
from .motion_difference import ToolError, TorqueError, compare_tools, compare_torques
from .other_numbers import OtherNumber, compare_other_numbers
from .parameter_table import LinkParameters, compare_parameters
from .torque_band import TorqueBand, torque_band

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
    others : numbers beside geometry and inertias that differ: gravity, damping, limits, …
    tolerance : largest torque difference [N m] that counts as agreement, per joint, shape (n,)
    band : how far apart the stated uncertainties let the torques be; None where none were stated
    """

    pair: Pair
    states: States
    seed: int
    tool: ToolError
    parameters: tuple[LinkParameters, ...]
    torques: TorqueError
    tau_a: Array
    attribution: Attribution
    others: tuple[OtherNumber, ...]
    tolerance: Array
    band: TorqueBand | None = None

    @property
    def same_torques(self) -> bool:
        """Whether no torque differs by more than the tolerance."""
        return bool((self.torques.maximum <= self.tolerance).all())

    @property
    def agrees(self) -> bool:
        """Whether the torques agree, and all else that a joint's motion depends on is the same."""
        return self.same_torques and not any(other.moves_joints for other in self.others)


def diff(
    a: ArmSource,
    b: ArmSource,
    *,
    samples: int = 10_000,
    seed: int = 0,
    gravity: ArrayLike | None = None,
    tolerance: float | str | None = None,
    uncertainty: str | Path | None = None,
) -> Difference:
    """Compare two arms: geometry, inertias, torques, and the attribution of the difference.

    Parameters
    ----------
    a, b : the name of a shipped model, a path, a `pin.Model` or a `SerialArm` (see `load`)
    samples, seed : how many random states, drawn from which seed (see `random_states`)
    gravity : in each arm's base frame, shape (3,) [m/s²]; each arm's own when None
    tolerance : torque difference that counts as agreement [N m], or "2%" of each joint's effort
        limit; a millionth of the largest torque when None
    uncertainty : standard deviations of masses, centres and tensors, "mass=1%,centre=3%", or the
        path of a .toml file (docs/uncertainty.md)

    Raises
    ------
    InputError : a model that cannot be read, two arms that cannot be compared, or a tolerance or
        an uncertainty that has no meaning.
    """
    first, second = (under_gravity(load(source), gravity) for source in (a, b))
    states = random_states(first.n, samples, seed)
    return compare(first, second, states, seed, tolerance=tolerance, uncertainty=uncertainty)


def under_gravity(arm: SerialArm, gravity: ArrayLike | None) -> SerialArm:
    """The arm under `gravity`, in its base frame; as it is when None."""
    return arm if gravity is None else arm.with_gravity(gravity_of(arm, gravity))


def compare(
    a: SerialArm,
    b: SerialArm,
    states: States,
    seed: int,
    *,
    tolerance: float | str | None = None,
    uncertainty: str | Path | None = None,
) -> Difference:
    """`diff` on two arms at given states."""
    pair = pair_up(a, b)
    stated = None if uncertainty is None else read_uncertainty(uncertainty, pair.a, pair.given_b)
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
        compare_other_numbers(pair),
        _tolerance(pair, tolerance, SAME_TORQUE * float(np.abs(tau_a).max())),
        None if stated is None else torque_band(pair, states, attribution.delta, stated, seed),
    )


def _tolerance(pair: Pair, given: float | str | None, default: float) -> Array:
    """Of each joint, shape (n,) [N m].  Raises UsageError."""
    if given is None:
        return np.full(pair.a.n, default)
    text = str(given).strip()
    try:
        size = float(text.removesuffix("%"))
    except ValueError:
        size = np.nan
    if not (np.isfinite(size) and size >= 0.0):
        raise UsageError(f"tolerance {given!r}: give a torque [N m], or '2%' of the effort limits")
    if not text.endswith("%"):
        return np.full(pair.a.n, size)
    limits = pair.effort_limits
    if np.isnan(limits).any():
        joint = pair.a.joints[int(np.isnan(limits).argmax())].name
        raise UsageError(f"tolerance {text}: no effort limit of joint {joint!r}; give it in N m")
    return np.asarray(size / 100.0 * limits)
