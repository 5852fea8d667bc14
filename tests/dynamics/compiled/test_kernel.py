"""Compiled dynamics against the recursion and Pinocchio: any arm, layout, number of threads."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import ur5check as ur5
from examples import random_arm
from ur5check._dynamics.compiled import kernel_source as source
from ur5check._dynamics.compiled.kernel import Kernel, compile_difference, default_path
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._errors import StateError, UsageError
from ur5check._robot.states import random_states

QUANTITIES = {
    "rnea": ("q", "qd", "qdd"),
    "mass_matrix": ("q",),
    "coriolis_matrix": ("q", "qd"),
    "gravity_torque": ("q",),
}
ROUNDING = 1e-12  # of the largest entry: some hundred operations, each rounded by 1e-16


@pytest.fixture(scope="module")
def slider():
    return random_arm(3, seed=7)  # one of its joints slides


@pytest.fixture(scope="module")
def appendix():
    return ur5.load("appendix")


def arguments(states, names):
    return [getattr(states, name) for name in names]


@pytest.mark.parametrize("path", ["llvm", "numpy"])
@pytest.mark.parametrize("quantity", QUANTITIES)
def test_a_kernel_is_the_recursion(quantity, path, slider):
    states = random_states(slider.n, 150, seed=2)  # two blocks of 64, and a part of one
    given = arguments(states, QUANTITIES[quantity])
    found = getattr(ur5.compile(slider, path=path), quantity)(*given)
    wanted = getattr(ur5, quantity)(slider, *given)
    assert found.shape == wanted.shape
    assert np.abs(found - wanted).max() <= ROUNDING * np.abs(wanted).max()


@pytest.mark.parametrize("path", ["llvm", "numpy"])
def test_the_regressor_too(path):
    arm = random_arm(2, seed=1)
    states = random_states(2, 70, seed=2)
    found = ur5.compile(arm, path=path).torque_regressor(states.q, states.qd, states.qdd)
    wanted = ur5.torque_regressor(arm, states.q, states.qd, states.qdd)
    assert np.abs(found - wanted).max() <= ROUNDING * np.abs(wanted).max()


@pytest.mark.parametrize("path", ["llvm", "numpy"])
def test_a_kernel_is_pinocchios(path, appendix):
    states = random_states(6, 1000, seed=3)
    found = ur5.compile(appendix, path=path).rnea(states.q, states.qd, states.qdd)
    wanted = PinocchioEngine(appendix).inverse_dynamics(states.q, states.qd, states.qdd)
    assert np.abs(found - wanted).max() <= 1e-11


@pytest.mark.parametrize("path", ["llvm", "numpy"])
def test_layouts_threads_and_out_change_no_digit(path, appendix):
    states = random_states(6, 200, seed=4)
    given = [states.q, states.qd, states.qdd]
    rows = [np.ascontiguousarray(array.T) for array in given]
    one, two = ur5.compile(appendix, path=path), ur5.compile(appendix, threads=2, path=path)
    wanted = one.rnea(*given)
    out = np.empty((6, 200))
    assert one.rnea(*rows, layout="joints", out=out) is out
    assert np.array_equal(out.T, wanted)
    assert np.array_equal(two.rnea(*given), wanted)
    assert np.array_equal(one.rnea(*(array[7] for array in given)), wanted[7])
    M = one.mass_matrix(rows[0], layout="joints")
    assert np.array_equal(np.moveaxis(M, -1, 0), one.mass_matrix(states.q))


def test_as_many_states_as_joints_are_never_guessed(appendix):
    states = random_states(6, 6, seed=5)
    kernel = ur5.compile(appendix)
    by_state = kernel.gravity_torque(states.q)
    by_joint = kernel.gravity_torque(states.q, layout="joints")
    assert np.array_equal(by_joint.T, kernel.gravity_torque(states.q.T))
    assert not np.allclose(by_state, by_joint)


def test_angles_beyond_the_fast_sine_are_right_too(appendix):
    states = random_states(6, 64, seed=6)
    far = states.q * 1e6
    found = ur5.compile(appendix, path="llvm").gravity_torque(far)
    assert np.abs(found - ur5.gravity_torque(appendix, far)).max() <= 1e-11


@pytest.mark.parametrize("path", ["llvm", "numpy"])
def test_a_difference_of_two_arms(path, appendix):
    heavier = appendix.with_inertias([link.inertia for link in ur5.load("erd-ur5").links])
    states = random_states(6, 100, seed=7)
    given = [states.q, states.qd, states.qdd]
    found = compile_difference(appendix, heavier, path=path)(*given)
    wanted = ur5.rnea(appendix, *given) - ur5.rnea(heavier, *given)
    assert np.abs(found - wanted).max() <= 1e-11
    assert np.abs(wanted).max() > 1.0


@pytest.mark.parametrize("path", ["llvm", "numpy"])
def test_an_arm_does_not_differ_from_itself(path):
    arm = random_arm(2, seed=1)
    states = random_states(2, 70, seed=2)
    found = compile_difference(arm, arm, path=path)(states.q, states.qd, states.qdd)
    assert found.shape == (70, 2)
    assert not found.any()


def test_another_gravity_is_another_kernel(appendix):
    q = random_states(6, 10, seed=8).q
    moon = appendix.with_gravity((0.0, 0.0, -1.62))
    found = ur5.compile(moon).gravity_torque(q)
    assert np.abs(found - ur5.gravity_torque(moon, q)).max() <= 1e-12
    assert np.abs(found - ur5.compile(appendix).gravity_torque(q)).max() > 1.0


@pytest.mark.parametrize("path", ["llvm", "numpy"])
def test_arrays_as_they_come(path, appendix):
    """Read-only, reversed, unaligned, of other byte order, single precision, lists, none at all."""
    q = np.float32(random_states(6, 70, seed=9).q).astype(float)
    kernel = ur5.compile(appendix, path=path)
    wanted = kernel.gravity_torque(q)
    packed = np.zeros(70, dtype=[("tag", "i1"), ("q", "f8", 6)])
    packed["q"] = q
    shown = q.view()
    shown.flags.writeable = False
    for same in (shown, packed["q"], q.astype(">f8"), np.float32(q), q.tolist(), q[::-1][::-1]):
        assert np.array_equal(kernel.gravity_torque(same), wanted)
    assert np.array_equal(kernel.gravity_torque(np.broadcast_to(q[7], (3, 6)))[2], wanted[7])
    assert kernel.gravity_torque(q[:0]).shape == (0, 6)


@pytest.mark.parametrize("path", ["llvm", "numpy"])
def test_what_is_beyond_all_computing_is_no_number(path, appendix):
    huge = np.full((1, 6), 1e200)
    found = ur5.compile(appendix, path=path).rnea(np.ones((1, 6)), huge, np.ones((1, 6)))
    assert not np.isfinite(found).all()


@pytest.mark.parametrize("bad", [np.nan, np.inf])
@pytest.mark.parametrize("name", ["q", "qd", "qdd"])
def test_what_is_no_number_is_named(appendix, name, bad):
    given = dict(zip(("q", "qd", "qdd"), np.zeros((3, 80, 6)), strict=True))
    given[name][70, 3] = bad
    with pytest.raises(StateError, match=rf"^{name}\[70, 3\] is (nan|inf)"):
        ur5.compile(appendix).rnea(**given)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"q": np.zeros((4, 5))}, "takes \\(N, 6\\)"),
        ({"q": np.zeros((4, 3, 6))}, "takes \\(N, 6\\)"),
        ({"qd": np.zeros((3, 6))}, "different numbers of states"),
        ({"q": np.zeros((4, 6), complex)}, "real numbers"),
        ({"q": [[1.0], [1.0, 2.0]]}, "not an array of numbers"),
        ({"out": [0.0]}, "NumPy array"),
        ({"out": np.broadcast_to(0.0, (4, 6))}, "may be written"),
        ({"out": np.zeros((4, 5))}, "out must be"),
        ({"out": np.zeros((4, 6), np.float32)}, "out must be"),
    ],
)
def test_other_arrays_are_refused(appendix, change, said):
    given = dict(zip(("q", "qd", "qdd"), np.zeros((3, 4, 6)), strict=True)) | change
    with pytest.raises(StateError, match=said):
        ur5.compile(appendix).rnea(**given)


def test_options_without_meaning_are_refused(appendix):
    with pytest.raises(UsageError, match="threads"):
        ur5.compile(appendix, threads=0)
    with pytest.raises(UsageError, match="path"):
        ur5.compile(appendix, path="fortran")
    with pytest.raises(UsageError, match="layout"):
        ur5.compile(appendix).gravity_torque(np.zeros((4, 6)), layout="rows")


def test_what_many_threads_ask_for_at_once_is_made_once(tmp_path, monkeypatch):
    monkeypatch.setenv("UR5CHECK_CACHE", str(tmp_path))
    made, really = [], source.made

    def counted(*given):
        made.append(1)
        return really(*given)

    monkeypatch.setattr(source, "made", counted)
    arm, q = random_arm(2, seed=11), random_states(2, 5, seed=1).q
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: ur5.compile(arm).gravity_torque(q), range(4)))
    assert made == [1]
    assert all(np.array_equal(one, found[0]) for one in found)


def test_llvm_is_used_by_itself(appendix):
    assert default_path() == "llvm"
    assert isinstance(ur5.compile(appendix), Kernel)
    assert ur5.compile(appendix).path == "llvm"
