"""Generated Python needs NumPy alone, and computes what the program does."""

from __future__ import annotations

import ast

import numpy as np
import pytest
from references import RECURSION, arguments, states

import ur5check
from ur5check._dynamics.symbolic.to_python import to_python
from ur5check._dynamics.symbolic.trace import trace


def function(source, name):
    module = {}
    exec(compile(source, name, "exec"), module)  # noqa: S102 - what we generated
    return module[name]


@pytest.mark.parametrize("quantity", ["tau", "M", "C", "g"])
@pytest.mark.parametrize("parameters", ["numeric", "symbolic"])
def test_it_computes_the_quantity(quantity, parameters):
    arm = ur5check.load("appendix")
    program = trace(arm, quantity, parameters=parameters, tries=0)
    at = states(arm, 20)
    given = [x.reshape(4, 5, 6) for x in arguments(program, at)]
    result = function(to_python(program), quantity)(*given)
    np.testing.assert_allclose(result, RECURSION[quantity](arm, *given), atol=1e-11)
    # A single state is as welcome as an array of them.
    one = [x[0, 0] for x in given]
    np.testing.assert_array_equal(function(to_python(program), quantity)(*one), result[0, 0])


def test_it_imports_numpy_and_nothing_else():
    source = to_python(trace(ur5check.load("paper"), "g", tries=0), head=["a line", ""])
    imported = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Import)]
    assert [alias.name for node in imported for alias in node.names] == ["numpy"]
    assert not any(isinstance(node, ast.ImportFrom) for node in ast.walk(ast.parse(source)))
    assert source.startswith("# a line\n#\n")


def test_symbols_are_keyword_arguments():
    arm = ur5check.load("paper")
    program = trace(arm, "g", parameters="symbolic")
    gravity = function(to_python(program), "g")
    q = states(arm, 3).q
    moon = arm.with_gravity((0, 0, -1.62))
    np.testing.assert_allclose(gravity(q, gz=-1.62), ur5check.gravity_torque(moon, q), atol=1e-12)
