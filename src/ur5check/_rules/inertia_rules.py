"""INE: masses, centres of mass and inertia tensors that no body, or no such body, has.

Of a body with mass m, centre c and tensor I about c, the spread along a unit vector u is

    σ_u = √(uᵀ Σ u / m),   Σ = ½ tr(I) 1 − I,

the root mean square distance of its mass from the plane through c across u.  It compares with
lengths directly: a rod of length l has 0.29 l along itself, and no body of extent l exceeds l/2.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._finding import Finding, Severity
from .._robot.inertia import Inertia
from .._robot.pseudo_inertia import judge_tensor
from .._robot.robot import Inertial, RobotLink
from .._robot.transforms import Array
from .body_extent import Extent
from .examples import joint, link, robot
from .finding_log import finding_of
from .rule import Rule
from .rule_subject import RuleSubject

__all__ = ["RULES", "spreads"]

#: A shape may be smaller than the body that it shows: covers, screws, coarse boxes [m].
SHAPE_MARGIN = 0.01
#: Times the largest spread squared that a shape allows, from which no coarse shape explains it.
_FAR_BEYOND = 4.0
#: Spread against a link's length: beyond the first no link of a robot is, beyond the second none
#: can be that moves with the others (all mass at the ends of a rod has half its length).
_WIDE, _IMPOSSIBLE = 1.0, 3.0
#: Below this part of a link's length all mass is in one point: a tensor in a smaller unit.
_POINT = 0.01
#: Denser than copper (8,960 kg/m³) is a mistake; twice as dense as tungsten is impossible.
DENSE, IMPOSSIBLY_DENSE = 9000.0, 40000.0
#: Lighter than balsa wood (150 kg/m³) by a factor of ten.
_LIGHT = 15.0
#: A link against the heavier of its neighbours.
_HEAVIER = 30.0
#: Least principal moment below this part of the next: slender; more than 60° from the way to the
#: next joint: across it.
_SLENDER, _ACROSS = 0.3, float(np.radians(60.0))

#: Units that tensors and masses are found in: factor to kg m² or kg.
_TENSOR_UNITS = (
    (1e9, "g mm²"),
    (1e7, "g cm²"),
    (1e6, "kg mm²"),
    (1e4, "kg cm²"),
    (1e3, "g m²"),
    (3417.17, "lb in²"),
    (23.7304, "lb ft²"),
    (144.0, "a unit with inches for feet"),
)
_PLAUSIBLE_SPREAD = (0.03, 0.8)  # of a link's length


def spreads(inertia: Inertia, directions: Array) -> Array:
    """σ² along each row of `directions`, shape (k,) [m²]; negative where I is no body's."""
    sigma = np.trace(inertia.tensor) / 2.0 * np.eye(3) - inertia.tensor
    return np.asarray(np.einsum("ki,ij,kj->k", directions, sigma, directions) / inertia.mass)


def _sound(inertial: Inertial) -> bool:
    """Whether the size rules have something to say: a mass, and a tensor that some body has."""
    if inertial.mass <= 0.0 or not inertial.own_tensor.any():
        return False
    judged = judge_tensor(inertial.own_tensor, inertial.tensor_rounding)
    return judged.positive and judged.triangle


def _largest_spread(inertia: Inertia) -> tuple[float, Array]:
    """The largest σ [m] and its direction."""
    sigma = np.trace(inertia.tensor) / 2.0 * np.eye(3) - inertia.tensor
    values, vectors = np.linalg.eigh(sigma)
    return float(np.sqrt(max(0.0, values[2]) / inertia.mass)), vectors[:, 2]


def _subject(body: RobotLink) -> str:
    return f"link {body.name!r}"


# --- possible for any body -----------------------------------------------------------------------


