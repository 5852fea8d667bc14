"""What real engines really do to a small arm with empty frames: found, named, explained,
repaired.
"""

from __future__ import annotations

import pytest

from three_joints import ARM
from ur5check._engines.audit.engine_comparison import SAME_ROBOT, compare_engines
from ur5check._io.urdf.urdf_reader import read_urdf

#: Per engine: what it is found to do that bears on torque (kind, place, kilograms), and its known
#: issue.
KNOWN_ISSUES = {
    "pinocchio": ([], None),
    "mujoco": ([("shape-mass", "link 'plate'", 6.0)], "mujoco-mass-from-shape"),
    "drake": ([], None),
    "dart": (
        [("default-inertia", "link 'plate'", 1.0), ("default-inertia", "link 'tool'", 1.0)],
        "dart-default-inertia",
    ),
    "idyntree": ([], None),
}


@pytest.fixture(scope="module")
def report(arm):
    return compare_engines(arm, samples=20)


@pytest.mark.parametrize("key", KNOWN_ISSUES)
def test_a_known_issue_is_found_named_and_explained(key, report):
    faults, known_issue = KNOWN_ISSUES[key]
    reading = report.as_read.reading(key)
    found = reading.imported.harmful
    assert sorted((one.kind, one.where, round(one.mass, 9)) for one in found) == faults
    assert {one.known_issue.id for one in found} == ({known_issue} if known_issue else set())
    assert reading.explanation.explained
    torque = report.as_read.matrix.between("ur5check", key).torque
    assert (torque > SAME_ROBOT) == bool(faults)


def test_with_the_repairs_all_agree(report):
    assert report.repaired.agrees()
    assert all(reading.imported.harmful == () for reading in report.repaired.readings)


def test_drake_replaces_a_tensor_that_misses_by_its_last_digit():
    # 0.001 + 0.002 < 0.0030001: a thin plate, printed with one digit more than it has.
    text = ARM.replace('izz="0.0015"', 'izz="0.0030001"')
    thin = read_urdf(text.encode(), file="thin.urdf", base="base", tip="tool")
    report = compare_engines(thin, engines=["drake", "mujoco"], samples=20)
    (changed,) = report.as_read.reading("drake").imported.harmful
    assert (changed.kind, changed.where) == ("tensor-changed", "link 'hand'")
    assert changed.known_issue.id == "drake-impossible-tensor"
    assert changed.torque_effect > 0.01
    assert report.explained
    # MuJoCo says what is wrong and takes nothing; no rewriting of ours invents a tensor.
    assert "A + B >= C" in report.as_read.reading("mujoco").refused
    assert not report.final.agrees()
