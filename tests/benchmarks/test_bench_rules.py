"""The benchmark of the rules plants what it says, and sees a rule that is blind."""

from __future__ import annotations

import sys
from xml.etree import ElementTree as ET

import pytest

from repository import REPOSITORY
from ur5check._io.ros_packages import example_robot_data

sys.path.insert(0, str(REPOSITORY / "benchmarks"))

import bench_rules
from planted_faults import KINDS, planted


def robot(file: str):
    return example_robot_data() / "robots" / file


def test_halves_share_no_robot_and_all_are_there():
    assert not set(bench_rules.TUNING) & set(bench_rules.REPORTING)
    assert len(bench_rules.TUNING) >= 12
    assert len(bench_rules.REPORTING) >= 12
    assert all(robot(file).is_file() for file in (*bench_rules.TUNING, *bench_rules.REPORTING))


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_a_planted_fault_changes_the_file(kind):
    text = robot("ur_description/urdf/ur3_robot.urdf").read_bytes()
    root = ET.fromstring(text)  # noqa: S314 - installed with this program
    made = planted(root, kind, seed=3)
    assert made is None or made[0] != ET.tostring(root, encoding="unicode")


def test_most_faults_are_found_on_a_robot_of_each_half():
    for half in (bench_rules.TUNING, bench_rules.REPORTING):
        path = robot(half[0])
        counts, _, links, errors = bench_rules.run({path.stem: path}, seed=5)
        made, detected, first = (sum(column) for column in zip(*counts.values(), strict=True))
        assert made >= 25
        assert detected >= 0.97 * made
        assert first >= 0.92 * made
        assert errors <= links / 200


def test_a_blind_rule_shows(monkeypatch):
    path = robot(bench_rules.TUNING[0])
    monkeypatch.setattr(bench_rules, "check_rules", lambda subject, found: list(found))
    counts, missed, *_ = bench_rules.run({path.stem: path}, seed=5)
    assert counts["tensor in g mm²"][1] == 0
    assert any("tensor in g mm²" in line for line in missed)
