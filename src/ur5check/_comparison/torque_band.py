"""How far apart the torques of two models may be by the stated uncertainties of their numbers.

τ = Y π is linear in the inertial parameters, so that Δτ has the variance σ_j² = y_j Σ y_jᵀ, summed
over both models and all links, with y_j the row of joint j.  At one state chosen beforehand |Δτ_j|
exceeds 2 σ_j with a probability of 5 %.  Over many states and joints the largest ratio is
larger, by how much depends on Y: it is drawn at random, from parameters with the covariance Σ.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .._dynamics.regressor import torque_regressor
from .._robot.serial_arm import SerialArm
from .._robot.states import States
from .._robot.transforms import Array
from .._robot.uncertainty import ArmUncertainty
from .arm_pair import Pair

__all__ = ["TorqueBand", "torque_band"]

_STATES = 1_000  # enough for the share and the largest ratio; Y of more takes much memory
_DRAWS = 1_000
_CONFIDENCE = 0.95
_ROUNDING = 1e-12  # of the largest torque: |Δτ| below it is no difference where σ is zero


@dataclass(frozen=True, eq=False)
class TorqueBand:
    """Δτ against its standard deviation σ_j, joint by joint.

    Attributes
    ----------
    sigma : ndarray, shape (n,)
        RMS over the states of σ_j [N m or N].
    ratio : ndarray, shape (n,)
        Largest |Δτ_j| / (2 σ_j).
    worst : ndarray of int, shape (n,)
        Index of the state with that ratio.
    share : ndarray, shape (n,)
        Of the states where |Δτ_j| > 2 σ_j, from 0 to 1.
    allowed : float
        The largest ratio over all states and joints stays below this with a probability of 95 %,
        if both models describe the same robot with these uncertainties.
    """

    sigma: Array
    ratio: Array
    worst: Array
    share: Array
    allowed: float

    @property
    def exceeded(self) -> tuple[int, ...]:
        """Joints, from 1, at which the models differ by more than the uncertainties allow."""
        return tuple(int(j) + 1 for j in np.flatnonzero(self.ratio > self.allowed))


def torque_band(
    pair: Pair,
    states: States,
    delta: Array,
    uncertainties: tuple[ArmUncertainty, ArmUncertainty],
    seed: int,
) -> TorqueBand:
    """The band of Δτ, shape (N, n), at these states; of many states, at the first thousand."""
    few = States(states.q[:_STATES], states.qd[:_STATES], states.qdd[:_STATES])
    delta = delta[:_STATES]
    # G Gᵀ is the covariance of Δτ: Y times a square root of Σ, of both models side by side.
    G = np.concatenate(
        [
            _scaled_regressor(arm, few, [uncertainty.covariance(link) for link in arm.links])
            for arm, uncertainty in zip((pair.a, pair.b), uncertainties, strict=True)
        ],
        axis=-1,
    )
    sigma = np.linalg.norm(G, axis=-1)
    known = sigma > 0.0
    floor = _ROUNDING * max(float(np.abs(delta).max()), 1.0)
    ratio = np.where(np.abs(delta) > floor, np.inf, 0.0)
    ratio[known] = np.abs(delta[known]) / (2.0 * sigma[known])
    draws = np.random.default_rng((seed, 2)).standard_normal((G.shape[-1], _DRAWS))
    largest = np.zeros(_DRAWS)
    for Y, deviation in zip(G, sigma, strict=True):
        moving = deviation > 0.0
        if moving.any():
            drawn = np.abs(Y[moving] @ draws) / (2.0 * deviation[moving, None])
            largest = np.maximum(largest, drawn.max(axis=0))
    return TorqueBand(
        np.sqrt((sigma**2).mean(axis=0)),
        ratio.max(axis=0),
        ratio.argmax(axis=0),
        (ratio > 1.0).mean(axis=0),
        float(np.quantile(largest, _CONFIDENCE)),
    )


def _scaled_regressor(arm: SerialArm, states: States, covariances: Sequence[Array]) -> Array:
    """Y L, shape (N, n, 10 n), with L Lᵀ = Σ, block by block."""
    Y = torque_regressor(arm, states.q, states.qd, states.qdd)
    blocks = np.split(Y, arm.n, axis=-1)
    return np.concatenate(
        [block @ _root(covariance) for block, covariance in zip(blocks, covariances, strict=True)],
        axis=-1,
    )


def _root(covariance: Array) -> Array:
    """L with L Lᵀ = Σ, which may be singular."""
    values, vectors = np.linalg.eigh(covariance)
    return np.asarray(vectors * np.sqrt(np.maximum(values, 0.0)))
