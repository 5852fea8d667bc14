"""INE101–107, INE116: inertias that no body has, and links that move without any."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._finding import Finding, Severity
from .._robot.robot import Inertial, RobotLink
from .._robot.transforms import Array
from .examples import joint, link, robot
from .finding_log import finding_of
from .inertia_measures import subject_of
from .rule import Rule
from .rule_subject import RuleSubject

__all__ = ["RULES"]

#: A tensor of a dummy frame: too small for any torque that is printed [kg m²].
_DUMMY = 1e-6


def _mass(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        m = inertial.mass
        if not inertial.judged.mass_possible:
            problem = (
                f"mass is negative, {m:.4g} kg"
                if m < 0.0
                else "mass is zero although the inertia tensor is not"
            )
            dummy = m == 0.0 and inertial.judged.largest <= _DUMMY
            yield finding_of(
                "INE101", subject_of(body), problem, inertial.place("mass"), value=m, bound=0.0,
                unit="kg", severity="warning" if dummy else None,
            )  # fmt: skip


def _unknown_tensors(s: RuleSubject) -> Iterator[Finding]:
    unknown = [
        (body, body.inertial)
        for body in s.robot.links
        if body.inertial is not None and not body.inertial.tensor_known
    ]
    if unknown:
        shown = ", ".join(repr(body.name) for body, _ in unknown)
        places = (inertial.place("inertia") for _, inertial in unknown)
        yield finding_of(
            "INE117", "robot", f"the inertia tensors of {shown} are unknown", *places,
            value=len(unknown), bound=0,
        )  # fmt: skip
    for body, inertial in unknown:
        if inertial.mass < 0.0:
            problem = f"mass is negative, {inertial.mass:.4g} kg"
            yield finding_of(
                "INE101", subject_of(body), problem, inertial.place("mass"), value=inertial.mass,
                bound=0.0, unit="kg",
            )  # fmt: skip


def _positive(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        judged = inertial.judged
        if judged.has_tensor and not judged.positive:
            yield finding_of(
                "INE102",
                subject_of(body),
                "inertia tensor is not positive definite: principal moments "
                f"{_three(judged.moments)} kg m²",
                inertial.place("inertia"),
                value=float(judged.moments[0]),
                bound=0.0,
                unit="kg m²",
                severity=_graver_if_heavy(inertial),
            )


def _triangle(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        judged = inertial.judged
        if judged.has_tensor and judged.positive and not judged.triangle:
            over = -judged.margin / float(judged.moments[2])
            yield finding_of(
                "INE103",
                subject_of(body),
                f"principal moments {_three(judged.moments)} kg m² break the triangle inequality "
                f"by {_percent(over)} of the largest, more than the printed digits allow",
                inertial.place("inertia"),
                value=over,
                bound=judged.margin_tolerance / float(judged.moments[2]),
                severity=_graver_if_heavy(inertial),
            )


def _graver_if_heavy(inertial: Inertial) -> Severity | None:
    """A dummy's numbers are wrong, but no torque shows it: a warning."""
    light = abs(inertial.mass) <= 1e-3 and inertial.judged.largest <= _DUMMY
    return "warning" if light else None


# --- what moves must weigh -----------------------------------------------------------------------


def _moving_groups(s: RuleSubject) -> Iterator[tuple[RobotLink, list[str]]]:
    """Links right after a moving joint, with all that is fixed to them."""
    for one in s.robot.joints:
        if one.moves and not s.robot.link[one.child].between:
            yield s.robot.link[one.child], list(s.robot.rigid(one.child))


def _kinematic_only(s: RuleSubject) -> Iterator[Finding]:
    if s.moving and all(link.inertial is None for link in s.robot.links):
        yield finding_of(
            "INE116", "robot", "no link has an <inertial>: this file describes motion only"
        )


