"""Every engine conforms once it is given the file that it reads rightly; a spoiled one does not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import ur5check
from ur5check._engines import conformance
from ur5check._engines.adapters.ur5check_recursion import RecursionEngine
from ur5check._engines.conformance_arms import URDF, as_value, in_text
from ur5check._engines.known_issues import repaired
from ur5check._engines.registry import REGISTRY, engine_class
from ur5check._robot import Inertia, SerialArm


def maker(key):
    made = engine_class(key)
    return lambda arm, gravity=None: made(repaired(arm, key), gravity)


@pytest.mark.parametrize("law", conformance.LAWS, ids=lambda law: law.id)
@pytest.mark.parametrize("case", conformance.CASES, ids=lambda case: case.name)
@pytest.mark.parametrize("key", REGISTRY)
def test_an_engine_conforms(key, case, law):
    conformance.check(maker(key), case, law)


def test_the_arm_put_down_by_hand_is_what_the_text_means(tmp_path):
    file = tmp_path / "conformance.urdf"
    file.write_text(URDF, "utf-8")
    read = ur5check.load(file, base="base_link", tip="tool")
    arm = in_text()
    assert read.joint_names == arm.joint_names
    assert np.abs(read.parameters() - arm.parameters()).max() < 1e-15
    zero = np.zeros(3)
    poses = [ur5check.forward_kinematics(a, zero) for a in (read, arm)]
    assert np.abs(poses[0] - poses[1]).max() < 1e-15
    for ours, theirs in zip(arm.joints, read.joints, strict=True):
        assert (ours.limits, ours.damping, ours.friction, ours.kind) == (
            theirs.limits,
            theirs.damping,
            theirs.friction,
            theirs.kind,
        )


def test_dart_does_not_conform_to_the_file_as_it_is():
    said = conformance.violations(engine_class("dart"))
    assert any("imported-bodies" in sentence and "'text'" in sentence for sentence in said)
    assert not any("'value'" in sentence for sentence in said)


def test_mujoco_does_not_conform_to_the_file_as_it_is():
    said = conformance.violations(engine_class("mujoco"))
    assert any("inverse-dynamics" in sentence for sentence in said)


# --- planted faults: our own side on an arm that was spoiled on the way in ------------------------


def spoiled_engine(spoil):
    """An engine that holds what `spoil` makes of the arm that it was given."""

    class Spoiled(RecursionEngine):
        name = "spoiled"

        def __init__(self, arm: SerialArm, gravity=None):
            super().__init__(spoil(arm), gravity)

    return Spoiled


def inertias(arm, change):
    return arm.with_inertias([change(i, link.inertia) for i, link in enumerate(arm.links)])


def rpy_dropped(arm):
    return inertias(arm, lambda i, b: Inertia(b.mass, b.com, np.diag(np.linalg.eigvalsh(b.tensor))))


def default_mass(arm):
    return inertias(
        arm, lambda i, b: b + Inertia(1.0, np.zeros(3), np.eye(3)) if i == arm.n - 1 else b
    )


def tool_lost(arm):
    last = arm.links[-1]
    moved = replace(last, link_tip_frame=last.source_frame)
    return replace(arm, links=(*arm.links[:-1], moved))


@pytest.mark.parametrize(
    ("spoil", "law"),
    [
        (rpy_dropped, "inverse-dynamics"),
        (rpy_dropped, "imported-bodies"),
        (default_mass, "mass-matrix"),
        (default_mass, "forward-dynamics"),
        (default_mass, "imported-bodies"),
        (tool_lost, "tool-pose"),
        (tool_lost, "imported-tool"),
    ],
)
def test_a_spoiled_import_is_caught(spoil, law):
    said = conformance.violations(spoiled_engine(spoil))
    assert any(f"({law})" in sentence for sentence in said)


class SwappedOrder(RecursionEngine):
    """Answers in the order of the file, tip first."""

    name = "swapped"

    def inverse_dynamics(self, q, qd, qdd):
        return super().inverse_dynamics(q, qd, qdd)[..., ::-1]

    def gravity_torque(self, q):
        return super().gravity_torque(q)[..., ::-1]


class Upside(RecursionEngine):
    """Takes gravity for an acceleration of the base."""

    name = "upside"

    def __init__(self, arm, gravity=None):
        super().__init__(arm, -np.asarray(arm.gravity if gravity is None else gravity))


class OneAtATime(RecursionEngine):
    """Does not broadcast."""

    name = "one at a time"

    def inverse_dynamics(self, q, qd, qdd):
        return super().inverse_dynamics(
            np.broadcast_to(q, qd.shape) if q.ndim < 3 else q[0], qd, qdd
        )


class UpperTriangle(RecursionEngine):
    """Leaves the lower triangle empty, as `pin.crba` does."""

    name = "upper triangle"

    def mass_matrix(self, q):
        return np.triu(super().mass_matrix(q))


@pytest.mark.parametrize(
    ("engine", "law"),
    [
        (SwappedOrder, "inverse-dynamics"),
        (SwappedOrder, "gravity-torque"),
        (Upside, "gravity-torque"),
        (Upside, "bias-torque"),
        (OneAtATime, "array-shapes"),
        (UpperTriangle, "mass-matrix"),
    ],
)
def test_a_wrong_answer_is_caught(engine, law):
    assert any(f"({law})" in sentence for sentence in conformance.violations(engine))


def test_a_lost_joint_is_caught():
    class Lost(RecursionEngine):
        name = "lost"

        def imported_model(self):
            held = super().imported_model()
            return replace(held, joints=held.joints[1:], origins=held.origins[1:])

    assert any("(imported-joints)" in sentence for sentence in conformance.violations(Lost))


def test_a_moved_joint_is_caught():
    class Moved(RecursionEngine):
        name = "moved"

        def imported_model(self):
            held = super().imported_model()
            return replace(held, origins=held.origins + [0.0, 1e-9, 0.0])

    assert any("(imported-origins)" in sentence for sentence in conformance.violations(Moved))


def test_our_own_side_breaks_no_law():
    assert conformance.violations(RecursionEngine) == ()
    assert as_value().source.urdf is None