def _mass(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        m = inertial.mass
        if m < 0.0 or (m == 0.0 and inertial.own_tensor.any()):
            problem = (
                f"mass is negative, {m:.4g} kg"
                if m < 0.0
                else "mass is zero although the inertia tensor is not"
            )
            dummy = m == 0.0 and float(np.abs(inertial.own_tensor).max()) <= _DUMMY
            yield finding_of(
                "INE101", _subject(body), problem, inertial.place("mass"), value=m, bound=0.0,
                unit="kg", severity="warning" if dummy else None,
            )  # fmt: skip


#: A tensor of a dummy frame: too small for any torque that is printed [kg m²].
_DUMMY = 1e-6


def _positive(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        if not inertial.own_tensor.any():
            continue
        judged = judge_tensor(inertial.own_tensor, inertial.tensor_rounding)
        if not judged.positive:
            yield finding_of(
                "INE102",
                _subject(body),
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
        judged = judge_tensor(inertial.own_tensor, inertial.tensor_rounding)
        if inertial.own_tensor.any() and judged.positive and not judged.triangle:
            over = -judged.margin / float(judged.moments[2])
            yield finding_of(
                "INE103",
                _subject(body),
                f"principal moments {_three(judged.moments)} kg m² break the triangle inequality "
                f"by {_percent(over)} of the largest, more than the printed digits allow",
                inertial.place("inertia"),
                value=over,
                bound=judged.margin_tolerance / float(judged.moments[2]),
                severity=_graver_if_heavy(inertial),
            )


def _graver_if_heavy(inertial: Inertial) -> Severity | None:
    """A dummy's numbers are wrong, but no torque shows it: a warning."""
    light = abs(inertial.mass) <= 1e-3 and float(np.abs(inertial.own_tensor).max()) <= _DUMMY
    return "warning" if light else None


def size_severity(
    s: RuleSubject, body: RobotLink, inertial: Inertial, grave: bool
) -> Severity | None:
    """An error only where it matters: dummies of sensors, and bases that stand, are warnings.

    The scale is M R², the inertia that the robot would have with all its mass at its reach.
    """
    scale = s.robot.mass * max(s.reach, 0.1) ** 2
    part = float(np.abs(inertial.own_tensor).max()) / scale if scale > 0.0 else 1.0
    heavy = inertial.mass / s.robot.mass if s.robot.mass > 0.0 else 1.0
    least_part, least_mass = (1e-4, 0.01) if body.name in s.moving else (1e-2, 0.5)
    return None if grave and (part > least_part or heavy > least_mass) else "warning"


# --- what moves must weigh -----------------------------------------------------------------------


def _moving_groups(s: RuleSubject) -> Iterator[tuple[RobotLink, list[str]]]:
    """Links right after a moving joint, with all that is fixed to them."""
    for one in s.robot.joints:
        if one.moves:
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
                _subject(body),
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
            _subject(body),
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
        if heavy and not any(i.own_tensor.any() for _, i in heavy):
            mass = sum(i.mass for _, i in heavy)
            yield finding_of(
                "INE106",
                _subject(body),
                f"moves with {mass:.4g} kg but without an inertia tensor",
                heavy[0][1].place("inertia"),
                value=0.0,
                unit="kg m²",
            )


def _shape_without_mass(s: RuleSubject) -> Iterator[Finding]:
    for body in s.robot.links:
        solid = any(shape.kind == "collision" for shape in body.shapes)
        if all(link.inertial is None for link in s.robot.links):
            return
        if not solid or body.name not in s.moving:
            continue
        if body.inertial is None or (body.inertial.readable and body.inertial.mass == 0.0):
            what = "no <inertial>" if body.inertial is None else "mass 0"
            place = body.place if body.inertial is None else body.inertial.place("mass")
            yield finding_of(
                "INE107", _subject(body), f"has a collision shape but {what}", place, value=0.0,
                unit="kg", severity="note" if body.inertial is None else None,
            )  # fmt: skip


# --- possible for a body of this size ------------------------------------------------------------


def _directions(inertia: Inertia, body: RobotLink) -> Array:
    """Where the bound is tried: the link's axes, its shapes' axes, the principal axes."""
    _, principal = np.linalg.eigh(inertia.tensor)
    frames = [np.eye(3), principal.T, *(shape.pose.R.T for shape in body.shapes)]
    return np.concatenate(frames)


def _beyond_shape(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        extent = s.extent(body.name) if _sound(inertial) else None
        if extent is None:
            continue
        inertia = inertial.inertia
        directions = _directions(inertia, body)
        low, high = extent.along(directions)
        along = directions @ inertia.com
        # A centre outside the shape has a rule of its own; here it is brought to the surface.
        along = np.clip(along, low, high)
        allowed = (along - low + SHAPE_MARGIN) * (high - along + SHAPE_MARGIN)
        squares = spreads(inertia, directions)
        ratio = squares / allowed
        worst = int(ratio.argmax())
        if ratio[worst] > 1.0:
            yield finding_of(
                "INE108",
                _subject(body),
                f"mass spreads {_metres(np.sqrt(squares[worst]))} along "
                f"{_axis(directions[worst])}, {np.sqrt(ratio[worst]):.2g} times what its shape "
                f"allows ({_metres(np.sqrt(allowed[worst]))})" + _unit_hint(s, body, inertial),
                inertial.place("inertia"),
                value=float(np.sqrt(squares[worst])),
                bound=float(np.sqrt(allowed[worst])),
                unit="m",
                severity=size_severity(s, body, inertial, bool(ratio[worst] > _FAR_BEYOND)),
            )


def _beyond_length(s: RuleSubject) -> Iterator[Finding]:
    """Where no shape says how large the link is: its length, and the robot's reach."""
    for body, inertial in s.bodies:
        if not _sound(inertial) or s.extent(body.name) is not None:
            continue
        spread, direction = _largest_spread(inertial.inertia)
        length = s.length(body.name)
        if spread <= _WIDE * length:
            continue
        grave = spread > _IMPOSSIBLE * length and spread > 0.5 * s.reach
        yield finding_of(
            "INE109",
            _subject(body),
            f"mass spreads {_metres(spread)} along {_axis(direction)} in a link of "
            f"{_metres(length)}" + _unit_hint(s, body, inertial),
            inertial.place("inertia"),
            value=spread,
            bound=_WIDE * length,
            unit="m",
            severity=size_severity(s, body, inertial, grave),
        )


def _like_a_point(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        if not _sound(inertial) or inertial.mass < 0.01:
            continue
        spread, _ = _largest_spread(inertial.inertia)
        extent = s.extent(body.name)
        length = s.length(body.name) if extent is None else extent.diameter
        if spread < _POINT * length:
            yield finding_of(
                "INE110",
                _subject(body),
                f"mass spreads only {_metres(spread)} in a link of {_metres(length)}, as if all of "
                "it lay in one point" + _unit_hint(s, body, inertial),
                inertial.place("inertia"),
                value=spread,
                bound=_POINT * length,
                unit="m",
            )


def _unit_hint(s: RuleSubject, body: RobotLink, inertial: Inertial) -> str:
    """The units that would make the spread plausible, if some do."""
    spread, _ = _largest_spread(inertial.inertia)
    length = s.length(body.name)
    low, high = (part * length for part in _PLAUSIBLE_SPREAD)
    found = [name for factor, name in _TENSOR_UNITS if low <= spread / np.sqrt(factor) <= high]
    if found:
        return f"; as if the tensor were in {' or '.join(found[:3])}"
    if low <= spread / np.sqrt(1e-3) <= high:
        return "; as if the mass were in g, or the tensor a thousandth"
    return ""


def _density(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        if inertial.mass <= 0.0:
            continue
        extent = s.extent(body.name)
        if extent is not None and extent.most_volume > 0.0:
            volume, of = extent.most_volume, "its shape"
        else:
            # A ball around the link: what no link fills, let alone with metal.
            radius = s.length(body.name) / 2.0 + 0.05
            volume, of = float(4.0 / 3.0 * np.pi * radius**3), "a ball as long as the link"
        density = inertial.mass / volume
        light = extent is not None and density < _LIGHT and inertial.mass > 0.01
        if density <= DENSE and not light:
            continue
        bound = DENSE if density > DENSE else _LIGHT
        comparison = "denser than copper" if density > DENSE else "lighter than foam"
        yield finding_of(
            "INE111",
            _subject(body),
            f"{inertial.mass:.4g} kg in the {1e3 * volume:.3g} litres of {of}: "
            f"{density:,.3g} kg/m³, {comparison}",
            inertial.place("mass"),
            value=density,
            bound=bound,
            unit="kg/m³",
            severity=size_severity(s, body, inertial, density > IMPOSSIBLY_DENSE),
        )


def _far_centre(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        if inertial.mass <= 0.0 or s.extent(body.name) is not None:
            continue
        distance = float(np.linalg.norm(inertial.xyz))
        length = s.length(body.name)
        if distance <= 1.5 * length + 0.1:
            continue
        grave = distance > 3.0 * length and distance > s.reach
        yield finding_of(
            "INE112",
            _subject(body),
            f"the centre of mass lies {_metres(distance)} from the joint of a link of "
            f"{_metres(length)}",
            inertial.place("origin"),
            value=distance,
            bound=1.5 * length + 0.1,
            unit="m",
            severity=size_severity(s, body, inertial, grave),
        )


# --- numbers that were not measured --------------------------------------------------------------


def _placeholder(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        if not inertial.own_tensor.any() or inertial.mass <= 0.0:
            continue
        e = inertial.entries
        diagonal = {e["ixx"], e["iyy"], e["izz"]}
        products = {e["ixy"], e["ixz"], e["iyz"]}
        value = e["ixx"]
        if len(diagonal) > 1:
            continue
        round_number = (
            value > 0.0
            and f"{value:.0e}".startswith(("1e", "5e"))
            and (abs(value - float(f"{value:.0e}")) < 1e-12 * value)
        )
        if products == diagonal:
            what = f"all six entries are {value:g}"
        elif products == {0.0} and round_number and _not_a_sphere(s, body, inertial):
            what = f"all three moments are {value:g} kg m²"
        else:
            continue
        yield finding_of(
            "INE113",
            _subject(body),
            f"{what}: a placeholder, not a measured tensor",
            inertial.place("inertia"),
            value=value,
            unit="kg m²",
        )


def _not_a_sphere(s: RuleSubject, body: RobotLink, inertial: Inertial) -> bool:
    """Whether a ball of that tensor has a size that the link has not."""
    spread, _ = _largest_spread(inertial.inertia)
    extent = s.extent(body.name)
    length = s.length(body.name) if extent is None else extent.diameter
    # σ of a ball is its radius over √5, 0.22 of its diameter.
    return not 0.1 * length <= spread <= 0.35 * length


def _across(s: RuleSubject) -> Iterator[Finding]:
    """A slender tensor that lies across the way to the next joint."""
    for body, inertial in s.bodies:
        ways = [one.origin.p for one in s.robot.below[body.name] if np.any(one.origin.p)]
        if not _sound(inertial) or len(ways) != 1:
            continue
        length = float(np.linalg.norm(ways[0]))
        if length < max(_SMALLEST_WAY, 0.5 * s.length(body.name)):
            continue
        moments, axes = np.linalg.eigh(inertial.inertia.tensor)
        if not moments[0] < _SLENDER * moments[1]:
            continue
        angle = float(np.arccos(min(1.0, abs(float(axes[:, 0] @ ways[0])) / length)))
        extent = s.extent(body.name)
        if angle <= _ACROSS or (
            extent is not None and not _longest_along(extent, ways[0] / length)
        ):
            continue
        yield finding_of(
            "INE114",
            _subject(body),
            f"its slender tensor lies {np.degrees(angle):.0f}° across the {_metres(length)} to the "
            "next joint, as if axes were exchanged or the tensor not rotated into this frame",
            inertial.place("inertia"),
            value=angle,
            bound=_ACROSS,
            unit="rad",
        )


_SMALLEST_WAY = 0.1


def _longest_along(extent: Extent, direction: Array) -> bool:
    """Whether the shape is longest about along a direction."""
    helper = np.eye(3)[int(np.abs(direction).argmin())]
    second = np.cross(direction, helper)
    second /= np.linalg.norm(second)
    low, high = extent.along(np.array([direction, second, np.cross(direction, second)]))
    lengths = high - low
    return bool(lengths[0] > 1.5 * lengths[1:].max())


def _heavier_than_neighbours(s: RuleSubject) -> Iterator[Finding]:
    masses = {body.name: inertial.mass for body, inertial in s.bodies if inertial.mass > 0.05}
    for body, inertial in s.bodies:
        if body.name not in masses or body.name not in s.moving:
            continue
        above = s.robot.above[body.name].parent
        near = [above, *(one.child for one in s.robot.below[body.name])]
        weights = [masses[name] for name in near if name in masses]
        if weights and masses[body.name] > _HEAVIER * max(weights):
            ratio = masses[body.name] / max(weights)
            yield finding_of(
                "INE115",
                _subject(body),
                f"weighs {inertial.mass:.4g} kg, {ratio:.3g} times the heavier of its neighbours",
                inertial.place("mass"),
                value=ratio,
                bound=_HEAVIER,
            )


def _metres(length: float) -> str:
    return f"{length:.3g} m" if length >= 0.1 else f"{1e3 * length:.3g} mm"


def _three(values: Array) -> str:
    return ", ".join(f"{value:.4g}" for value in values)


def _percent(part: float) -> str:
    return f"{part:.2%}" if part >= 1e-4 else f"{100 * part:.1g} %"


def _axis(u: Array) -> str:
    k = int(np.abs(u).argmax())
    if abs(u[k]) > 0.999:
        return "xyz"[k]
    return f"({', '.join(f'{x:.2f}' for x in u)})"


_GOOD = robot()
_BOX = (
    '<collision><origin xyz="0 0 0.1"/><geometry><box size="0.1 0.1 0.25"/></geometry></collision>'
)
_NONE = (
    '<inertial><mass value="0"/>'
    '<inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial>'
)
_FAR = (
    '<inertial><origin xyz="0 20 310"/><mass value="2"/>'
    '<inertia ixx="0.008" ixy="0" ixz="0" iyy="0.008" iyz="0" izz="0.002"/></inertial>'
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
        "INE108", "inertia-beyond-shape", "error",
        "mass does not spread further than the link's own shape allows: σ² ≤ (c − low)(high − c)",
        "A body inside its shape with its centre there cannot be harder to turn.",
        "accelerations are too small, controllers that use the model push too hard",
        bad=robot(joint(), link(ixx="0.5", iyy="0.5", shapes=_BOX)),
        good=robot(joint(), link(shapes=_BOX)),
        fix="compare unit and frame of the tensor with the CAD export, and the shape with the part",
        report="Wensing, Kim & Slotine 2018",
        check=_beyond_shape,
    ),
    Rule(
        "INE109", "inertia-beyond-length", "error",
        "without a shape: mass does not spread beyond the link's length, nor the robot's reach",
        "Tensors in g mm² or of a placeholder give a hand the inertia of a building.",
        "accelerations are far too small; simulation hardly moves",
        bad=robot(joint(), link(ixx="80", iyy="80", izz="80")), good=_GOOD,
        fix="give the tensor in kg m², about the centre of mass",
        check=_beyond_length,
    ),
    Rule(
        "INE110", "inertia-of-a-point", "warning",
        "mass does not lie in one point of the link",
        "A tensor in a larger unit than meant, or of a much lighter part, is as good as none.",
        "the link turns almost freely: simulation gets stiff, small steps are needed",
        bad=robot(joint(), link(ixx="1e-7", iyy="1e-7", izz="1e-7")), good=_GOOD,
        fix="give the tensor in kg m², about the centre of mass",
        check=_like_a_point,
    ),
    Rule(
        "INE111", "density", "error",
        "mass and size of a link go together",
        "Masses in grams, or of the whole robot in one link, show as density.",
        "gravity torques are wrong by the same factor",
        bad=robot(joint(), link(mass="2000", shapes=_BOX)),
        good=robot(joint(), link(shapes=_BOX)),
        fix="give the mass in kilograms, of this part",
        check=_density,
    ),
    Rule(
        "INE112", "far-centre", "error",
        "without a shape: the centre of mass lies near the link",
        "Centres in millimetres lie hundreds of metres away.",
        "gravity torques are wrong by the same factor",
        bad=robot(joint(), link(inertial=_FAR)),
        good=_GOOD,
        fix="give the centre in metres, in the link's frame",
        check=_far_centre,
    ),
    Rule(
        "INE113", "placeholder-tensor", "warning",
        "the tensor is not a placeholder",
        "1, 1, 1 or six equal entries are what tutorials write until somebody measures.",
        "torques in motion are those of another body",
        bad=robot(joint(), link(ixx="1", iyy="1", izz="1")), good=_GOOD,
        fix="compute it from the part, or from a box of its size",
        check=_placeholder,
    ),
    Rule(
        "INE114", "tensor-across", "warning",
        "a slender link's small moment lies along it",
        "Entries in another order, or a tensor in the axes of another frame, lie across.",
        "torques in motion are wrong: the long axis is the easy one",
        bad=robot(joint(), link(ixx="0.02", iyy="0.002", izz="0.02", mass="2"), _WAY, _TIP),
        good=robot(joint(), link(ixx="0.02", iyy="0.02", izz="0.002"), _WAY, _TIP),
        fix="check the order of the entries and the frame they are written in (rpy of <origin>)",
        check=_across,
    ),
    Rule(
        "INE115", "heavier-than-neighbours", "warning",
        "a moving link does not outweigh all its neighbours many times",
        "A mass in another unit stands out against those beside it.",
        "gravity torques of all joints before it are wrong",
        bad=robot(joint(), link(), _WAY, link("tip", mass="90")),
        good=robot(joint(), link(), _WAY, _TIP),
        fix="check the unit of the mass",
        check=_heavier_than_neighbours,
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
)  # fmt: skip
