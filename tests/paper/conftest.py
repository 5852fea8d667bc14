"""The paper, reproduced once."""

from __future__ import annotations

import pytest

from ur5check.paper.evidence import Evidence, gather
from ur5check.paper.reproduction import Reproduction, judge


@pytest.fixture(scope="session")
def evidence() -> Evidence:
    return gather(lambda line: None)


@pytest.fixture(scope="session")
def reproduction(evidence: Evidence) -> Reproduction:
    return judge(evidence)
