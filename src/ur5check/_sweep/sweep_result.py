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
    """Δτ = τ_a − τ_b over all states of a plan; arrays of shape (n,) unless said otherwise.

    pair : both arms, in a's joint coordinates
    plan : states, tolerance, reach map
    statistics : of Δτ over all states
    scale_rms, scale_max : of τ_a in the first block [N m], for comparison
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
        """Root mean square of Δτ [N m]."""
        return np.array([mean(total, self.count) ** 0.5 for total in self.statistics.squares])

    @property
    def maximum(self) -> Array:
        """Largest |Δτ| [N m]."""
        return self.statistics.maximum

    @property
    def effort(self) -> Array:
        """The joints' effort limits [N m], see `Pair.effort_limits`."""
        return self.pair.effort_limits

    def share_of_effort(self) -> Array:
        """Maximum as a share of the effort limit; nan where there is no limit."""
        return np.asarray(self.maximum / self.effort)

    def worst_state(self, joint: int) -> dict[str, list[float]]:
        """The state of a joint's maximum, joints counted from 0."""
        q, qd, qdd = self.statistics.worst_states[joint].tolist()
        return {"q": q, "qd": qd, "qdd": qdd}

    def quantile(self, share: float) -> Array:
        """|Δτ| that `share` of the states do not exceed [N m], to a relative RELATIVE_ERROR."""
        found = [quantile(counts, share) for counts in self.statistics.bins]
        return np.asarray(np.minimum(found, self.maximum))

    def share_over(self) -> Array | None:
        """Share of the states with |Δτ| above the tolerance; None if there is none."""
        return (
            None
            if self.plan.tolerance is None
            else np.asarray(self.statistics.above_tolerance / self.count)
        )

    @property
    def agrees(self) -> bool:
        """Whether no torque differs by more than SAME_TORQUE of the largest of τ_a."""
        return float(self.maximum.max()) <= SAME_TORQUE * float(self.scale_max.max())
