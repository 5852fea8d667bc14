"""Attribution: a torque difference split exactly among geometry, gravity and parameters.

Three things make τ_a and τ_b differ at the same state: the geometry of the chain (K), gravity (G)
and the inertial parameters (π).  Each one's share is `shapley.shares` of τ(K, G, π).  Torque is
linear in π, so the last share is a regressor, averaged with the same weights, times π_a − π_b:

    Δτ = share(K) + share(G) + Ȳ (π_a − π_b)

which splits further, parameter by parameter, without residual.  Files do not give a link's ten
parameters, though, but mass, centre of mass and a tensor about that centre.
Δπ is therefore split again by `shares` of π(m, c, I_c).
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from functools import cache
from itertools import product
from typing import Literal

import numpy as np

from .._dynamics.recursion import rnea
from .._dynamics.regressor import torque_regressor
from .._robot.inertia import Inertia, parameter_map
from .._robot.states import States
from .._robot.transforms import Array
from .arm_pair import Pair, Side, check_pair
from .shapley import shares, weight

__all__ = ["PARAMETER_CONTRIBUTIONS", "Attribution", "Contribution", "attribute"]

ContributionKind = Literal[
    "geometry", "gravity", "motor inertia", "mass", "centre of mass", "tensor",
    "m", "mx", "my", "mz", "Ixx", "Ixy", "Iyy", "Ixz", "Iyz", "Izz",
]  # fmt: skip
#: `inertia.PARAMETERS` as contributions: what `attribution_detail.by_parameter` splits among.
PARAMETER_CONTRIBUTIONS: tuple[ContributionKind, ...] = (
    "m", "mx", "my", "mz", "Ixx", "Ixy", "Iyy", "Ixz", "Iyz", "Izz",
)  # fmt: skip
#: Two torques, each rounded some 32 times a joint by ε of the largest.
_ROUNDING = 64 * float(np.finfo(np.float64).eps)

#: Contributions that add up to more than this many times the difference cancel each other.
_CANCELS = 3.0

_INERTIAL: tuple[ContributionKind, ...] = ("mass", "centre of mass", "tensor")


@dataclass(frozen=True)
class Contribution:
    """What a part of a torque difference belongs to.

    Attributes
    ----------
    kind : str
        "geometry", "gravity", "motor inertia", "mass", "centre of mass" or "tensor"; one of
        `PARAMETERS` in an attribution by parameter.
    link : int or None
        From 1; None: the whole arm.
    """

    kind: ContributionKind
    link: int | None = None


@dataclass(frozen=True, eq=False)
class Attribution:
    """Δτ = τ_a − τ_b at N states of n joints, split into K contributions.

    Attributes
    ----------
    delta : ndarray, shape (N, n)
        Δτ [N m].
    contributions : tuple of Contribution, length K
    torque : ndarray, shape (K, N, n)
        Each contribution [N m]; their sum is Δτ.
    rounding : float
        What rounding alone makes of a difference [N m].
    """

    delta: Array
    contributions: tuple[Contribution, ...]
    torque: Array
    rounding: float

    @property
    def remainder(self) -> Array:
        """The residual of the attribution, shape (N, n) [N m]: rounding only, or a defect."""
        return np.asarray(self.delta - self.torque.sum(axis=0))

    def rms(self) -> Array:
        """Root mean square of each contribution over the states.

        Returns
        -------
        ndarray, shape (K, n)
            [N m]
        """
        return np.asarray(np.sqrt((self.torque**2).mean(axis=1)))

    def share(self) -> Array:
        """Part of the mean square difference of each contribution.

        ⟨t_k, Δτ⟩ / ⟨Δτ, Δτ⟩ over states and joints: negative for a contribution that works
        against the others.

        Returns
        -------
        ndarray, shape (K,)
            They sum to 1; all zero where there is no difference but rounding.
        """
        if float(np.abs(self.delta).max()) <= self.rounding:
            return np.zeros(len(self.contributions))
        power = float((self.delta**2).sum())
        return np.asarray((self.torque * self.delta).sum(axis=(1, 2)) / power)

    def weight(self) -> Array:
        """Size of each contribution as a share of all sizes.

        RMS_k / Σ RMS_j over states and joints, in [0, 1] whatever cancels: where two contributions
        of 10 N m leave a difference of 1 N m, shares say 500 % and −400 %, weights say half each.

        Returns
        -------
        ndarray, shape (K,)
            They sum to 1; all zero where no contribution is more than rounding.
        """
        if float(np.abs(self.torque).max()) <= self.rounding:
            return np.zeros(len(self.contributions))
        sizes = np.sqrt((self.torque**2).mean(axis=(1, 2)))
        return np.asarray(sizes / sizes.sum())

    @property
    def cancels(self) -> bool:
        """Whether the contributions cancel each other: rank them by `weight` then, not by `share`.

        Their RMS add up to more than _CANCELS times that of Δτ; `share` ranks what is left after
        they cancelled.
        """
        if float(np.abs(self.torque).max()) <= self.rounding:
            return False
        sizes = np.sqrt((self.torque**2).mean(axis=(1, 2)))
        return bool(sizes.sum() > _CANCELS * np.sqrt((self.delta**2).mean()))


def attribute(pair: Pair, states: States) -> Attribution:
    """Split the torque difference of a pair of arms, at every state, into contributions.

    Geometry, gravity and inertial parameters share it by Shapley's average over all orders of
    change; within the parameters it is Ȳ (π_a − π_b), without residual (docs/attribution.md).

    Parameters
    ----------
    pair : Pair
        See `pair_up`.
    states : States, shape (N, n)
        In the coordinates of the pair's first arm.

    Returns
    -------
    Attribution
        Geometry, gravity and motor inertia of the whole arm; mass, centre of mass and tensor of
        each link.

    Raises
    ------
    InputError
        For other types, no state, or states of another number of joints.

    References
    ----------
    Shapley 1953.

    Examples
    --------
    >>> import ur5check
    >>> pair = ur5check.pair_up("appendix", "erd-ur5")
    >>> found = ur5check.attribute(pair, ur5check.random_states(6, 10, seed=0))
    >>> found.torque.shape
    (21, 10, 6)
    >>> bool(abs(found.remainder).max() < found.rounding)
    True
    """
    check_pair(pair, states)
    q, qd, qdd = states.q, states.qd, states.qdd
    # Two arms mostly stand under one gravity, and then half of the choices are the other half.
    one_gravity = np.array_equal(pair.a.gravity, pair.b.gravity)

    @cache
    def torque_of(geometry: Side, gravity: Side, inertias: Side) -> Array:
        return rnea(pair.arm(geometry, inertias, gravity), q, qd, qdd)

    def torque(choice: tuple[bool, ...]) -> Array:
        geometry, gravity, inertias = choice
        return torque_of(_side(geometry), _side(gravity or one_gravity), _side(inertias))

    geometry_share, gravity_share, _ = shares(torque, 3)
    # A motor's inertia belongs to its joint, and so to the geometry so far: it is split off.
    motors = (pair.a.armature - pair.b.armature) * qdd
    geometry_share = geometry_share - motors
    inertial = np.zeros((3 * pair.a.n, *q.shape))
    dpi = _inertial_differences(pair)  # (n links, 3 contributions, 10), in a's link frames
    weights: defaultdict[tuple[Side, Side], float] = defaultdict(float)
    for geometry, gravity in product((True, False), repeat=2):
        chosen = _side(geometry), _side(gravity or one_gravity)
        weights[chosen] += weight(geometry + gravity, 3)
    for (side, gravity_side), share in weights.items():
        Y = torque_regressor(pair.arm(side, side, gravity_side), q, qd, qdd)
        inertial += share * np.concatenate(_per_link(Y, dpi, pair, side))
    contributions = [
        Contribution("geometry"),
        Contribution("gravity"),
        Contribution("motor inertia"),
    ]
    contributions += [
        Contribution(kind, link) for link in range(1, pair.a.n + 1) for kind in _INERTIAL
    ]
    tau_a, tau_b = torque((True, True, True)), torque((False, False, False))
    rounding = _ROUNDING * pair.a.n * float(max(np.abs(tau_a).max(), np.abs(tau_b).max()))
    torques = np.concatenate([geometry_share[None], gravity_share[None], motors[None], inertial])
    return Attribution(tau_a - tau_b, tuple(contributions), torques, rounding)


def _per_link(Y: Array, dpi: Array, pair: Pair, geometry: Side) -> list[Array]:
    """Y Δπ of every contribution, shape (3, N, n) a link; Δπ is taken to the frames of Y first."""
    parts = []
    for i, T in enumerate(pair.link_maps):
        columns = Y[..., 10 * i : 10 * i + 10]
        if geometry == "b":
            columns = columns @ parameter_map(T.inverse())
        parts.append(np.moveaxis(columns @ dpi[i].T, -1, 0))
    return parts


def _inertial_differences(pair: Pair) -> Array:
    """π_a − π_b of each link, split among mass, centre and tensor, shape (n, 3, 10)."""
    differences = []
    for link, b in zip(pair.a.links, pair.inertias_b(), strict=True):
        a = link.inertia

        def parameters(choice: tuple[bool, ...], a: Inertia = a, b: Inertia = b) -> Array:
            m, c, I_c = (a if is_a else b for is_a in choice)
            return Inertia(m.mass, c.com, I_c.tensor).parameters()

        differences.append(shares(parameters, 3))
    return np.array(differences)


def _side(is_a: bool) -> Side:
    return "a" if is_a else "b"
