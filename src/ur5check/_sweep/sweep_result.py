"""The result of a sweep."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._comparison.arm_pair import Pair
from .._comparison.difference import SAME_TORQUE
from .._result import Result
from .._robot.transforms import Array
from .exact_sum import mean
from .magnitude_histogram import quantile
from .statistics import Statistics
from .sweep_plan import Plan

__all__ = ["QUANTILES", "Sweep"]

#: Shares of the states whose quantiles of |Δτ| are reported.
QUANTILES = (0.5, 0.9, 0.99, 0.999)


@dataclass(frozen=True, eq=False, repr=False)
class Sweep(Result):
    """Δτ = τ_a − τ_b of n joints over all states of a sweep.

    Attributes
    ----------
    pair : Pair
        Both arms, in a's joint coordinates.
    plan : Plan
        States, tolerance, reach map.
    statistics : Statistics
        Of Δτ over all states.
    scale_rms, scale_max : ndarray, shape (n,)
        Of τ_a in the first block [N m], for comparison.
    """

    pair: Pair
    plan: Plan
    statistics: Statistics
    scale_rms: Array
    scale_max: Array

    @property
    def count(self) -> int:
        """Number of states."""
        return self.statistics.count

    @property
    def log(self) -> tuple[tuple[str, str], ...]:
        """(name, SHA-256) of the log, if the states come from one."""
        of = self.plan.sample.description()
        return ((of["file"], of["sha256"]),) if "file" in of else ()

    @property
    def rms(self) -> Array:
        """Root mean square of Δτ, shape (n,) [N m]."""
        return np.array([mean(total, self.count) ** 0.5 for total in self.statistics.squares])

    @property
    def maximum(self) -> Array:
        """Largest |Δτ|, shape (n,) [N m]."""
        return self.statistics.maximum

    @property
    def effort(self) -> Array:
        """The joints' effort limits, shape (n,) [N m], see `Pair.effort_limits`."""
        return self.pair.effort_limits

    def share_of_effort(self) -> Array:
        """The maximum as a share of the effort limit.

        Returns
        -------
        ndarray, shape (n,)
            nan where there is no limit.
        """
        return np.asarray(self.maximum / self.effort)

    def worst_state(self, joint: int) -> dict[str, list[float]]:
        """The state of a joint's maximum.

        Parameters
        ----------
        joint : int
            From 0.

        Returns
        -------
        dict
            "q", "qd" and "qdd", n numbers each [rad], [rad/s], [rad/s²].
        """
        q, qd, qdd = self.statistics.worst_states[joint].tolist()
        return {"q": q, "qd": qd, "qdd": qdd}

    def quantile(self, share: float) -> Array:
        """The |Δτ| that a share of the states do not exceed, to a relative RELATIVE_ERROR.

        Parameters
        ----------
        share : float
            From 0 to 1.

        Returns
        -------
        ndarray, shape (n,)
            [N m]
        """
        found = [quantile(counts, share) for counts in self.statistics.bins]
        return np.asarray(np.minimum(found, self.maximum))

    def share_over(self) -> Array | None:
        """Share of the states with |Δτ| above the tolerance.

        Returns
        -------
        ndarray, shape (n,), or None
            None without a tolerance.
        """
        return (
            None
            if self.plan.tolerance is None
            else np.asarray(self.statistics.above_tolerance / self.count)
        )

    @property
    def agrees(self) -> bool:
        """Whether no torque differs by more than SAME_TORQUE of the largest of τ_a."""
        return float(self.maximum.max()) <= SAME_TORQUE * float(self.scale_max.max())
