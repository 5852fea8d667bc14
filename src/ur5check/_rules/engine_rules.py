"""Rules of family ENG: what a physics engine imports from a model, and what it computes from it.

The checks are the import audit of `_engines.audit`; a rule's name is the kind of difference there.
The examples in URDF or DH are those that an installed engine misreads or refuses today; a rule
whose example is in words has caught engines in earlier versions, or adapters.
"""

from __future__ import annotations

from .._finding import Severity
from .examples import joint, link, robot
from .rule import Rule

__all__ = ["RULES"]

_REPORT = "docs/engines.md"
_WHY = "engines import different robots from the same file, most of them without a message"


def _rule(
    number: int,
    name: str,
    severity: Severity,
    checks: str,
    consequence: str,
    fix: str,
    bad: str,
    good: str,
    example: str = "",
) -> Rule:
    return Rule(
        id=f"ENG{number}",
        name=name,
        severity=severity,
        checks=checks,
        why=_WHY,
        consequence=consequence,
        bad=bad,
        good=good,
        fix=fix,
        report=_REPORT,
        example=example,
    )


#: A frame behind a fixed joint at the end of the arm.
_FIXED = joint("tool_joint", "fixed", "arm", "tool", axis="", limit="")
_MASSLESS = (
    '<inertial><mass value="0"/>'
    '<inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial>'
)
_BOX = '<collision><geometry><box size="0.3 0.3 0.5"/></geometry></collision>'
_TRANSMISSION = (
    '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>'
    '<joint name="j"/><actuator name="m"/></transmission>'
)
_GEARED = """schema = "ur5check.dh/1"
name = "geared"
title = "one geared joint"
convention = "standard"

[[joint]]
joint = "j"
link = "arm"
d = 0.1
a = 0.3
alpha = 0.0
mass = 2.0
com = [-0.1, 0.0, 0.0]
inertia = { ixx = 0.002, iyy = 0.008, izz = 0.008 }
"""


