"""A curve over one turn as a sine: amplitude, phase, offset, and how much of it is none."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._robot.transforms import Array

__all__ = ["Harmonic", "fit_harmonic"]


@dataclass(frozen=True)
class Harmonic:
    """τ(θ) ≈ offset + amplitude · sin(θ + phase).

    amplitude, offset : [N m]
    phase : in (−π, π] [rad]; nan where the amplitude is only rounding
    residual : largest |τ − fit| over the turn [N m]
    """

    amplitude: float
    phase: float
    offset: float
    residual: float

    @property
    def departure(self) -> float:
        """How far the curve lies from a pure sine, as a part of the amplitude; nan for no sine."""
        if np.isnan(self.phase):
            return float("nan")
        return (abs(self.offset) + self.residual) / self.amplitude


def fit_harmonic(angle: Array, torque: Array, rounding: float) -> Harmonic:
    """The sine of one period a turn that lies closest, by least squares.

    angle, torque : shape (N,) [rad], [N m], over whole turns;  rounding : below it, there is no
    amplitude [N m]
    """
    basis = np.column_stack([np.sin(angle), np.cos(angle), np.ones_like(angle)])
    (sine, cosine, offset), *_ = np.linalg.lstsq(basis, torque, rcond=None)
    amplitude = float(np.hypot(sine, cosine))
    phase = float(np.arctan2(cosine, sine)) if amplitude > rounding else float("nan")
    residual = float(np.abs(torque - basis @ (sine, cosine, offset)).max())
    return Harmonic(amplitude, phase, float(offset), residual)
