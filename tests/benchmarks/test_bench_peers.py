"""The comparison with other validators counts what they say, and sees a tool that says nothing."""

from __future__ import annotations

import os
import sys

import pytest

from repository import REPOSITORY
from ur5check._rules.examples import joint, link, robot

sys.path.insert(0, str(REPOSITORY / "benchmarks"))

import bench_peers
from bench_peers import Case, Report

#: Python of an environment with the peers: they need other versions than these tests.
PYTHON = os.environ.get("UR5CHECK_PEERS_PYTHON")

TIP = (joint("k", parent="arm", child="tip", origin='<origin xyz="0 0 0.4"/>'), link("tip"))


@pytest.fixture
def cases(tmp_path):
    source = tmp_path / "source.urdf"
    source.write_text(robot(joint(), link(), *TIP))
    return bench_peers.write_cases({"small": source}, 0, tmp_path)


def test_every_fault_is_a_file_beside_the_sound_one(cases, tmp_path):
    sound, *faults = cases
    assert (sound.file, sound.kind) == ("small.urdf", None)
    assert len({case.kind for case in faults}) == len(faults) >= 25
    texts = {case.file: (tmp_path / case.file).read_text() for case in cases}
    assert all(texts[case.file] != texts["small.urdf"] for case in faults)


def test_ours_and_a_tool_that_says_nothing(cases, tmp_path):
    said = bench_peers.ours(cases, tmp_path)
    silent = {case.file: Report(0, 0.0, frozenset()) for case in cases}
    rows = bench_peers.rows(cases, {"ur5check": said, "silent": silent})
    total, errors, *_ = bench_peers.summary(cases, {"ur5check": said, "silent": silent})
    assert int(total[2]) >= 0.9 * int(total[1])
    assert (total[3], errors[2], errors[3]) == ("0", "0", "0")
    assert all(row[1] == "1" and row[3] == "0" for row in rows)


def test_what_a_tool_says_of_the_sound_file_too_is_no_detection():
    same, more = ("warning", "a", "b"), ("warning", "a", "c")
    sound = Report(0, 0.0, frozenset({same}))
    assert not bench_peers.detected(Report(0, 0.0, frozenset({same})), sound)
    assert bench_peers.detected(Report(0, 0.0, frozenset({same, more})), sound)
    assert bench_peers.detected(Report(1, 0.0, frozenset({same})), sound)
    assert not bench_peers.detected(Report(1, 0.0, frozenset()), Report(1, 0.0, frozenset()))


def test_missing_meshes_are_no_false_error():
    said = {("error", "files.meshes", "not found"), ("error", "mass", "x"), ("warning", "y", "z")}
    assert bench_peers.false_errors(Report(1, 0.0, frozenset(said))) == 1


@pytest.mark.skipif(PYTHON is None, reason="UR5CHECK_PEERS_PYTHON names no environment with them")
@pytest.mark.parametrize("tool", bench_peers.PEERS)
def test_a_peer_finds_a_negative_mass(tmp_path, tool):
    (tmp_path / "good.urdf").write_text(robot(joint(), link(), *TIP))
    (tmp_path / "bad.urdf").write_text(robot(joint(), link(mass="-2"), *TIP))
    cases = [Case(f"{name}.urdf", "r", "good.urdf", "mass") for name in ("good", "bad")]
    reports = bench_peers.theirs(tool, PYTHON, cases, tmp_path)
    assert bench_peers.detected(reports["bad.urdf"], reports["good.urdf"])
