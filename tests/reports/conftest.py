"""Results to show, computed once."""

from __future__ import annotations

from pathlib import Path

import pytest

import ur5check
from ur5check._comparison.difference import Difference
from ur5check._comparison.explanation import Explanation
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._robot.states import random_states
from ur5check._validation.validation import Validation, validate_arm

SAMPLES = 200


@pytest.fixture(scope="session")
def validation() -> Validation:
    return ur5check.validate("paper", "appendix", samples=SAMPLES)


@pytest.fixture(scope="session")
def failing() -> Validation:
    """A reference engine that holds another arm's bodies: some laws must fail, others cannot."""
    arm = ur5check.load("paper")
    heavier = arm.with_inertias([link.inertia for link in reversed(arm.links)])
    states = random_states(arm.n, SAMPLES, 0)
    model = validate_arm(arm, PinocchioEngine(heavier), states)
    return Validation((model,), (), SAMPLES, 0)


@pytest.fixture(scope="session", params=[("paper-listing", "paper"), ("erd-ur5", "appendix")])
def difference(request: pytest.FixtureRequest) -> Difference:
    return ur5check.diff(*request.param, samples=SAMPLES)


@pytest.fixture(scope="session")
def explanation(difference: Difference) -> Explanation:
    return ur5check.explain(difference)


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder, which is the current one."""
    monkeypatch.chdir(tmp_path)
    return tmp_path
