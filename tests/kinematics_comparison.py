"""Forward kinematics by the grammar alone, for comparison with Pinocchio's."""

from __future__ import annotations

from typing import Any

import numpy as np
import pinocchio as pin

from ur5check._robot import Inertia, SerialArm, Transform

# A link and the joint that moves it often share a name.
BODIES = pin.FrameType.BODY


def link_poses(arm: SerialArm, q: np.ndarray) -> list[Transform]:
    """Frames 1 … n in the base frame."""
    T, poses = arm.base, []
    for joint, link, qi in zip(arm.joints, arm.links, q, strict=True):
        T = T @ joint.motion(float(qi)) @ link.link_tip_frame
        poses.append(T)
    return poses


def configuration(model: Any, q: dict[str, float]) -> np.ndarray:
    """Pinocchio's q: cos and sin where a joint is continuous, zero for joints not named."""
    full = pin.neutral(model)
    for name, value in q.items():
        joint = model.joints[model.getJointId(name)]
        entry = [value] if joint.nq == 1 else [np.cos(value), np.sin(value)]
        full[joint.idx_q : joint.idx_q + joint.nq] = entry
    return full


def only_these_joints(model: Any, names: tuple[str, ...]) -> Any:
    """Pinocchio's own model with all other joints locked at neutral."""
    others = [i for i in range(1, model.njoints) if model.names[i] not in names]
    return model if not others else pin.buildReducedModel(model, others, pin.neutral(model))


def assert_same_kinematics(arm: SerialArm, model: Any, base: str | None, tip: str | None) -> None:
    """Base to tip, at random postures; `None` stands for the universe and for the last joint."""
    rng = np.random.default_rng(20)
    data = model.createData()
    for _ in range(5):
        q = rng.uniform(-2.0, 2.0, arm.n)
        full = configuration(model, dict(zip(arm.joint_names, q, strict=True)))
        pin.framesForwardKinematics(model, data, full)
        start = data.oMf[model.getFrameId(base, BODIES)] if base else pin.SE3.Identity()
        end = data.oMf[model.getFrameId(tip, BODIES)] if tip else data.oMi[model.njoints - 1]
        ours = link_poses(arm, q)[-1].matrix()
        np.testing.assert_allclose(ours, (start.inverse() * end).homogeneous, atol=1e-11)


def assert_same_inertias(arm: SerialArm, model: Any) -> None:
    """Each link's inertia, back in the frame of its joint, against the model's own."""
    for i, (name, link) in enumerate(zip(arm.joint_names, arm.links, strict=True), start=1):
        assert model.names[i] == name
        body = model.inertias[i]
        theirs = Inertia(body.mass, body.lever, body.inertia)
        ours = link.inertia.expressed_in(link.link_tip_frame)
        scale = np.abs(theirs.parameters()).max()
        np.testing.assert_allclose(ours.parameters(), theirs.parameters(), atol=1e-14 * scale)
