"""Hypothesis strategies: arms that could be built, and states that they could be in.

    from hypothesis import given
    from ur5check import strategies as ur5

    @given(ur5.arms_and_states())
    def test_my_law(arm_and_states): ...

Needs the extra `ur5check[strategies]`.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from hypothesis import strategies as st

from ._robot.inertia import Inertia
from ._robot.serial_arm import Joint, Link, SerialArm
from ._robot.states import MAX_ACCELERATION, MAX_ANGLE, MAX_RATE, States
from ._robot.transforms import Array, Transform

__all__ = ["arms", "arms_and_states", "inertias", "states", "transforms", "unit_vectors"]


def _floats(bound: float) -> st.SearchStrategy[float]:
    return st.floats(-bound, bound, allow_subnormal=False)


def _arrays(bound: float, *shape: int) -> st.SearchStrategy[Array]:
    size = int(np.prod(shape))
    return st.lists(_floats(bound), min_size=size, max_size=size).map(
        lambda values: np.reshape(values, shape)
    )


def unit_vectors() -> st.SearchStrategy[Array]:
    """Unit vectors: often a coordinate axis, as in real arms, else any.

    Returns
    -------
    SearchStrategy of ndarray, shape (3,)

    Examples
    --------
    >>> import numpy as np
    >>> from hypothesis import find
    >>> from ur5check import strategies as ur5
    >>> find(ur5.unit_vectors(), lambda u: u[1] > 0).tolist()
    [0.0, 1.0, 0.0]
    """
    axes = [sign * axis for axis in np.eye(3) for sign in (1.0, -1.0)]
    anywhere = _arrays(1.0, 3).filter(lambda v: np.linalg.norm(v) > 0.1)
    return st.one_of(st.sampled_from(axes), anywhere.map(lambda v: v / np.linalg.norm(v)))


def transforms(reach: float = 0.5) -> st.SearchStrategy[Transform]:
    """Rigid transforms; quarter turns are as likely as other angles.

    Parameters
    ----------
    reach : float
        Bound on each component of the translation [m].

    Returns
    -------
    SearchStrategy of Transform

    Raises
    ------
    hypothesis.errors.InvalidArgument
        When a value is drawn, for a bound that is negative or not finite.

    Examples
    --------
    >>> from hypothesis import find
    >>> from ur5check import strategies as ur5
    >>> find(ur5.transforms(reach=0.5), lambda T: True).p.tolist()
    [0.0, 0.0, 0.0]
    """
    angle = st.one_of(st.sampled_from([0.0, np.pi / 2, -np.pi / 2, np.pi]), _floats(np.pi))
    return st.builds(Transform.from_rpy, _arrays(reach, 3), st.tuples(angle, angle, angle))


@st.composite
def inertias(draw: st.DrawFn) -> Inertia:
    """Inertias of bodies with mass everywhere: 0.05 to 20 kg, radii of gyration 1 to 30 cm.

    The tensor is tr(Σ) 1 − Σ for a positive definite second moment Σ, which is to say that some
    distribution of mass has it.

    Returns
    -------
    SearchStrategy of Inertia

    References
    ----------
    Wensing, Kim & Slotine 2018.

    Examples
    --------
    >>> from hypothesis import given, settings
    >>> from ur5check import strategies as ur5
    >>> @settings(max_examples=3, database=None, deadline=None)
    ... @given(ur5.inertias())
    ... def test_a_body_can_have_it(inertia):
    ...     assert inertia.triangle_margin() > 0.0
    >>> test_a_body_can_have_it()
    """
    mass = draw(st.floats(0.05, 20.0))
    radii = np.array(draw(st.tuples(*[st.floats(0.01, 0.3)] * 3)))
    R = draw(transforms()).R
    second_moment = mass * R @ np.diag(radii**2) @ R.T
    com = draw(_arrays(0.3, 3))
    return Inertia(mass, com, np.trace(second_moment) * np.eye(3) - second_moment)


@st.composite
def arms(
    draw: st.DrawFn, *, min_joints: int = 1, max_joints: int = 8, prismatic: bool = True
) -> SerialArm:
    """Serial arms in any frames, under any gravity.

    Parameters
    ----------
    min_joints, max_joints : int
        Bounds on the number of joints.
    prismatic : bool
        Whether joints may be prismatic.

    Returns
    -------
    SearchStrategy of SerialArm

    Raises
    ------
    hypothesis.errors.InvalidArgument
        When a value is drawn, for bounds in the wrong order.

    Examples
    --------
    >>> from hypothesis import given, settings
    >>> from ur5check import strategies as ur5
    >>> @settings(max_examples=3, database=None, deadline=None)
    ... @given(ur5.arms(max_joints=2))
    ... def test_links_have_mass(arm):
    ...     assert all(link.inertia.mass > 0.0 for link in arm.links)
    >>> test_links_have_mass()
    """
    n = draw(st.integers(min_joints, max_joints))
    slides: list[Literal["revolute", "prismatic"]] = ["prismatic"] if prismatic else []
    kinds = ["revolute", "revolute", "revolute", *slides]
    joints, links = [], []
    for i in range(1, n + 1):
        joints.append(Joint(f"joint_{i}", draw(unit_vectors()), draw(st.sampled_from(kinds))))
        links.append(Link(f"link_{i}", draw(transforms()), draw(inertias())))
    gravity = draw(st.one_of(st.just(np.array([0.0, 0.0, -9.81])), _arrays(10.0, 3)))
    return SerialArm("drawn", tuple(joints), tuple(links), draw(transforms()), gravity)


@st.composite
def states(draw: st.DrawFn, n: int, *, max_count: int = 4) -> States:
    """States of n joints within the bounds of `random_states`.

    Parameters
    ----------
    n : int
        Number of joints.
    max_count : int
        Largest number of states; there is at least one.

    Returns
    -------
    SearchStrategy of States

    Raises
    ------
    hypothesis.errors.InvalidArgument
        When a value is drawn, for a negative `n` or a `max_count` below 1.

    Examples
    --------
    >>> from hypothesis import given, settings
    >>> from ur5check import strategies as ur5
    >>> @settings(max_examples=3, database=None, deadline=None)
    ... @given(ur5.states(6))
    ... def test_joints(states):
    ...     assert states.qdd.shape == (len(states), 6)
    >>> test_joints()
    """
    count = draw(st.integers(1, max_count))
    bounds = (MAX_ANGLE, MAX_RATE, MAX_ACCELERATION)
    return States(*(draw(_arrays(bound, count, n)) for bound in bounds))


@st.composite
def arms_and_states(
    draw: st.DrawFn, *, min_joints: int = 1, max_joints: int = 8, prismatic: bool = True
) -> tuple[SerialArm, States]:
    """An arm with states of its own number of joints.

    Parameters
    ----------
    min_joints, max_joints : int
        Bounds on the number of joints.
    prismatic : bool
        Whether joints may be prismatic.

    Returns
    -------
    SearchStrategy of (SerialArm, States)

    Raises
    ------
    hypothesis.errors.InvalidArgument
        When a value is drawn, for bounds in the wrong order.

    Examples
    --------
    >>> from hypothesis import given, settings
    >>> from ur5check import strategies as ur5
    >>> @settings(max_examples=3, database=None, deadline=None)
    ... @given(ur5.arms_and_states(max_joints=2))
    ... def test_states_fit(drawn):
    ...     arm, states = drawn
    ...     assert states.q.shape[1] == arm.n
    >>> test_states_fit()
    """
    arm = draw(arms(min_joints=min_joints, max_joints=max_joints, prismatic=prismatic))
    return arm, draw(states(arm.n))
