"""`ur5check.diff`: what differs between two arms, by how much, and from which parameters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from .._dynamics.batching import gravity_of
from .._dynamics.recursion import rnea
from .._errors import UsageError
from .._finding import Finding
from .._io.loading import ArmSource, load
from .._io.uncertainty import read_uncertainty
from .._result import Result
from .._robot.serial_arm import SerialArm
from .._robot.states import States, random_states
from .._robot.transforms import Array
from .arm_pair import Pair, Side, pair_up
from .attribution import Attribution, attribute
from .motion_difference import ToolError, TorqueError, compare_tools, compare_torques
from .other_numbers import OtherNumber, compare_other_numbers
from .parameter_table import LinkParameters, compare_parameters
from .torque_band import TorqueBand, torque_band

__all__ = ["SAME_BUT_FOR_DIGITS", "SAME_TORQUE", "Difference", "compare", "diff", "under_gravity"]

#: Two arms agree if no torque differs by more than this part of the largest one.  Data sheets and
#: URDFs carry four to six digits; a millionth lies below all of them and well above rounding.
SAME_TORQUE = 1e-6

#: The same where constants written with few digits are all that differs: 1.5708 for π/2 costs some
#: 1e-5 of the largest torque, 1.57 a hundred times as much, which a controller would notice.
SAME_BUT_FOR_DIGITS = 1e-4


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
    others : tuple of OtherNumber
        Numbers beside geometry and inertias that differ: gravity, damping, limits.
    tolerance : ndarray, shape (n,)
        Largest torque difference [N m] that counts as agreement, per joint.
    band : TorqueBand or None
        How far apart the stated uncertainties let the torques be; None where none were stated.
    without_rounding : float or None
        The largest |Δτ| with constants exact that either arm writes with few digits, as 1.5708 for
        π/2 (`Pair.corrections`); None where there are none [N m].
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
    without_rounding: float | None = None

    @property
    def same_torques(self) -> bool:
        """Whether no torque differs by more than the tolerance."""
        return bool((self.torques.maximum <= self.tolerance).all())

    @property
    def faults(self) -> Mapping[Side, tuple[Finding, ...]]:
        """Why each arm cannot exist: errors of its file that reading passed over."""
        return {"a": self.pair.a.source.faults, "b": self.pair.given_b.source.faults}

    @property
    def gravity_only(self) -> bool:
        """Whether tensors of an arm are unknown, so that the arms are compared at rest."""
        return bool(self.pair.a.unknown_tensors or self.pair.b.unknown_tensors)

    @property
    def agrees(self) -> bool:
        """Whether the torques agree, and all else that a joint's motion depends on is the same."""
        return self.same_torques and not any(other.moves_joints for other in self.others)

    @property
    def rounding_explains(self) -> bool:
        """Whether a difference is there, and none with rounded constants exact."""
        same = SAME_TORQUE * float(np.abs(self.tau_a).max())
        rest = self.without_rounding
        return rest is not None and rest <= same < float(self.torques.maximum.max())


def diff(
    a: ArmSource,
    b: ArmSource,
    *,
    samples: int = 10_000,
    seed: int = 0,
    gravity: ArrayLike | None = None,
    tolerance: float | str | None = None,
    uncertainty: str | Path | None = None,
    as_written: bool = False,
) -> Difference:
    """Compare two arms: geometry, inertias, torques, and the attribution of the difference.

    Parameters
    ----------
    a, b : name, path, pin.Model or SerialArm
        See `load`.  A body or joint that cannot exist is compared too (`Difference.faults`), as
        long as every number of the arm can be read.
    samples : int
        Number of random states, at least 1.
    seed : int
        Of the states, not negative (see `random_states`).
    gravity : array-like, shape (3,), optional
        In each arm's base frame [m/s²]; each arm's own when None.
    as_written : bool
        Whether joint angles are compared as they stand; else joints are reversed and shifted where
        that makes the axes coincide.
    tolerance : float or str, optional
        Torque difference that counts as agreement [N m], or "2%" of each joint's effort limit; a
        millionth of the largest torque when None.
    uncertainty : str or path, optional
        Standard deviations of masses, centres and tensors, "mass=1%,centre=3%", or the path of a
        .toml file (docs/uncertainty.md).

    Returns
    -------
    Difference

    Raises
    ------
    InputError
        For a model that cannot be read, two arms that cannot be compared, a tolerance or an
        uncertainty that has no meaning, or another invalid argument.

    Examples
    --------
    >>> import ur5check
    >>> difference = ur5check.diff("appendix", "erd-ur5", samples=100)
    >>> difference.agrees, difference.torques.rms.shape
    (False, (6,))
    """
    first, second = (under_gravity(load(source, strict=False), gravity) for source in (a, b))
    states = random_states(first.n, samples, seed)
    return compare(
        first,
        second,
        states,
        seed,
        tolerance=tolerance,
        uncertainty=uncertainty,
        as_written=as_written,
    )


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
    as_written: bool = False,
) -> Difference:
    """`diff` on two arms at given states."""
    pair = pair_up(a, b, as_written=as_written)
    stated = None if uncertainty is None else read_uncertainty(uncertainty, pair.a, pair.given_b)
    if a.unknown_tensors or b.unknown_tensors:
        still = np.zeros_like(states.q)
        states = States(states.q, still, still)
    tau_a = rnea(pair.a, states.q, states.qd, states.qdd)
    attribution = attribute(pair, states)
    without_rounding = _without_rounding(pair, states)
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
        _tolerance(pair, tolerance, _default_tolerance(tau_a, without_rounding)),
        None if stated is None else torque_band(pair, states, attribution.delta, stated, seed),
        without_rounding,
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


def _default_tolerance(tau_a: Array, without_rounding: float | None) -> float:
    """Larger where rounded digits are all that differs [N m]."""
    largest = float(np.abs(tau_a).max())
    rounding = without_rounding is not None and without_rounding <= SAME_TORQUE * largest
    return (SAME_BUT_FOR_DIGITS if rounding else SAME_TORQUE) * largest


def _without_rounding(pair: Pair, states: States) -> float | None:
    if not pair.corrections:
        return None
    exact = pair.without_rounding()
    tau_a, tau_b = (rnea(arm, states.q, states.qd, states.qdd) for arm in (exact.a, exact.b))
    return float(np.abs(tau_a - tau_b).max())
