"""A program as machine code computes what the program says, and in the order that it says."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check as ur5
from ur5check._dynamics.compiled import machine_code as module
from ur5check._dynamics.compiled.llvm_source import llvm_source
from ur5check._dynamics.compiled.machine_code import BLOCK, KernelCode, machine_code, processor
from ur5check._dynamics.compiled.sincos import FAR
from ur5check._dynamics.symbolic.program import Assignment, Program, Term, state_names
from ur5check._dynamics.symbolic.trace import trace
from ur5check._robot.states import random_states

EPS = np.finfo(float).eps
STATES = random_states(2, BLOCK + 3, seed=1)


def program(*outputs: tuple[Term, ...], assignments: tuple[Assignment, ...] = ()) -> Program:
    """Of an arm of two joints, with these entries in its result."""
    inputs = [name for kind in ("c", "s", "qd", "qdd") for name in state_names(kind, 2)]
    lines = tuple(Assignment(f"tau_{i}", terms) for i, terms in enumerate(outputs))
    return Program("arm", 2, "tau", "N m", (len(outputs),), tuple(inputs), assignments, lines)


def ran(program: Program, q=STATES.q, qd=STATES.qd, qdd=STATES.qdd) -> np.ndarray:
    out = np.full((len(q), len(program.outputs)), np.nan)
    KernelCode(machine_code(llvm_source(program)))(q, qd, qdd, out)
    return out


def test_sums_products_signs_and_numbers() -> None:
    made = program(
        (Term(-1.0, ("qd1",)), Term(2.5, ("qd2", "c1")), Term(-0.1, ("x1", "x1"))),
        (Term(0.3),),
        (),
        (Term(-1.0, ("x1",)),),
        assignments=(Assignment("x1", (Term(4.0), Term(1.0, ("qdd1", "s2")))),),
    )
    wanted = made.evaluate(STATES.q, STATES.qd, STATES.qdd)
    assert np.abs(ran(made) - wanted).max() <= 8 * EPS * np.abs(wanted).max()
    assert (ran(made)[:, 1] == 0.3).all()
    assert not ran(made)[:, 2].any()


def test_terms_are_not_moved() -> None:
    """(q̇ + 1e20) − 1e20 is 0; a compiler that may regroup makes q̇ of it."""
    line = Assignment("x1", (Term(1.0, ("qd1",)), Term(1e20)))
    found = ran(program((Term(1.0, ("x1",)), Term(-1e20)), assignments=(line,)))
    assert not found.any()


@pytest.mark.parametrize("bound", [np.pi, FAR, 1e12])
def test_cosines_and_sines(bound: float) -> None:
    q = np.random.default_rng(2).uniform(-bound, bound, (1000, 2))
    found = ran(program((Term(1.0, ("c1",)),), (Term(1.0, ("s2",)),)), q)
    assert np.abs(found[:, 0] - np.cos(q[:, 0])).max() <= 2 * EPS
    assert np.abs(found[:, 1] - np.sin(q[:, 1])).max() <= 2 * EPS


def test_an_angle_has_its_digits_whoever_stands_beside_it() -> None:
    """In one block, in the part of a block after it, and in other joints: angles too large."""
    q = np.random.default_rng(3).uniform(-np.pi, np.pi, (2 * BLOCK, 2))
    made = program(*((Term(1.0, (name,)),) for name in ("c1", "c2", "s1", "s2")))
    alone = ran(made, q)
    crowded = q.copy()
    crowded[::3, 0] = 1e9
    crowded[:BLOCK:2, 1] = -3e7
    near = crowded == q
    found = ran(made, crowded[: BLOCK + 5])
    same = found == alone[: BLOCK + 5]
    assert same[np.tile(near[: BLOCK + 5], 2)].all()
    assert np.abs(found - np.tile(np.cos(crowded[: BLOCK + 5]), 2))[:, :2].max() <= 2 * EPS


def test_an_array_that_is_not_read_may_be_missing() -> None:
    only_q = Program(
        "arm", 2, "g", "N m", (1,), ("c1",), (), (Assignment("g_0", (Term(1.0, ("c1",)),)),)
    )
    assert np.abs(ran(only_q, qd=None, qdd=None)[:, 0] - np.cos(STATES.q[:, 0])).max() <= 2 * EPS


def test_what_is_no_module_is_refused() -> None:
    with pytest.raises(RuntimeError, match="expected"):
        machine_code("define nothing")


def test_a_plain_processor_says_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    """Shorter registers, and maybe no fused multiply-add: other roundings, no other result."""
    arm = ur5.load("appendix")
    made = trace(arm, "tau", tries=0)
    states = random_states(6, 2 * BLOCK + 1, seed=3)
    here = ran(made, states.q, states.qd, states.qdd)
    monkeypatch.setattr(module.llvm, "get_host_cpu_name", lambda: "generic")
    monkeypatch.setattr(module.llvm, "get_host_cpu_features", lambda: module.llvm.FeatureMap({}))
    plain = ran(made, states.q, states.qd, states.qdd)
    wanted = ur5.rnea(arm, states.q, states.qd, states.qdd)
    for found in (here, plain):
        assert np.abs(found - wanted).max() < 1e-12 * np.abs(wanted).max()


def test_code_is_for_one_processor(monkeypatch: pytest.MonkeyPatch) -> None:
    here = processor()
    monkeypatch.setattr(module.llvm, "get_host_cpu_name", lambda: "x86-64")
    assert processor() != here
