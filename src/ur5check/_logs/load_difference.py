"""What a robot carries, from a run with the load and one without it.

Both runs have the same links and drives.  So all base parameters and drives are fitted to both
together, and the load to the loaded run alone: errors of the model, which would look like a load,
fall out.  Drive gains do not: a gain of 1.1 makes the load 1.1 times as heavy.
"""

from __future__ import annotations

import numpy as np

from .._dynamics.regressor import torque_regressor
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .joint_residuals import model_torque, thinned
from .least_squares import UNEXCITED, blocks_of
from .point_mass import PointMass, point_mass
from .signals import Signals

__all__ = ["load_difference"]


def load_difference(arm: SerialArm, loaded: Signals, unloaded: Signals, sizes: Array) -> PointMass:
    """The load as a point mass in the arm's tip frame.

    sizes : of the joints' residuals, shape (n,)
    """
    runs = [signals.selected(thinned(signals)) for signals in (loaded, unloaded)]
    n, k = arm.n, loaded.drive.shape[2]
    common, load, residual, blocks, count = [], [], [], [], 0
    for number, s in enumerate(runs):
        Y = torque_regressor(arm, s.q, s.qd, s.qdd)
        X = np.zeros((s.count, n, 10 * n + k * n))
        X[:, :, : 10 * n] = Y
        for j in range(n):
            X[:, j, 10 * n + k * j : 10 * n + k * (j + 1)] = s.drive[:, j]
        common.append((X / sizes[:, None]).reshape(s.count * n, -1))
        carried = Y[:, :, -10:] / sizes[:, None]
        load.append((carried if number == 0 else 0.0 * carried).reshape(-1, 10))
        residual.append(((s.tau - model_torque(arm, s)) / sizes).reshape(-1))
        own = np.repeat(blocks_of(s.t, s.segment, s.cutoff), n) + count
        blocks.append(own)
        count = int(own.max()) + 1
    X = np.concatenate(common)
    scale = np.linalg.norm(X, axis=0)
    U, s_values, _ = np.linalg.svd(X / np.where(scale > 0.0, scale, 1.0), full_matrices=False)
    U = U[:, s_values > UNEXCITED * s_values[0]]
    P, e = np.concatenate(load), np.concatenate(residual)
    return point_mass(P - U @ (U.T @ P), e - U @ (U.T @ e), np.concatenate(blocks))
