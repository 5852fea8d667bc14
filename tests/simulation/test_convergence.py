"""At step zero all engines move the same arm, and each gets there at its integrator's order."""

from __future__ import annotations

import numpy as np
import pytest
from moving_arms import APPENDIX, CASE_9

import ur5check
from ur5check._simulation.convergence import Convergence, convergence, extrapolated

#: Nine tenths of what the arm needs: it sinks by 70° within a second and does not whirl.
TORQUE = 0.9 * ur5check.gravity_torque(APPENDIX, CASE_9)


@pytest.fixture(scope="module")
def study() -> Convergence:
    return convergence(APPENDIX, CASE_9, TORQUE, halvings=range(7, 12), own_halvings=range(2, 6))


def test_every_integrator_of_every_engine_takes_part(study):
    names = {(r.engine, r.integrator) for r in study.refinements}
    assert names >= {
        ("ur5check", "DOP853"), ("MuJoCo", "euler"), ("MuJoCo", "rk4"), ("MuJoCo", "implicit"),
        ("MuJoCo", "implicitfast"), ("DART", "semi-implicit"),
    }  # fmt: skip
    assert study.turned > 1.0


def test_the_error_falls_at_the_order_of_the_integrator(study):
    for r in study.refinements:
        assert r.overall_order == pytest.approx(r.order, rel=0.15), r.integrator


def test_at_step_zero_all_agree(study):
    assert study.apart < 1e-6
    assert study.reference_error < 1e-7
    # And at the last finite step the first-order ones do not.
    assert max(r.error[-1] for r in study.refinements) > 1e-4


def test_another_arm_has_another_limit():
    """The law can fail: a centre of mass a centimetre off shows a thousandfold."""
    ends = []
    for shift in (0.0, 1e-2):
        inertias = [link.inertia for link in APPENDIX.links]
        x = inertias[2]
        inertias[2] = type(x)(x.mass, x.com + [shift, 0.0, 0.0], x.tensor)
        arm = APPENDIX.with_inertias(inertias)
        study = convergence(
            arm,
            CASE_9,
            TORQUE,
            seconds=0.3,
            engines=(),
            halvings=range(7, 8),
            own_halvings=range(3, 5),
        )
        ends.append(study.refinements[0].limit)
    assert np.abs(ends[0] - ends[1]).max() > 1e-3


def test_extrapolation_removes_the_terms_it_knows():
    h = 2.0 ** -np.arange(1.0, 6.0)[:, None]
    exact = np.array([1.0, -2.0])
    q = exact + h * [0.3, 0.1] + h**2 * [2.0, -1.0] + h**3 * [1.0, 1.0]
    np.testing.assert_allclose(extrapolated(q, 1), exact, atol=1e-14)
    # With the wrong order it does not arrive.
    assert np.abs(extrapolated(q, 2) - exact).max() > 1e-4
