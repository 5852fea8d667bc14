"""Drive gains from a file that holds both motor current and the controller's own torque.

At every moment current × gain = controller's torque + friction.  So the current, fitted by the
controller's torque and by friction, has 1 / gain as the first coefficient.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._robot.transforms import Array
from .least_squares import blocks_of, fit
from .recording import Recording
from .signals import Signals

__all__ = ["DriveGain", "drive_gains"]


@dataclass(frozen=True)
class DriveGain:
    """Of one joint [N m/A]; value ± half_width is a 95 % interval; nan where nothing stands out."""

    joint: str
    value: float
    half_width: float


def drive_gains(recording: Recording, signals: Signals, current: Array) -> tuple[DriveGain, ...]:
    """Each joint's gain.

    signals : whose `model_tau` is the controller's torque
    current : filtered like the signals, shape (N, n) [A]
    """
    assert signals.model_tau is not None  # noqa: S101 - of a recording that has both
    blocks = blocks_of(signals.t, signals.segment, signals.cutoff)
    gains = []
    for j, joint in enumerate(recording.joints):
        torque = signals.model_tau[:, j]
        X = np.column_stack([torque, signals.drive[:, j]])
        found = fit(X, current[:, j], blocks)
        slope, spread = float(found.value[0]), float(found.half_width[0])
        if abs(slope) * torque.std() > found.residual.std() and abs(slope) > spread:
            gains.append(DriveGain(joint, 1.0 / slope, spread / slope**2))
        else:
            gains.append(DriveGain(joint, float("nan"), float("nan")))
    return tuple(gains)
