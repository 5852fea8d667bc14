"""Fixtures of the models that are checked; a test that asks for one runs once for each model."""

from __future__ import annotations

from pathlib import Path

import pytest

from .._engines.engine import ReferenceEngine
from .._robot.robot import Robot
from .._robot.serial_arm import SerialArm
from .._robot.states import States, random_states
from .request import PluginRequest

__all__ = ["ModelFixtures"]

_SAMPLES = 100


class ModelFixtures:
    """`arm`, `robot`, `reference` and `states`, there only while models are checked."""

    def __init__(self, request: PluginRequest) -> None:
        self.request = request

    def pytest_generate_tests(self, metafunc: pytest.Metafunc) -> None:
        """One test for each model."""
        if "ur5check_model" in metafunc.fixturenames:
            names = [path.name for path in self.request.files]
            metafunc.parametrize("ur5check_model", self.request.files, ids=names, scope="session")

    @pytest.fixture(scope="session")
    def robot(self, ur5check_model: Path) -> Robot:
        """The whole robot of the model's file."""
        robot = self.request.verdict(ur5check_model).judgement.robot
        if robot is None:
            pytest.skip(f"{ur5check_model} describes no robot")
        return robot

    @pytest.fixture(scope="session")
    def arm(self, ur5check_model: Path) -> SerialArm:
        """The model's arm, on which `ur5check.rnea` and the other equations work."""
        judgement = self.request.verdict(ur5check_model).judgement
        if judgement.arm is None:
            pytest.skip(f"{ur5check_model} has no arm: {judgement.arm_note}")
        return judgement.arm

    @pytest.fixture(scope="session")
    def reference(self, arm: SerialArm) -> ReferenceEngine:
        """Pinocchio with the same arm, read by its own parser."""
        from .._engines.adapters.pinocchio import PinocchioEngine

        return PinocchioEngine(arm)

    @pytest.fixture(scope="session")
    def states(self, arm: SerialArm) -> States:
        """100 random states of the arm, the same in every run."""
        return random_states(arm.n, _SAMPLES, 0)