def _without_inertial(s: RuleSubject) -> Iterator[Finding]:
    if all(link.inertial is None for link in s.robot.links):
        return  # which is one finding, not one a link
    for body, group in _moving_groups(s):
        if all(s.robot.link[name].inertial is None for name in group):
            carries = any(joint.moves for name in group for joint in s.robot.below[name])
            yield finding_of(
                "INE104",
                subject_of(body),
                "moves, but neither it nor anything fixed to it has an <inertial>",
                body.place,
                severity="warning" if carries else None,
            )


def _massless(s: RuleSubject) -> Iterator[Finding]:
    masses = {body.name: inertial.mass for body, inertial in s.bodies}
    for body, group in _moving_groups(s):
        inertials = [s.robot.link[name].inertial for name in group]
        if all(i is None for i in inertials) or any(
            i is not None and not i.readable for i in inertials
        ):
            continue
        if sum(masses.get(name, 0.0) for name in group) != 0.0:
            continue
        beyond = [name for name in s.robot.down(body.name) if name not in group]
        carries = any(masses.get(name, 0.0) > 0.0 for name in beyond)
        place = next(i.place("mass") for i in inertials if i is not None)
        yield finding_of(
            "INE105",
            subject_of(body),
            "moves, but its mass and that of all that is fixed to it is zero"
            + ("" if carries else ", and it carries nothing"),
            place,
            value=0.0,
            bound=0.0,
            unit="kg",
            severity="note" if carries else None,
        )


def _point_mass(s: RuleSubject) -> Iterator[Finding]:
    for body, group in _moving_groups(s):
        members = [(name, s.robot.link[name].inertial) for name in group]
        heavy = [(n, i) for n, i in members if i is not None and i.readable and i.mass > 0.0]
        if heavy and not any(i.judged.has_tensor for _, i in heavy):
            mass = sum(i.mass for _, i in heavy)
            largest = max(float(np.abs(i.own_tensor).max()) for _, i in heavy)
            yield finding_of(
                "INE106",
                subject_of(body),
                f"moves with {mass:.4g} kg but without an inertia tensor"
                + (f": no entry exceeds {largest:.2g} kg m²" if largest > 0.0 else ""),
                heavy[0][1].place("inertia"),
                value=largest,
                unit="kg m²",
            )


def _shape_without_mass(s: RuleSubject) -> Iterator[Finding]:
    if all(link.inertial is None for link in s.robot.links):
        return
    for body in s.robot.links:
        solid = any(shape.kind == "collision" for shape in body.shapes)
        if not solid or body.name not in s.moving:
            continue
        if body.inertial is None or (body.inertial.readable and body.inertial.mass == 0.0):
            what = "no <inertial>" if body.inertial is None else "mass 0"
            place = body.place if body.inertial is None else body.inertial.place("mass")
            yield finding_of(
                "INE107", subject_of(body), f"has a collision shape but {what}", place, value=0.0,
                unit="kg", severity="note" if body.inertial is None else None,
            )  # fmt: skip


def _three(values: Array) -> str:
    return ", ".join(f"{value:.4g}" for value in values)


def _percent(part: float) -> str:
    return f"{part:.2%}" if part >= 1e-4 else f"{100 * part:.1g} %"


_GOOD = robot()
_BOX = (
    '<collision><origin xyz="0 0 0.1"/><geometry><box size="0.1 0.1 0.25"/></geometry></collision>'
)
_NONE = (
    '<inertial><mass value="0"/>'
    '<inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial>'
)
_WAY = joint("k", parent="arm", child="tip", origin='<origin xyz="0 0 0.4"/>')
_TIP = link("tip", ixx="0.0002", iyy="0.0002", izz="0.0001", mass="0.2")

