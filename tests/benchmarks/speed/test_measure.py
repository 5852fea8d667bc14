"""All contestants take part in a benchmark and compute the same torques."""

from __future__ import annotations

import numpy as np
import pytest
from speed.measure import QUESTIONS, measure
from speed.memory import copy_of
from speed.pinocchio_calls import PinocchioCalls
from speed.random_chain import chain
from speed.result import Benchmark
from speed.summary import summarize

import ur5check
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._errors import UsageError
from ur5check._robot.states import random_states

#: What the fixture has measured.
MEASURED = ("torques", "memory", "matrices", "states", "joints", "operations")
CONTESTANTS = [
    "pin.rneaInParallel, 1 thread",
    "Python loop over pin.rnea",
    "ur5check.rnea",
    "kernel on NumPy, 1 thread",
    "kernel by LLVM, 1 thread",
    "kernel by LLVM, arrays (n, N), 1 thread",
    "JAX on cpu, its own threads",
    "Python loop over MuJoCo",
    "Python loop over Drake",
    "pin.rneaInParallel, 2 threads",
    "kernel by LLVM, 2 threads",
]
#: Torques of about 1e2 N m, each with about 300 roundings [N m].
SAME = 1e-11


def test_all_contestants_compute_torques(found: Benchmark) -> None:
    torques = found.comparison("torques")
    assert torques is not None
    names = [timing.name.replace("on gpu", "on cpu") for timing in torques.timings]
    assert names == CONTESTANTS


def test_all_contestants_find_the_same_torques(found: Benchmark) -> None:
    compared = [
        (chapter.key, timing.name, timing.deviation)
        for chapter in found.chapters
        if chapter.key in ("torques", "states", "joints")
        for comparison in chapter.comparisons
        for timing in comparison.timings
        if timing.deviation is not None
    ]
    assert len(compared) > 10
    assert [entry for entry in compared if entry[2] > SAME] == []


def test_pinocchio_holds_the_arm_at_the_same_states() -> None:
    arm = ur5check.load("paper")
    states = random_states(arm.n, 5, 1)
    calls = PinocchioCalls(arm, states, 2)
    tau = PinocchioEngine(arm).inverse_dynamics(states.q, states.qd, states.qdd)
    assert np.abs(calls.in_parallel(2) - tau).max() < SAME
    other = PinocchioCalls(ur5check.load("appendix"), states, 1)
    assert np.abs(other.in_parallel(1) - tau).max() > 1.0


def test_a_copy_moves_the_bytes_of_a_torque() -> None:
    q = random_states(6, 4, 0).q
    run, read, written = copy_of(q, 2)
    run()
    assert np.array_equal(read, written)
    assert read.nbytes + written.nbytes == 4 * (144 + 48)


@pytest.mark.parametrize("question", MEASURED[:-1])
def test_every_question_has_its_chapter(found: Benchmark, question: str) -> None:
    (chapter,) = [chapter for chapter in found.chapters if chapter.key == question]
    assert chapter.comparisons
    assert all(t.seconds > 0.0 for c in chapter.comparisons for t in c.timings)


def test_a_series_names_its_sizes(found: Benchmark) -> None:
    subjects = {c.key: [s.subject for s in c.comparisons] for c in found.chapters if c.series}
    assert subjects["states"] == ["1 state", "10 states"]
    assert subjects["joints"] == ["2 joints"]


def test_every_matrix_has_its_loop(found: Benchmark) -> None:
    for subject, algorithm in {
        "mass matrix": "crba",
        "Coriolis matrix": "computeCoriolisMatrix",
        "gravity torque": "computeGeneralizedGravity",
        "torque regressor": "computeJointTorqueRegressor",
    }.items():
        comparison = found.comparison("matrices", subject)
        assert comparison is not None
        assert comparison.timings[0].name == f"Python loop over pin.{algorithm}"
        assert len(comparison.timings) == 4


def test_a_random_chain_depends_on_its_seed_alone() -> None:
    assert np.array_equal(chain(3, 0).parameters(), chain(3, 0).parameters())
    assert not np.array_equal(chain(3, 0).parameters(), chain(3, 1).parameters())
    for link in chain(8, 0).links:
        moments = np.linalg.eigvalsh(link.inertia.tensor)
        assert 0.0 < moments[2] <= moments[0] + moments[1]


def test_operations_are_counted(found: Benchmark) -> None:
    counts = {count.what: count for count in found.operations}
    assert counts["torques"].generated == counts["torques, 2 joints"].generated
    assert all(c.generated.total < c.as_written.total for c in counts.values())


def test_the_summary_has_the_ratio(found: Benchmark) -> None:
    sentences = summarize(found)
    torques = found.comparison("torques")
    assert torques is not None
    pin, llvm = (
        torques.seconds(name)
        for name in ("pin.rneaInParallel, 1 thread", "kernel by LLVM, 1 thread")
    )
    assert pin is not None
    assert llvm is not None
    assert (
        f"The kernel by LLVM: {pin / llvm:.3g} times as fast as pin.rneaInParallel" in sentences[0]
    )
    assert any(" operations" in sentence for sentence in sentences)


def test_only_the_selected_is_measured(found: Benchmark) -> None:
    assert {chapter.key for chapter in found.chapters} | {"operations"} == set(MEASURED)
    assert found.profiles == ()
    assert set(MEASURED) < set(QUESTIONS)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"only": ["speed"]}, "'speed' is not measured; choose from torques"),
        ({"states": 0}, "states must be at least 1, not 0"),
        ({"rounds": 0}, "rounds must be at least 1"),
        ({"threads": -1}, "threads must be at least 1"),
        ({"lengths": [0]}, "lengths and up_to must be at least 1"),
    ],
)
def test_bad_arguments_are_refused(wrong: dict[str, object], message: str) -> None:
    with pytest.raises(UsageError, match=message):
        measure(ur5check.load("paper"), **wrong)  # type: ignore[arg-type]
