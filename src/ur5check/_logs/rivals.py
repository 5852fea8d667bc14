"""Several models against one recording: which explains it better, and is that more than chance?

Both models are tried on the same samples.  Their squared residuals, weighted by the better floor,
are compared block of time by block of time, in pairs: what disturbs both falls out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .joint_residuals import JointResidual, thinned
from .least_squares import blocks_of
from .signals import Signals

__all__ = ["Rival", "rival_of"]


@dataclass(frozen=True)
class Rival:
    """Another model.

    label : of the model
    difference, half_width : of mean squared weighted residuals, the other model's less the first
        one's; 95 % interval.  Above 0 the first model is the better one
    """

    label: str
    difference: float
    half_width: float

    @property
    def clear(self) -> bool:
        """Whether one is better by more than chance."""
        return abs(self.difference) > self.half_width


def rival_of(
    label: str,
    signals: Signals,
    first: tuple[JointResidual, ...],
    other: tuple[JointResidual, ...],
) -> Rival:
    """Compare two models' residuals with friction and rotor inertia, of the same signals."""
    from scipy.stats import t as student

    part = signals.selected(thinned(signals))
    blocks = blocks_of(part.t, part.segment, part.cutoff)
    total = np.zeros(part.count)
    for a, b in zip(first, other, strict=True):
        size = max(min(a.floor, b.floor), 1e-300)
        total += (b.drive.residual**2 - a.drive.residual**2) / (size**2 * len(first))
    means = np.bincount(blocks, total) / np.bincount(blocks)
    quantile = float(student.ppf(0.975, max(1, len(means) - 1)))
    half_width = quantile * float(means.std(ddof=1)) / np.sqrt(len(means))
    return Rival(label, float(means.mean()), half_width)