RULES = (
    Rule(
        "INE101", "mass-negative", "error",
        "masses are not negative, and not zero where there is a tensor",
        "No body has a negative mass, and none turns hard without having any.",
        "engines refuse the file, or compute with a body that falls upwards",
        bad=robot(joint(), link(mass="-1")), good=_GOOD,
        fix="give the mass in kilograms, above zero; leave <inertial> out for a mere frame",
        check=_mass,
    ),
    Rule(
        "INE102", "not-positive-definite", "error",
        "the inertia tensor is positive definite",
        "Turning a body costs energy about every axis.",
        "MuJoCo and Drake refuse or replace it; in others the mass matrix may have no inverse",
        bad=robot(joint(), link(izz="-0.002")), good=_GOOD,
        fix="check the six entries, their signs and their order",
        report="Drake, MuJoCo: both check physical validity of inertias",
        check=_positive,
    ),
    Rule(
        "INE103", "triangle-inequality", "error",
        "no principal moment exceeds the sum of the other two",
        "Each moment is an integral over two coordinates; the sum of two holds all of the third.",
        "MuJoCo refuses it, Drake replaces the tensor by a sphere's, DART and Bullet take it",
        bad=robot(joint(), link(izz="0.02")), good=_GOOD,
        fix="no body of positive density has it: export the tensor again, with all digits",
        report="https://github.com/RobotLocomotion/drake/pull/19238",
        check=_triangle,
    ),
    Rule(
        "INE104", "moving-link-without-inertial", "error",
        "a link that moves has an inertia, itself or by what is fixed to it",
        "URDF leaves a link without <inertial> undefined.",
        "DART gives it 1 kg, MuJoCo the weight of its collision shape, others nothing: M singular",
        bad=robot(joint(), link(), _WAY, '<link name="tip"/>'), good=_GOOD,
        fix="write its <inertial>",
        check=_without_inertial,
    ),
    Rule(
        "INE105", "moving-link-without-mass", "error",
        "what a moving joint carries weighs something",
        "A joint that carries nothing has no equation of motion.",
        "the mass matrix is singular: no forward dynamics, no simulation",
        bad=robot(joint(), link(inertial=_NONE)), good=_GOOD,
        fix="give its mass, or make its joint fixed",
        check=_massless,
    ),
    Rule(
        "INE106", "mass-without-tensor", "error",
        "a link that moves with a mass has a tensor too",
        "A body has extent, so it resists turning.",
        "MuJoCo refuses it; about a joint axis through its centre the mass matrix is singular",
        bad=robot(joint(), link(ixx="0", iyy="0", izz="0")), good=_GOOD,
        fix="give the tensor about the centre of mass",
        check=_point_mass,
    ),
    Rule(
        "INE107", "shape-without-mass", "warning",
        "a moving link with a collision shape has a mass",
        "Engines weigh by its shape what has no mass.",
        "MuJoCo fills the shape with water (1,000 kg/m³), DART gives the link 1 kg",
        bad=robot(joint(), link(), joint("f", "fixed", "arm", "tool", axis="", limit=""),
                  link("tool", inertial=_NONE, shapes=_BOX)),
        good=_GOOD,
        fix="give the mass, or leave the collision shape out",
        check=_shape_without_mass,
    ),
    Rule(
        "INE116", "no-inertias", "warning",
        "the robot has inertias at all",
        "Descriptions for planning and drawing leave dynamics out; engines invent what is missing.",
        "DART gives each link 1 kg, MuJoCo the weight of its shape; others compute no torques",
        bad=robot(joint(), '<link name="arm"/>'), good=_GOOD,
        fix="use it for kinematics only, or add <inertial> to every link that moves",
        check=_kinematic_only,
    ),
    Rule(
        "INE117", "tensor-unknown", "warning",
        "every link has an inertia tensor",
        "Data sheets give masses and centres of mass, and leave the tensors out.",
        "gravity torques only: no mass matrix, no torque of a motion, no simulation",
        bad="a DH table without the column inertia, or with zeros in it", good="a DH table with it",
        fix="take tensors from CAD, or estimate them from the links' shapes",
        check=_unknown_tensors,
        example="words",
    ),
)  # fmt: skip
