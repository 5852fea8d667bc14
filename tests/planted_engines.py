"""Engines that read or compute something wrong: our own recursion on a spoiled arm.

Each reads the arm's URDF text, spoils it as its name says, and computes honestly on from there.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np

from ur5check._dynamics.kinematics import link_frames
from ur5check._engines.adapters.ur5check_recursion import RecursionEngine
from ur5check._engines.audit.written_bodies import written_arm
from ur5check._engines.imported_model import ImportedBody
from ur5check._errors import EngineError
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._robot import Inertia, Limits
from ur5check._robot.transforms import Transform

UNIT = (
    '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
    "</inertial>"
)


def reread(arm, text):
    """The arm that a spoiled text stands for."""
    source = arm.source
    assert text != source.urdf, "nothing was spoiled"
    return read_urdf(text.encode(), file="spoiled.urdf", base=source.base, tip=source.tip)


class Honest(RecursionEngine):
    """Reads and computes rightly, and keeps a body for every link."""

    name = "Honest"

    def __init__(self, arm, gravity=None):
        self.written = arm
        super().__init__(self.spoiled(arm), arm.gravity if gravity is None else gravity)

    def spoiled(self, arm):
        return arm

    def imported_model(self):
        """What is held, link by link where the text still tells the links."""
        whole = super().imported_model()
        frames = link_frames(self.arm, np.zeros(self.arm.n))
        bodies = [
            ImportedBody(
                body.name,
                body.carried_by,
                Inertia.from_parameters(body.parameters).expressed_in(
                    Transform.from_matrix(frames[body.carried_by])
                ),
            )
            for body in written_arm(self.arm).bodies
        ]
        return replace(whole, bodies=tuple(bodies))


class Merging(RecursionEngine):
    """Keeps one body a joint."""


class RotationDropped(Honest):
    def spoiled(self, arm):
        pattern = r'(<inertial>\s*<origin xyz="[^"]*") rpy="[^"]*"'
        return reread(arm, re.sub(pattern, r"\1", arm.source.urdf))


class RotationDroppedAndMerging(RotationDropped):
    imported_model = RecursionEngine.imported_model


class DefaultMass(Honest):
    def spoiled(self, arm):
        text = re.sub(
            r'<link name="tool"\s*/>', f'<link name="tool">{UNIT}</link>', arm.source.urdf
        )
        return reread(arm, text)


class DefaultMassAndMerging(DefaultMass):
    imported_model = RecursionEngine.imported_model


class ShapeMass(Honest):
    """Weighs link "plate" by its box of 0.1 × 0.2 × 0.3 m."""

    def spoiled(self, arm):
        inertial = (
            '<inertial><origin xyz="0 0 0.05"/><mass value="6"/><inertia ixx="0.065" ixy="0" '
            'ixz="0" iyy="0.05" iyz="0" izz="0.025"/></inertial>'
        )
        return reread(
            arm, arm.source.urdf.replace('<link name="plate">', f'<link name="plate">{inertial}')
        )


class BodyLost(Honest):
    """Does not carry what is fixed to the last link."""

    def spoiled(self, arm):
        return reread(
            arm,
            re.sub(r'(<link name="weight">).*?</link>', r"\1</link>", arm.source.urdf, flags=re.S),
        )


class BodyLostAndMerging(BodyLost):
    imported_model = RecursionEngine.imported_model


class MassChanged(Honest):
    def spoiled(self, arm):
        return reread(arm, arm.source.urdf.replace('<mass value="2.5"/>', '<mass value="2.6"/>'))


class CentreMoved(Honest):
    def spoiled(self, arm):
        return reread(arm, arm.source.urdf.replace('xyz="0.1 0.02 0"', 'xyz="0 0.02 0"'))


class Balanced(Honest):
    """Makes a sphere of link "upper"."""

    def spoiled(self, arm):
        old = 'ixx="0.01" ixy="0.001" ixz="0" iyy="0.03" iyz="0" izz="0.032"'
        new = 'ixx="0.024" ixy="0" ixz="0" iyy="0.024" iyz="0" izz="0.024"'
        return reread(arm, arm.source.urdf.replace(old, new))


class MotorAdded(Honest):
    def spoiled(self, arm):
        return arm.with_armature([0.0, 0.25, 0.0])


class GravityOfItsOwn(Honest):
    """Is told a gravity, and takes its own."""

    def __init__(self, arm, gravity=None):
        super().__init__(arm, (0.0, 0.0, -9.80665))

    def imported_model(self):
        return replace(super().imported_model(), gravity=np.array(self.gravity))


class GravityByDefault(Honest):
    """Would take another gravity, and takes what it is told."""

    def imported_model(self):
        return replace(super().imported_model(), gravity=np.array([0.0, 0.0, -9.80665]))


class OrderOfItsOwn(Honest):
    """Takes and gives arrays in its own joint order: the first two are exchanged."""

    order = (1, 0, 2)

    def inverse_dynamics(self, q, qd, qdd):
        given = (np.asarray(array)[..., list(self.order)] for array in (q, qd, qdd))
        return super().inverse_dynamics(*given)[..., list(self.order)]

    def imported_model(self):
        whole = super().imported_model()
        order = list(self.order)
        joints = tuple(whole.joints[k] for k in order)
        return replace(whole, joints=joints, origins=whole.origins[order])


class LimitsLost(Honest):
    def imported_model(self):
        whole = super().imported_model()
        return replace(whole, joints=tuple(replace(j, limits=Limits()) for j in whole.joints))


class BearingsLost(Honest):
    def imported_model(self):
        whole = super().imported_model()
        joints = tuple(replace(j, damping=0.0, friction=0.0) for j in whole.joints)
        return replace(whole, joints=joints)


class AxisReversed(Honest):
    def imported_model(self):
        whole = super().imported_model()
        first = replace(whole.joints[0], axis=-whole.joints[0].axis)
        return replace(whole, joints=(first, *whole.joints[1:]))


class JointMoved(Honest):
    def imported_model(self):
        whole = super().imported_model()
        return replace(whole, origins=whole.origins + [[0, 0, 0], [0, 0, 1e-9], [0, 0, 0]])


class ToolElsewhere(Honest):
    def imported_model(self):
        whole = super().imported_model()
        tool = whole.tool.copy()
        tool[2, 3] += 0.01
        return replace(whole, tool=tool)


class TwoCoordinates(Honest):
    def imported_model(self):
        return replace(super().imported_model(), coordinates=4)


class Miscalculating(Honest):
    """Holds the right arm and computes another: nothing in its import explains it."""

    def inverse_dynamics(self, q, qd, qdd):
        return super().inverse_dynamics(q, qd, qdd) * (1.0 + 1e-9)


class BreakingDown(Honest):
    def inverse_dynamics(self, q, qd, qdd):
        return super().inverse_dynamics(q, qd, qdd) * np.nan


class Refusing(Honest):
    def __init__(self, arm, gravity=None):
        raise EngineError("it has no taste for this file")
