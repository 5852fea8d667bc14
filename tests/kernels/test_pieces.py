"""A program in pieces is the program: each piece is handed all that it reads."""

from __future__ import annotations

import importlib.util

import numpy as np
import pytest

from examples import random_arm
from ur5check.arm.states import random_states
from ur5check.closed_form.program import read_input
from ur5check.closed_form.trace import trace
from ur5check.kernels.numba_source import numba_source
from ur5check.kernels.pieces import pieces

STATES = random_states(3, 5, seed=1)


@pytest.fixture(scope="module")
def program():
    return trace(random_arm(3, seed=2), "M", tries=0)


def inputs(program):
    q = STATES.q[0]
    read = {"c": np.cos(q), "s": np.sin(q), "q": q}
    return {name: read[read_input(name)[0]][read_input(name)[1]] for name in program.inputs}


def value(line, values):
    return sum(term.k * np.prod([values[f] for f in term.factors]) for term in line.terms)


@pytest.mark.parametrize("length", [1, 7, 30, 10_000])
def test_run_one_after_the_other_they_are_the_whole(program, length):
    carried, results = {}, {}
    parts = pieces(program, length)
    assert all(len(part.lines) <= length for part in parts)
    for part in parts:
        state = inputs(program)
        known = {name: state[name] for name in part.inputs}
        known |= {name: carried[name] for name in part.taken}
        for line in part.lines:
            known[line.name] = value(line, known)
        carried |= {name: known[name] for name in part.given}
        results |= {line.name: known[line.name] for line in program.outputs if line.name in known}
    found = [results[line.name] for line in program.outputs]
    assert np.abs(found - program.evaluate(STATES.q[0]).ravel()).max() < 1e-13


def test_a_piece_that_is_not_handed_something_cannot_run(program):
    second = pieces(program, 7)[1]
    assert second.taken
    known = dict.fromkeys((*second.inputs, *second.taken[1:]), 1.0)
    with pytest.raises(KeyError):
        for line in second.lines:
            known[line.name] = value(line, known)


def test_compiled_in_pieces_it_is_the_same(program, tmp_path):
    file = tmp_path / "cut.py"
    file.write_text(numba_source(program, 40).replace("cache=True, ", ""), "utf-8")
    spec = importlib.util.spec_from_file_location("cut", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert module.CARRIED > 0
    out = np.empty((5, 9))
    module.run(STATES.q, out)
    assert np.abs(out - program.evaluate(STATES.q).reshape(5, 9)).max() < 1e-13
