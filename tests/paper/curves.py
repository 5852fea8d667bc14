"""Curves made by hand, to feed a claim with what must break it."""

from __future__ import annotations

import numpy as np

from ur5check._paper.case_runs import Run
from ur5check._paper.paper_models import PRINTED, REPAIRED
from ur5check._robot.transforms import Array

MODELS = (PRINTED, REPAIRED, "appendix", "erd-ur5", "appendix by Pinocchio")


def with_curve(run: Run, torque: Array) -> Run:
    """The run with another watched torque; what it should be stays."""
    watched = run.case.watched
    assert watched is not None
    tau = np.array(run.torque)
    tau[:, watched - 1] = torque
    return replaced(run, tau)


def replaced(run: Run, torque: Array) -> Run:
    """The run with other torques of all joints."""
    return Run(run.case, run.model, run.q, torque, run.expected)
