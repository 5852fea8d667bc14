"""What a scalar that writes itself down shares, folds and forgets; and what factoring may do."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from references import states

import ur5check
from ur5check._dynamics.batching import JointState
from ur5check._dynamics.chain_constants import chain_of
from ur5check._dynamics.recursion import joint_torques
from ur5check._dynamics.symbolic.derivative import derivatives
from ur5check._dynamics.symbolic.expression_graph import Graph
from ur5check._dynamics.symbolic.factoring import factored
from ur5check._dynamics.symbolic.quantities import symbolic_state
from ur5check._dynamics.symbolic.sums_of_products import cost, lines_of, output_name
from ur5check._dynamics.vectors import Vector


@pytest.fixture
def graph():
    return Graph()


def inputs(graph, names="abc"):
    return [graph.input(name) for name in names]


def test_equal_values_are_one_node_whatever_their_sign_and_factor(graph):
    a, b, _ = inputs(graph)
    assert (a * b).node == (b * a).node == (2.0 * b * (-a)).node
    assert (a + b).node == (-a - b).node == (b + a).node
    assert (a + b).node != (a - b).node


def test_constants_fold_and_zeros_are_constants(graph):
    a, b, _ = inputs(graph)
    assert (0.5 * (a * 2.0)).node == a.node
    assert (0.5 * (a * 2.0)).factor == 1.0
    assert a - a == 0.0
    assert isinstance(a * 0.0, float)
    assert (a + 0.0) is a
    assert (1.0 - a + a).node == (graph.constant(1.0)).node
    assert (a * b - b * a) == 0.0


def test_what_was_added_and_taken_away_leaves_no_trace(graph):
    a, b, _ = inputs(graph)
    assert (a - (a + b)).node == b.node
    assert ((a + 3.0 * b) - a).factor == 3.0
    assert ((a + b) - 2.0 * a).node != b.node


def test_a_vector_turned_and_turned_back_is_itself(graph):
    cos, sin = graph.angle("c1", "s1")
    v = Vector(*inputs(graph))
    back = v.turned_about_z(cos, sin).turned_back_about_z(cos, sin)
    assert [x.node for x in back] == [x.node for x in v]
    # Not so by another angle, nor by the same one twice.
    other = graph.angle("c2", "s2")
    for again in (
        v.turned_about_z(cos, sin).turned_back_about_z(*other),
        v.turned_about_z(cos, sin).turned_about_z(cos, sin),
    ):
        assert again.x.node != v.x.node


def test_the_recursion_on_sympy_symbols_is_the_same_form():
    """SymPy's own expressions and our graph's, traced from one text, have the same values."""
    arm = ur5check.load("paper")
    chain, n = chain_of(arm), arm.n
    rows = [sympy.symbols(f"{name}1:{n + 1}") for name in ("q", "c", "s", "qd", "qdd")]
    g_0 = chain.inner_gravity(arm.gravity)
    by_sympy = joint_torques(chain, JointState(*rows), g_0)
    graph = Graph()
    entries = joint_torques(chain, symbolic_state(graph, n), g_0)
    at = states(arm, 3)
    values = np.hstack([at.q, np.cos(at.q), np.sin(at.q), at.qd, at.qdd])
    f = sympy.lambdify([x for row in rows for x in row], by_sympy, modules="math", cse=True)
    ours = [run(graph, entries, rows, state) for state in values]
    np.testing.assert_allclose(ours, [f(*state) for state in values], rtol=1e-12, atol=1e-12)


def run(graph, entries, rows, state):
    known = dict(zip((str(x) for row in rows for x in row), state, strict=True))
    lines = lines_of(graph, entries)
    return evaluate(graph, lines, known, len(entries))


def evaluate(graph, lines, known, outputs):
    """The lines' values, asked for from the outputs down."""

    @cache
    def value(node):
        if node in lines:
            return sum(k * np.prod([value(x) for x in m]) for m, k in lines[node].items())
        return known[graph.nodes[node].name]

    return [value(output_name(i)) for i in range(outputs)]


terms = st.tuples(
    st.sampled_from([1.0, -1.0, 0.5, -2.0, 3.0]),
    st.lists(st.sampled_from("abcd"), min_size=1, max_size=4),
)
polynomials = st.lists(st.lists(terms, min_size=1, max_size=6), min_size=1, max_size=4)


@settings(max_examples=25)
@given(polynomials=polynomials)
def test_factoring_keeps_every_value_and_never_costs(polynomials):
    graph = Graph()
    values = dict(zip("abcd", inputs(graph, "abcd"), strict=True))
    outputs = []
    for polynomial in polynomials:
        total = 0.0
        for k, factors in polynomial:
            product = 1.0
            for name in factors:
                product = values[name] * product
            total = total + k * product
        outputs.append(total)
    lines = lines_of(graph, outputs)
    fewer = factored(lines, len(graph.nodes))
    assert sum(map(cost, fewer.values())) <= sum(map(cost, lines.values()))
    numbers = dict(zip("abcd", (1.3, -0.7, 2.1, 0.4), strict=True))
    plain = [
        sum(k * np.prod([numbers[name] for name in factors]) for k, factors in polynomial)
        for polynomial in polynomials
    ]
    np.testing.assert_allclose(
        evaluate(graph, fewer, numbers, len(outputs)), plain, rtol=1e-12, atol=1e-12
    )


def test_a_scaled_factor_is_no_pair_of_factors(graph):
    """3 · (node 3) and (node 3)² once were the same pattern."""
    *_, c = inputs(graph)
    lines = lines_of(graph, [c * c, c * c, float(c.node) * c])
    fewer = factored(lines, len(graph.nodes))
    assert evaluate(graph, fewer, {"c": 5.0}, 3) == [25.0, 25.0, 5.0 * c.node]


def test_what_factoring_is_for(graph):
    """a c + b c in two lines, one of them doubled: 2 × and 1 +, against 6 and 2."""
    a, b, c = inputs(graph)
    lines = lines_of(graph, [a * c + b * c, 2.0 * (a * c) + 2.0 * (c * b)])
    fewer = factored(lines, len(graph.nodes))
    assert sum(map(cost, fewer.values())) == 3


def test_derivatives_are_leibnizs(graph):
    a, b, c = inputs(graph)
    d_square, d_other, d_none, d_number = derivatives([a * a * b, b * c - 3.0 * a, c, 1.0], a)
    assert d_square.node == (a * b).node
    assert d_square.factor == 2.0
    assert d_other == -3.0
    assert d_none == d_number == 0.0
