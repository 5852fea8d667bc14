"""GEO: shapes, and centres of mass against them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._finding import Finding
from .body_extent import MeshBody
from .examples import joint, link, robot
from .finding_log import finding_of
from .inertia_measures import size_severity
from .rule import Rule
from .rule_subject import RuleSubject

__all__ = ["RULES"]

#: How far outside its shape a centre may lie: covers, screws, coarse shapes [m].
_MARGIN = 0.01
#: A mesh this many times longer than the robot's reach is in another unit.
_OTHER_UNIT = 20.0


def _centre_outside(s: RuleSubject) -> Iterator[Finding]:
    for body, inertial in s.bodies:
        extent = s.extent(body.name) if inertial.mass > 0.0 else None
        if extent is None:
            continue
        directions = np.concatenate(
            [np.eye(3), *(shape.pose.R.T for shape in body.shapes), _DIAGONALS]
        )
        low, high = extent.along(directions)
        along = directions @ inertial.xyz
        outside = np.maximum(low - along, along - high)
        worst = int(outside.argmax())
        if outside[worst] <= _MARGIN:
            continue
        size = float((high - low).max())
        grave = outside[worst] > 0.5 * size + 0.05
        at = ", ".join(f"{x:.4g}" for x in inertial.xyz)
        yield finding_of(
            "GEO101",
            f"link {body.name!r}",
            f"the centre of mass ({at}) m lies {_length(outside[worst])} outside its shape of "
            f"{_length(size)}",
            inertial.place("origin"),
            value=float(outside[worst]),
            bound=_MARGIN,
            unit="m",
            severity=size_severity(s, body, inertial, bool(grave)),
        )


_DIAGONALS = np.array(
    [[1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]]
) / np.sqrt(2.0)


def _missing_mesh(s: RuleSubject) -> Iterator[Finding]:
    for body in s.robot.links:
        s.extent(body.name)
    missing = [f for f in s.mesh_findings if f.rule == "GEO102"]
    yield from (f for f in s.mesh_findings if f.rule != "GEO102")
    if missing:
        names = [str(f.value) for f in missing]
        shown = ", ".join(dict.fromkeys(names[:3])) + (", …" if len(set(names)) > 3 else "")
        yield finding_of(
            "GEO102",
            "robot",
            f"{len(set(names))} meshes are not found ({shown}): links are judged by their lengths",
            *(f.place for f in missing[:3]),
            value=len(set(names)),
            bound=0,
            fix=missing[0].fix,
        )


def _mesh_scale(s: RuleSubject) -> Iterator[Finding]:
    for body in s.robot.links:
        mirrored = [x for x in body.shapes if x.geometry == "mesh" and np.prod(x.size) < 0.0]
        for shape in mirrored[:1]:
            yield finding_of(
                "GEO105",
                f"link {body.name!r}",
                f"a mesh is mirrored by its scale {_three(shape.size)}",
                shape.place,
                value=float(np.prod(shape.size)),
                bound=0.0,
            )
        extent = s.extent(body.name)
        for part in () if extent is None else extent.bodies:
            if not isinstance(part, MeshBody) or s.reach < 0.05:
                continue
            size = float(np.ptp(part.points, axis=0).max())
            if size > _OTHER_UNIT * s.reach:
                yield finding_of(
                    "GEO104",
                    f"link {body.name!r}",
                    f"its mesh is {size:.4g} m long in a robot that reaches {s.reach:.3g} m",
                    part.shape.place,
                    value=size,
                    bound=_OTHER_UNIT * s.reach,
                    unit="m",
                )
                break


def _length(value: float) -> str:
    return f"{value:.3g} m" if value >= 0.1 else f"{1e3 * value:.3g} mm"


def _three(values: tuple[float, ...]) -> str:
    return "(" + ", ".join(f"{value:g}" for value in values) + ")"


_BOX = (
    '<collision><origin xyz="0 0 {z}"/><geometry><box size="0.1 0.1 0.25"/></geometry></collision>'
)
_MESH = '<visual><geometry><mesh filename="{file}"{scale}/></geometry></visual>'
_NEAR = robot(joint(), link(shapes=_BOX.format(z=0.1)))

RULES = (
    Rule(
        "GEO101", "centre-outside-shape", "error",
        "the centre of mass lies inside the link's shape",
        "The centre of a body lies in its convex hull.",
        "gravity torques are those of another body",
        bad=robot(joint(), link(shapes=_BOX.format(z=1.5))), good=_NEAR,
        fix="check unit, sign and frame of the centre, and that the shape is this link's",
        check=_centre_outside,
    ),
    Rule(
        "GEO102", "mesh-not-found", "note",
        "meshes are there",
        "A link without its mesh can be judged by its length only.",
        "viewers show nothing; collision checks see nothing",
        bad=robot(joint(), link(shapes=_MESH.format(file="nowhere.stl", scale=""))), good=_NEAR,
        fix="give the package's folder: --package NAME=DIR",
        check=_missing_mesh,
    ),
    Rule(
        "GEO103", "mesh-unreadable", "warning",
        "meshes can be read",
        "A damaged or empty mesh shows nothing.",
        "viewers and simulators fail on it or leave it out",
        bad=robot(joint(), link(shapes=_MESH.format(file="arm.urdf", scale=""))), good=_NEAR,
        fix="export the mesh again",
    ),
    Rule(
        "GEO104", "mesh-unit", "error",
        "meshes are about as large as the robot",
        "Meshes in millimetres need scale=\"0.001 0.001 0.001\".",
        "collision shapes a thousand times too large block everything",
        bad="a mesh of 300 m in a robot that reaches 0.9 m", good="the same mesh with scale 0.001",
        fix="write scale=\"0.001 0.001 0.001\" on the <mesh>",
        check=_mesh_scale,
        example="words",
    ),
    Rule(
        "GEO105", "mesh-mirrored", "note",
        "no mesh is mirrored by a negative scale",
        "Mirrored meshes turn their surfaces inside out in some engines.",
        "MuJoCo and others compute volume or contact wrongly",
        bad=robot(joint(), link(shapes=_MESH.format(file="a.stl", scale=' scale="1 -1 1"'))),
        good=_NEAR,
        fix="export a mirrored mesh",
    ),
)  # fmt: skip
