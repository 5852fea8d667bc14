"""The serial arms of example-robot-data: which of its robots, cut where.

A robot with a gripper is cut at the link that carries it, and the fingers held still; a robot with
several limbs gives one of them, held at the body that it grows from.  What is not here does not
load: a body of it breaks a rule (a tensor that no body has), its file has no name, or it has no
chain of its own.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from .._errors import ModelError
from .._robot.serial_arm import SerialArm
from .loading import load
from .ros_packages import example_robot_data

__all__ = ["FLEET", "FleetArm"]


@dataclass(frozen=True)
class FleetArm:
    """file : under example-robot-data's `robots`;  base, tip : the links between which it is cut"""

    name: str
    file: str
    base: str
    tip: str

    def load(self) -> SerialArm:
        """The arm.  Raises ModelError if example-robot-data is not installed."""
        share = example_robot_data()
        if share is None:
            raise ModelError(
                "this model is part of example-robot-data, which is not installed here",
                fix="install example-robot-data",
                file=self.file,
            )
        arm = load(share / "robots" / self.file, base=self.base, tip=self.tip)
        # A report names the file as it is called on every machine.
        inputs = tuple((f"example-robot-data/{self.file}", sha) for _, sha in arm.source.inputs)
        return replace(arm, name=self.name, source=replace(arm.source, inputs=inputs))


_UR = "ur_description/urdf"
_TALOS = "talos_data/robots/talos_reduced.urdf"
_BAXTER = "baxter_description/urdf/baxter.urdf"
_G1 = "g1_description/urdf/g1_29dof_rev_1_0.urdf"
_ALEX = "alex_description/urdf/alex_nub_hands.urdf"
_TIAGO_PRO = "tiago_pro_description/robots/tiago_pro.urdf"

#: Arms first, limbs of walking robots after them.
FLEET: tuple[FleetArm, ...] = (
    FleetArm("ur3", f"{_UR}/ur3_robot.urdf", "base_link", "tool0"),
    FleetArm("ur3-gripper", f"{_UR}/ur3_gripper.urdf", "base_link", "tool0"),
    FleetArm("ur5", f"{_UR}/ur5_robot.urdf", "base_link", "tool0"),
    FleetArm("ur5-gripper", f"{_UR}/ur5_gripper.urdf", "base_link", "tool0"),
    FleetArm("ur5-limited", f"{_UR}/ur5_joint_limited_robot.urdf", "base_link", "tool0"),
    FleetArm("ur10", f"{_UR}/ur10_robot.urdf", "base_link", "tool0"),
    FleetArm("panda-flange", "panda_description/urdf/panda.urdf", "panda_link0", "panda_link8"),
    FleetArm("panda-hand", "panda_description/urdf/panda.urdf", "panda_link0", "panda_hand"),
    FleetArm("kinova", "kinova_description/robots/kinova.urdf", "base", "j2s6s200_link_6"),
    FleetArm(
        "kinova-tool", "kinova_description/robots/kinova.urdf", "base", "j2s6s200_end_effector"
    ),
    FleetArm("xarm7", "xarm_description/urdf/xarm7.urdf", "world", "link_eef"),
    FleetArm("z1", "z1_description/urdf/z1.urdf", "world", "gripperMover"),
    FleetArm("so100", "so_arm_description/urdf/so100.urdf", "base", "jaw"),
    FleetArm("so101", "so_arm_description/urdf/so101.urdf", "base_link", "gripper_frame_link"),
    FleetArm("talos-left-arm", _TALOS, "torso_2_link", "arm_left_7_link"),
    FleetArm("talos-right-arm", _TALOS, "torso_2_link", "arm_right_7_link"),
    FleetArm("baxter-left-arm", _BAXTER, "torso", "left_gripper"),
    FleetArm("baxter-right-arm", _BAXTER, "torso", "right_gripper"),
    FleetArm("g1-left-arm", _G1, "torso_link", "left_wrist_yaw_link"),
    FleetArm("g1-right-arm", _G1, "torso_link", "right_wrist_yaw_link"),
    FleetArm("tiago-pro-left-arm", _TIAGO_PRO, "torso_lift_link", "arm_left_7_link"),
    FleetArm("alex-left-arm", _ALEX, "Torso", "LeftGripperYawLink"),
    FleetArm("romeo-left-arm", "romeo_description/urdf/romeo.urdf", "torso", "l_wrist"),
    FleetArm("borinot-arm", "borinot_description/urdf/borinot_flying_arm_2.urdf",
             "borinot__base_link", "flying_arm_2__ee"),
    FleetArm("hextilt-arm", "hextilt_description/urdf/hextilt_flying_arm_5.urdf",
             "hextilt__base_link", "flying_arm_5__gripper"),
    FleetArm("two-dofs", "asr_twodof_description/urdf/TwoDofs.urdf", "world", "Tip"),
    FleetArm("double-pendulum", "double_pendulum_description/urdf/double_pendulum.urdf",
             "base_link", "link2"),
    FleetArm("double-pendulum-continuous",
             "double_pendulum_description/urdf/double_pendulum_continuous.urdf",
             "base_link", "link2"),
    FleetArm("finger-edu", "finger_edu_description/robots/finger_edu.urdf",
             "base_link", "finger_tip_link"),
    FleetArm("solo12-leg", "solo_description/robots/solo12.urdf", "base_link", "FL_FOOT"),
    FleetArm("a1-leg", "a1_description/urdf/a1.urdf", "trunk", "FL_foot"),
    FleetArm("go2-leg", "go2_description/urdf/go2.urdf", "base", "FL_foot"),
    FleetArm("laikago-leg", "laikago_description/urdf/laikago.urdf", "trunk", "FL_foot"),
    FleetArm("alexander-leg", "alexander_description/urdf/alexander_v1.lowerBodyOnly.urdf",
             "PELVIS_LINK", "LEFT_FOOT"),
    FleetArm("g1-leg", _G1, "pelvis", "left_ankle_roll_link"),
)  # fmt: skip
