"""Constant, saturated, late, turned and rescaled channels are found; good ones are not accused."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from logs.recorded import Motion
from logs.test_row_checks import recording_of
from ur5check._finding import Finding
from ur5check._logs.channel_checks import check_channels, velocity_is_late
from ur5check._robot.transforms import Array
from ur5check._rules.finding_log import FindingLog


def checked(table: Array) -> tuple[bool, list[Finding]]:
    log, recording = FindingLog(), recording_of(table)
    check_channels(recording, log)
    return velocity_is_late(recording, log), log.findings


def test_a_good_recording_has_no_findings(motion: Motion) -> None:
    assert checked(motion.table()) == (False, [])


def constant_torque(table: Array) -> None:
    table[:, 9] = -1.5


def saturated(table: Array) -> None:
    limit = np.quantile(np.abs(table[:, 8]), 0.95)
    table[:, 8] = table[:, 8].clip(-limit, limit)


def late(table: Array) -> None:
    table[18:, 4:7] = table[:-18, 4:7].copy()


def other_sign(table: Array) -> None:
    table[:, 5] *= -1.0


def other_unit(table: Array) -> None:
    table[:, 4:7] = np.degrees(table[:, 4:7])


@pytest.mark.parametrize(
    ("spoil", "rule", "value", "unused"),
    [
        (constant_torque, "LOG121", -1.5, False),
        (saturated, "LOG122", None, False),
        (late, "LOG123", 0.180, True),
        (other_sign, "LOG124", -1.0, True),
        (other_unit, "LOG124", 57.3, True),
    ],
)
def test_a_bad_channel_is_found(
    motion: Motion,
    spoil: Callable[[Array], None],
    rule: str,
    value: float | None,
    unused: bool,
) -> None:
    table = motion.table().copy()
    spoil(table)
    is_late, findings = checked(table)
    assert [finding.rule for finding in findings] == [rule]
    if value is not None:
        assert findings[0].value == pytest.approx(value, rel=0.02)
    assert is_late == unused


@pytest.mark.parametrize("samples", [0, 1])
def test_a_velocity_within_one_sample_is_used(motion: Motion, samples: int) -> None:
    table = motion.table().copy()
    table[samples:, 4:7] = table[: len(table) - samples, 4:7].copy()
    assert checked(table) == (False, [])
