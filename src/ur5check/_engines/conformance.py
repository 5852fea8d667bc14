"""The conformance suite: the tests that every engine passes.

    import pytest
    from ur5check._engines import conformance

    @pytest.mark.parametrize("law", conformance.LAWS, ids=lambda law: law.id)
    @pytest.mark.parametrize("case", conformance.CASES, ids=lambda case: case.name)
    def test_my_engine(case, law):
        conformance.check(MyEngine, case, law)

An engine that is known to misread a file is tested with the repaired file:
`lambda arm, gravity: DartEngine(known_issues.repaired(arm, "dart"), gravity)`.

Each answer is compared with the hand-written recursion on an arm that was built by hand
(`conformance_arms`), never with a reading of the same text.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .._robot.states import States, random_states
from .._robot.transforms import Array
from .adapters.ur5check_recursion import RecursionEngine
from .conformance_arms import CASES, Case
from .engine import Engine, MakeEngine
from .imported_model import ImportedModel, moving_inertias

__all__ = ["CASES", "LAWS", "Case", "Law", "check", "violations"]

_STATES, _SEED = 24, 4
_EPS = float(np.finfo(np.float64).eps)
# As for the laws of `_validation`: a number carried through n joints is rounded some 32 times in
# each, by ε of the size of the summands.
_ROUNDING = 32 * _EPS


@dataclass(frozen=True, eq=False)
class _Trial:
    """One engine and the reference recursion on one arm, with the states to compare at."""

    case: Case
    engine: Engine
    reference: RecursionEngine
    states: States


@dataclass(frozen=True)
class Law:
    """A property that every engine must have.

    Attributes
    ----------
    id : str
        Its name in tests.
    statement : str
        What must hold, as a clause.
    measure : callable
        Returns the error, and the size against which rounding is judged.
    """

    id: str
    statement: str
    measure: Callable[[_Trial], tuple[float, float]]


def check(make: MakeEngine, case: Case, law: Law) -> None:
    """Check one law for one engine on one arm.

    Parameters
    ----------
    make : callable
        `make(arm, gravity)` returns the engine with the arm loaded (`ur5check.results.Engine`).
    case : Case
        One of `CASES`.
    law : Law
        One of `LAWS`.

    Raises
    ------
    AssertionError
        If the engine breaks the law, with the law, the case and the figures.

    Examples
    --------
    >>> import ur5check
    >>> from ur5check import testing
    >>> def pinocchio(arm, gravity):
    ...     return ur5check.make_engine("pinocchio", arm, gravity)
    >>> testing.check(pinocchio, testing.CASES[0], testing.LAWS[0])
    """
    n = case.arm.n
    trial = _Trial(
        case,
        make(case.arm, case.gravity),
        RecursionEngine(case.arm, case.gravity),
        random_states(n, _STATES, _SEED),
    )
    value, size = law.measure(trial)
    limit = n * _ROUNDING * size
    if not value <= limit:  # nan fails
        raise AssertionError(
            f"{trial.engine.name} on {case.name!r}: {law.statement} ({law.id}): off by "
            f"{value:.2e}, rounding allows {limit:.2e}"
        )


def violations(make: MakeEngine) -> tuple[str, ...]:
    """Every law that an engine breaks on any case.

    Parameters
    ----------
    make : callable
        `make(arm, gravity)` returns the engine with the arm loaded (`ur5check.results.Engine`).

    Returns
    -------
    tuple of str
        A sentence for each; empty for a conforming engine.

    Raises
    ------
    EngineError
        If the engine refuses a case.

    Examples
    --------
    >>> import ur5check
    >>> from ur5check import testing
    >>> testing.violations(lambda arm, gravity: ur5check.make_engine("pinocchio", arm, gravity))
    ()
    """
    messages = []
    for case in CASES:
        for law in LAWS:
            try:
                check(make, case, law)
            except AssertionError as error:
                messages.append(str(error))
    return tuple(messages)


def _gap(a: Array, b: Array) -> tuple[float, float]:
    a, b = np.asarray(a), np.asarray(b)
    if a.shape != b.shape:
        return float("inf"), 1.0
    return float(np.abs(a - b).max()), float(np.abs(b).max())


def _tool_pose(t: _Trial) -> tuple[float, float]:
    return _gap(t.engine.forward_kinematics(t.states.q), t.reference.forward_kinematics(t.states.q))


def _inverse(t: _Trial) -> tuple[float, float]:
    state = t.states.q, t.states.qd, t.states.qdd
    return _gap(t.engine.inverse_dynamics(*state), t.reference.inverse_dynamics(*state))


def _forward(t: _Trial) -> tuple[float, float]:
    q, qd, qdd = t.states.q, t.states.qd, t.states.qdd
    tau = t.reference.inverse_dynamics(q, qd, qdd)
    moments = np.linalg.eigvalsh(t.reference.mass_matrix(q))
    error, _ = _gap(t.engine.forward_dynamics(q, qd, tau), qdd)
    # What a torque of this size can do to the lightest direction of M.
    return error, float(np.abs(tau).max() / moments.min())


def _mass(t: _Trial) -> tuple[float, float]:
    return _gap(t.engine.mass_matrix(t.states.q), t.reference.mass_matrix(t.states.q))


def _bias(t: _Trial) -> tuple[float, float]:
    state = t.states.q, t.states.qd
    return _gap(t.engine.bias_torque(*state), t.reference.bias_torque(*state))


def _gravity(t: _Trial) -> tuple[float, float]:
    return _gap(t.engine.gravity_torque(t.states.q), t.reference.gravity_torque(t.states.q))


def _shapes(t: _Trial) -> tuple[float, float]:
    """q of shape (2, 1, n) with rates of shape (3, n) make torques of shape (2, 3, n)."""
    q, qd, qdd = t.states.q[:2, None, :], t.states.qd[:3], t.states.qdd[:3]
    return _gap(t.engine.inverse_dynamics(q, qd, qdd), t.reference.inverse_dynamics(q, qd, qdd))


def _imported_model(t: _Trial) -> tuple[ImportedModel, ImportedModel]:
    return t.engine.imported_model(), t.reference.imported_model()


def _imported_joints(t: _Trial) -> tuple[float, float]:
    theirs, ours = _imported_model(t)
    found = {joint.name: joint for joint in theirs.joints}
    if set(found) != set(t.case.arm.joint_names) or len(found) != len(theirs.joints):
        return float("inf"), 1.0
    if any(found[joint.name].kind != joint.kind for joint in ours.joints):
        return float("inf"), 1.0
    gaps = [np.abs(found[joint.name].axis - joint.axis).max() for joint in ours.joints]
    return float(max(gaps)), 1.0


def _imported_origins(t: _Trial) -> tuple[float, float]:
    theirs, ours = _imported_model(t)
    found = {j.name: p for j, p in zip(theirs.joints, theirs.origins, strict=True)}
    if set(found) != {joint.name for joint in ours.joints}:
        return float("inf"), 1.0
    return _gap(np.array([found[joint.name] for joint in ours.joints]), ours.origins)


def _imported_bodies(t: _Trial) -> tuple[float, float]:
    theirs, _ = _imported_model(t)
    groups = moving_inertias(theirs, t.case.arm)
    parameters = np.concatenate([group.parameters() for group in groups])
    return _gap(parameters, t.case.arm.parameters())


def _imported_tool(t: _Trial) -> tuple[float, float]:
    theirs, ours = _imported_model(t)
    return _gap(theirs.tool, ours.tool)


LAWS: tuple[Law, ...] = (
    Law("tool-pose", "the tool is where the chain puts it", _tool_pose),
    Law("inverse-dynamics", "torques are those of the arm, in the arm's joint order", _inverse),
    Law("forward-dynamics", "accelerations are those that the torques came from", _forward),
    Law("mass-matrix", "the mass matrix is the arm's, both triangles filled", _mass),
    Law("bias-torque", "C q̇ + g is the arm's, without damping or friction", _bias),
    Law("gravity-torque", "gravity acts in the base frame as it was given", _gravity),
    Law("array-shapes", "leading axes of joint arrays broadcast", _shapes),
    Law(
        "imported-joints", "the imported joints have their names, kinds and axes", _imported_joints
    ),
    Law("imported-origins", "the imported joints are where the chain puts them", _imported_origins),
    Law(
        "imported-bodies", "each joint carries the inertia that the arm gives it", _imported_bodies
    ),
    Law(
        "imported-tool",
        "the imported tool frame at q = 0 is where the chain puts it",
        _imported_tool,
    ),
)
