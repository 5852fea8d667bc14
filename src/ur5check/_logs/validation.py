"""A fit tried on another recording: what it explains of data that it has not seen."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._dynamics.regressor import torque_regressor
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .joint_residuals import Floor, JointResidual, floor_of, model_torque, thinned
from .signals import Signals

__all__ = ["Validation", "validated"]


@dataclass(frozen=True, eq=False)
class Validation:
    """Standard deviations of the other recording's residuals, joint by joint, shape (n,) [N m].

    file : the other recording
    given : with the given model, and the drives fitted to the first recording
    fitted : with all base parameters and drives fitted to the first recording
    floor : with all of them fitted to the other recording itself
    """

    file: str
    given: Array
    fitted: Array
    floor: Array

    @property
    def helps(self) -> bool:
        """Whether fitted parameters explain the other recording better than the given ones do."""
        ratio = (self.fitted / np.maximum(self.given, 1e-300)) ** 2
        return bool(ratio.mean() < 1.0)


def validated(
    arm: SerialArm, file: str, other: Signals, joints: tuple[JointResidual, ...], floor: Floor
) -> Validation:
    """Try both fits of the first recording on another."""
    s = other.selected(thinned(other))
    own = np.stack([joint.drive.value for joint in joints])
    given = s.tau - model_torque(arm, s) - np.einsum("tjk,jk->tj", s.drive, own)
    fitted = (
        s.tau
        - torque_regressor(arm, s.q, s.qd, s.qdd) @ floor.parameters
        - np.einsum("tjk,jk->tj", s.drive, floor.drives)
    )
    return Validation(file, _size(given), _size(fitted), floor_of(arm, other).sizes)


def _size(residual: Array) -> Array:
    """Root mean square: an offset between recordings counts."""
    return np.asarray(np.sqrt((residual**2).mean(axis=0)))