RULES: tuple[Rule, ...] = (
    _rule(
        101,
        "model-refused",
        "error",
        "every engine reads the model",
        "the model cannot be used with this engine",
        "correct what the engine's message names",
        robot(joint(), link(izz="0.02")),
        robot(),
        ".urdf",
    ),
    _rule(
        102,
        "torque-unexplained",
        "error",
        "an engine's torques are those of the arm that it imported",
        "engine and recursion compute different torques from the same numbers: one has a defect",
        "report the model to ur5check or to the engine",
        "an engine whose torques are 1 % larger than those of its own model",
        "torques equal to rounding",
    ),
    _rule(
        103,
        "engines-not-asked",
        "note",
        "the file describes a robot that engines can be given",
        "nothing is known of what engines make of the file",
        "correct what the other findings name",
        robot(joint(kind="floating"), link()),
        robot(),
        ".urdf",
    ),
    _rule(
        201,
        "default-inertia",
        "error",
        "a link without <inertial> has no mass in the engine",
        "the engine simulates a heavier arm: DART adds 1 kg per frame without <inertial>",
        "write an <inertial> of mass zero",
        robot(joint(), link(), _FIXED, link("tool", "")),
        robot(joint(), link(), _FIXED, link("tool", _MASSLESS)),
        ".urdf",
    ),
    _rule(
        202,
        "shape-mass",
        "error",
        "a link without <inertial> gets no mass from its shape",
        "the engine simulates a heavier arm: MuJoCo fills collision shapes with water",
        'set <mujoco><compiler inertiafromgeom="false"/></mujoco>, or write an <inertial>',
        robot(joint(), link(), _FIXED, link("tool", "", _BOX)),
        robot(joint(), link(), _FIXED, link("tool", shapes=_BOX)),
        ".urdf",
    ),
    _rule(
        203,
        "rotation-dropped",
        "error",
        "the engine rotates the tensor by the rpy of <inertial><origin>",
        "the moments of inertia are about wrong axes",
        "write the tensor along the link's axes, with rpy 0 0 0",
        '<origin rpy="0 0 0.7"/> and the tensor used as if rpy were 0 0 0',
        "the tensor rotated by R I Rᵀ",
    ),
    _rule(
        204,
        "body-lost",
        "error",
        "every link with a mass is in the imported model",
        "the engine simulates a lighter arm",
        "put the link's inertia into the <inertial> of the moving link that carries it",
        "a camera behind a fixed joint whose 0.3 kg are missing in the engine",
        "the camera's inertia merged into the link that carries it",
    ),
    _rule(
        205,
        "mass-changed",
        "error",
        "a link has the mass of the file",
        "gravity torques change in proportion",
        "find out which of the engine's settings changes the mass",
        "2.5 kg in the file, 2.6 kg in the engine",
        "2.5 kg in both",
    ),
    _rule(
        206,
        "com-moved",
        "error",
        "a link has the centre of mass of the file",
        "gravity torques change with the lever arm",
        "find out which of the engine's settings moves the centre of mass",
        "centre of mass at x = 0.1 m in the file, at 0 in the engine",
        "the same point in both",
    ),
    _rule(
        207,
        "tensor-changed",
        "error",
        "a link has the inertia tensor of the file",
        "inertial torques change: Drake replaces a tensor that no body can have by a sphere's",
        "correct the tensor: print more digits, or raise the smallest moments",
        robot(joint(), link(izz="0.02")),
        robot(),
        ".urdf",
    ),
    _rule(
        208,
        "armature",
        "error",
        "a joint has the motor inertia of the model",
        "inertial torques of geared joints change",
        "add the motor inertia to the engine's mass matrix, or set it in the engine",
        _GEARED + "armature = 0.25\n",
        _GEARED,
        ".toml",
    ),
    _rule(
        209,
        "axis",
        "error",
        "a joint has the axis of the file",
        "all torques of the joint change",
        "correct the joint's <axis> and <origin>",
        "axis (0, 0, 1) in the file, (0, 0, −1) in the engine",
        "(0, 0, 1) in both",
    ),
    _rule(
        210,
        "joint-moved",
        "error",
        "a joint is where the file puts it",
        "every torque below the joint changes with the lever arm",
        "correct the joint's <origin>, or find out which of the engine's settings moves it",
        "origin at z = 0.3 m in the file, at 0.2 m in the engine",
        "the same point in both",
    ),
    _rule(
        301,
        "gravity",
        "warning",
        "the engine's default gravity is the model's",
        "gravity torques change unless gravity is set: 9.80665 or 9.81 m/s², or another direction",
        "set the engine's gravity",
        "9.81 m/s² in the model, 9.80665 m/s² as the engine's default",
        "the same gravity in both",
    ),
    _rule(
        302,
        "order",
        "warning",
        "the engine has the joints in the order of the file's tree, parents first",
        "torques are sent to the wrong joints where arrays are copied",
        "map joints by name",
        robot(joint(), link(), joint("a", child="other"), link("other")),
        robot(),
        ".urdf",
    ),
    _rule(
        303,
        "tool",
        "warning",
        "the tool frame is where the file puts it",
        "poses of the tool, and forces there, are wrong",
        "correct the fixed joint that carries the tool frame",
        "tool 0.01 m higher in the engine",
        "the same pose in both",
    ),
    _rule(
        304,
        "position-limit",
        "note",
        "position limits are imported",
        "a simulated joint moves where the real one meets its stop",
        "set the limits in the engine",
        robot(joint(kind="continuous"), link()),
        robot(),
        ".urdf",
    ),
    _rule(
        305,
        "velocity-limit",
        "note",
        "velocity limits are imported",
        "the engine does not report or limit a joint that is too fast",
        "limit velocities in the controller",
        robot(),
        robot(joint(kind="continuous", limit=""), link()),
        ".urdf",
    ),
    _rule(
        306,
        "effort-limit",
        "note",
        "effort limits are imported",
        "a simulated motor gives more torque than the real one",
        "add what the engine reads limits from, in Drake a <transmission> for each joint",
        robot(),
        robot(joint(), link(), _TRANSMISSION),
        ".urdf",
    ),
    _rule(
        307,
        "damping",
        "note",
        "joint damping is imported",
        "simulated joints lose less or more energy",
        "set the damping in the engine",
        "0.5 N m s/rad in the file, 0 in the engine",
        "0.5 N m s/rad in both",
    ),
    _rule(
        308,
        "friction",
        "note",
        "joint friction is imported",
        "simulated joints move under torques that real ones withstand",
        "add the friction as a torque of your own",
        robot(joint(more='<dynamics friction="0.2"/>'), link()),
        robot(),
        ".urdf",
    ),
)
