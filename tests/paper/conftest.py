"""The paper at rest, reproduced once: its numbers, its nine cases, its limits."""

from __future__ import annotations

import pytest

from ur5check._paper.claims import OF_CASES, OF_DERIVATION, OF_GEOMETRY, OF_LIMITS, OF_NUMBERS
from ur5check._paper.evidence import Evidence, gather
from ur5check._paper.reproduction import Reproduction, judge


@pytest.fixture(scope="session")
def evidence() -> Evidence:
    return gather(lambda line: None)


@pytest.fixture(scope="session")
def reproduction(evidence: Evidence) -> Reproduction:
    return judge(evidence, (*OF_GEOMETRY, *OF_DERIVATION, *OF_NUMBERS, *OF_CASES, *OF_LIMITS))
