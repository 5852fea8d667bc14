"""The closed form as mathematics: SymPy expressions, and LaTeX that can be typeset."""

from __future__ import annotations

import re

import numpy as np
import pytest
import sympy
from matplotlib.mathtext import MathTextParser
from references import RECURSION, arguments, states

import ur5check
from examples import planar_arm
from ur5check._dynamics.symbolic.to_latex import to_latex
from ur5check._dynamics.symbolic.to_sympy import expressions, to_sympy
from ur5check._dynamics.symbolic.trace import trace


def test_a_pendulum_comes_out_as_in_the_textbook():
    arm = planar_arm((0.5,), (3.0,))
    q1, qdd1, m1, a1, gz = sympy.symbols("q1 qdd1 m1 a1 gz")
    (tau,) = expressions(trace(arm, "tau", parameters="symbolic"))
    # Turning about y, a positive angle dips the rod below the horizon: gravity helps.
    assert sympy.expand(tau - (m1 * a1**2 * qdd1 + m1 * gz * a1 * sympy.cos(q1))) == 0
    (inertia,) = expressions(trace(arm, "M", parameters="symbolic"))
    assert inertia == m1 * a1**2


@pytest.mark.parametrize("quantity", ["M", "g"])
def test_written_out_it_is_the_recursion(quantity):
    arm = ur5check.load("appendix")
    program = trace(arm, quantity, tries=0)
    written = expressions(program)
    assert written.free_symbols <= set(sympy.symbols("q1:7"))
    q = states(arm, 1).q
    for at, expected in zip(q, RECURSION[quantity](arm, q), strict=True):
        numbers = written.evalf(20, subs=dict(zip(sympy.symbols("q1:7"), at, strict=True)))
        np.testing.assert_allclose(
            np.array(numbers, dtype=float).reshape(program.shape), expected, atol=1e-11
        )


def test_replacements_go_with_lambdify_as_those_of_cse():
    arm = ur5check.load("paper")
    program = trace(arm, "tau", tries=0)
    module = {}
    exec(to_sympy(program), module)  # noqa: S102 - what we generated
    joints = [sympy.symbols(f"{name}1:7") for name in ("q", "qd", "qdd")]
    known = (module["replacements"], [module["tau"]])
    tau = sympy.lambdify(joints, module["tau"], modules="numpy", cse=lambda _: known)
    at = states(arm, 5)
    for q, qd, qdd in zip(*arguments(program, at), strict=True):
        (expected,) = ur5check.rnea(arm, [q], [qd], [qdd])
        np.testing.assert_allclose(np.ravel(tau(q, qd, qdd)), expected, atol=1e-11)


@pytest.mark.parametrize(("quantity", "parameters"), [("tau", "symbolic"), ("g", "numeric")])
def test_every_line_of_latex_can_be_typeset(quantity, parameters):
    program = trace(ur5check.load("paper"), quantity, parameters=parameters, tries=0)
    text = to_latex(program, head=["where from"])
    (body,) = re.findall(r"(?s)\\begin\{align\*\}\n(.*)\n\\end", text)
    rows = body.split(" \\\\\n")
    assert len(rows) == len(program.setup + program.assignments + program.outputs)
    typesetter = MathTextParser("path")
    for row in rows:
        typesetter.parse(f"${row.replace('&=', '=')}$")
    with pytest.raises(ValueError, match="Unknown symbol"):
        typesetter.parse(r"$\dott{q}_1$")
    assert {"tau": r"\ddot{q}_{2}", "g": "g_{6} &= 0"}[quantity] in text
    assert all(line.startswith(("%", "\\")) for line in text.replace(body, "").splitlines() if line)
