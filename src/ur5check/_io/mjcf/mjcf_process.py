"""The process in which MuJoCo compiles a model: a request on stdin, an answer on stdout, both JSON.

Numbers are taken from the file where it states them, since MuJoCo's compiler keeps tensors only as
principal moments; and from the compiler where it computes them (angles other than quaternions,
`<frame>`s, masses from shapes, `settotalmass` and its kin).

Sections without effect on the dynamics are left out, errors in them too.  A mesh is opened only
where MuJoCo computes a body's mass from it.
"""

from __future__ import annotations

import hashlib
import json
import os
import sys
import warnings
from pathlib import Path
from typing import Any

from ..._files import read_regular
from ..bounded_process import limit_resources

__all__ = ["main"]

_LEFT_OUT = (
    "sensors", "keys", "pairs", "excludes", "skins", "hfields", "textures", "cameras", "lights",
    "numerics", "texts", "tuples", "actuators", "equalities", "tendons",
)  # fmt: skip
_WORLD = "world"
_SHAPES = {"mjGEOM_BOX": "box", "mjGEOM_SPHERE": "sphere", "mjGEOM_CYLINDER": "cylinder",
           "mjGEOM_CAPSULE": "capsule", "mjGEOM_MESH": "mesh"}  # fmt: skip
_KINDS = {"mjJNT_HINGE": "revolute", "mjJNT_SLIDE": "prismatic", "mjJNT_BALL": "ball",
          "mjJNT_FREE": "free"}  # fmt: skip
#: MuJoCo's own least length of an axis.
_LEAST_AXIS = 1e-14


def main() -> None:
    """Answer one request: {"text", "folder", "sites", limits}."""
    os.environ["MUJOCO_GL"] = "disable"  # or it looks for a window system when it is imported
    answer_file = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what MuJoCo prints is no part of the answer
    request = json.loads(sys.stdin.buffer.read())
    limit_resources(
        seconds=request["seconds"],
        memory=request["memory_bytes"],
        file_size=request["output_bytes"],
    )
    try:
        answer = _compiled(request)
    except Exception as error:  # noqa: BLE001 - whatever it is, the answer must say it
        answer = {"refused": f"{type(error).__name__} in MuJoCo: {error}"}
    with os.fdopen(answer_file, "wb") as file:
        file.write(json.dumps(answer).encode())


def _compiled(request: dict[str, Any]) -> dict[str, Any]:
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            spec, answer = _parsed(request)
        except ValueError as error:
            return {"refused": str(error)}
        try:
            model = spec.compile()
        except ValueError as error:
            spec, answer = _parsed(request)  # the first one answers with its error from now on
            answer["refused"] = str(error)
            answer["axes"] = _make_acceptable(spec)
            try:
                model = spec.compile()
            except ValueError:
                return {"refused": str(error)}
    return answer | _described(spec, model, request["sites"], said)


def _parsed(request: dict[str, Any]) -> tuple[Any, dict[str, Any]]:
    """MuJoCo's reading of the text, and what only it tells, not the compiled model."""
    import mujoco

    from .mjcf_coupling import couplings, motors

    spec = mujoco.MjSpec.from_string(request["text"])
    _name_all(spec)
    found = {"motors": motors(spec), "couplings": couplings(spec)}
    return spec, found | _prepare(spec, Path(request["folder"]))


def _described(spec: Any, model: Any, sites: list[str], said: list[Any]) -> dict[str, Any]:
    import mujoco

    option = model.opt
    on = not option.disableflags & mujoco.mjtDisableBit.mjDSBL_GRAVITY
    return {
        "name": spec.modelname,
        "said": list(dict.fromkeys(str(warning.message) for warning in said)),
        "gravity": [float(g) if on else 0.0 for g in option.gravity],
        "fluid": bool(option.density or option.viscosity or option.wind.any()),
        "bodies": [_body(spec, model, body) for body in spec.bodies if body.name != _WORLD],
        "sites": [_site(model, site) for site in spec.sites if site.name in sites],
    }


def _name_all(spec: Any) -> None:
    """Give a name to everything that has none; MJCF does not require names."""
    for kind, elements in (
        ("body", spec.bodies),
        ("joint", spec.joints),
        ("geom", spec.geoms),
    ):
        taken = {element.name for element in elements}
        for number, element in enumerate(elements):
            name = f"{kind}_{number}"
            while not element.name:
                element.name = "" if name in taken else name
                name += "_"


def _changed(compiler: Any) -> bool:
    """Whether a compiler option changes the masses of the file."""
    return (
        compiler.inertiafromgeom.name == "mjINERTIAFROMGEOM_TRUE"
        or compiler.settotalmass > 0.0
        or compiler.boundmass > 0.0
        or compiler.boundinertia > 0.0
        or bool(compiler.balanceinertia)
    )


def _prepare(spec: Any, folder: Path) -> dict[str, Any]:
    """Leave out what has no effect, and have the meshes that weigh at hand, as bytes."""
    import mujoco
    import numpy as np

    by_shape = spec.compiler.inertiafromgeom.name == "mjINERTIAFROMGEOM_TRUE"
    files = {mesh.name or Path(mesh.file).stem: mesh for mesh in spec.meshes}
    assets: dict[str, bytes] = {}
    inputs, lost, shapes = [], [], {}
    for geom in list(spec.geoms):
        body = geom.parent
        unweighed = geom.mass == 0.0 or (np.isnan(geom.mass) and geom.density == 0.0)
        if body.name == _WORLD:
            spec.delete(geom)
            continue
        geom.material = ""
        shapes[geom.name] = _mesh_of(geom, files, spec.compiler.meshdir or "")
        if not geom.meshname:
            continue
        if not unweighed and (by_shape or not body.explicitinertial):
            mesh = files.get(geom.meshname)
            name = "" if mesh is None else mesh.file
            if not name or name in assets:
                continue
            path = str(Path(spec.compiler.meshdir or "") / name)
            try:
                assets[name] = read_regular(folder / path)
                inputs.append((path, hashlib.sha256(assets[name]).hexdigest()))
                continue
            except OSError as error:
                lost.append((body.name, geom.info, path, error.strerror))
        # The mesh is not needed: a mass-free sphere keeps the place where it is shown.
        geom.type, geom.meshname, geom.mass = mujoco.mjtGeom.mjGEOM_SPHERE, "", 0.0
        geom.size = [1e-3, 0.0, 0.0]
    needed = {geom.meshname for geom in spec.geoms if geom.meshname}
    for name, mesh in files.items():
        if name not in needed:
            spec.delete(mesh)
    for section in _LEFT_OUT:
        for element in list(getattr(spec, section)):
            spec.delete(element)
    for site in spec.sites:
        site.material = ""
    for material in list(spec.materials):
        spec.delete(material)
    spec.assets = assets
    spec.compiler.fusestatic = False
    spec.compiler.discardvisual = False
    return {"inputs": inputs, "lost": lost, "shapes": shapes}


def _mesh_of(geom: Any, files: dict[str, Any], folder: str) -> dict[str, Any] | None:
    """Kind, use and mesh of a shape; None for what is no shape of this kind."""
    kind = _SHAPES.get(geom.type.name)
    if kind is None or (geom.meshname and kind != "mesh"):
        return None
    found = {"geometry": kind, "visual": geom.contype == 0 and geom.conaffinity == 0}
    if kind == "mesh":
        mesh = files.get(geom.meshname)
        moved = mesh is not None and (mesh.refpos.any() or mesh.refquat[1:].any())
        if mesh is None or not mesh.file or moved:
            return None
        found |= {"uri": str(Path(folder) / mesh.file), "scale": list(map(float, mesh.scale))}
    return found


def _make_acceptable(spec: Any) -> dict[str, list[float]]:
    """Masses, tensors and axes that MuJoCo takes: what the file states is judged elsewhere.

    Returns the axes that are none, by joint.
    """
    import numpy as np

    for body in spec.bodies:
        if body.name == _WORLD or (
            not body.explicitinertial and any(_weighs(g) for g in body.geoms)
        ):
            continue
        if not body.explicitinertial:
            body.explicitinertial, body.ipos = True, [0.0, 0.0, 0.0]
        body.mass, body.inertia = 1.0, [1.0, 1.0, 1.0]
        body.fullinertia = [np.nan] * 6
    axes = {}
    for joint in spec.joints:
        if not np.linalg.norm(joint.axis) > _LEAST_AXIS:
            axes[joint.name] = _list(joint.axis)
            joint.axis = [0.0, 0.0, 1.0]
    return axes


def _weighs(geom: Any) -> bool:
    import numpy as np

    return bool(geom.mass > 0.0 or (np.isnan(geom.mass) and geom.density > 0.0))


def _body(spec: Any, model: Any, body: Any) -> dict[str, Any]:
    index = model.body(body.name).id
    explicit = bool(body.explicitinertial) and not _changed(spec.compiler)
    plain = body.frame is None and body.alt.type.name == "mjORIENTATION_QUAT"
    turned = body.ialt.type.name != "mjORIENTATION_QUAT"
    weighed = not explicit and float(model.body_mass[index]) > 0.0
    return {
        "name": body.name,
        "line": body.info,
        "parent": body.parent.name,
        "pos": _list(body.pos if plain else model.body_pos[index]),
        "quat": _list(body.quat if plain else model.body_quat[index]),
        "gravcomp": float(body.gravcomp),
        "explicit": explicit,
        "turn": _list(model.body_iquat[index] if turned else body.iquat) if explicit else None,
        "weighed": {
            "mass": float(model.body_mass[index]),
            "pos": _list(model.body_ipos[index]),
            "quat": _list(model.body_iquat[index]),
            "moments": _list(model.body_inertia[index]),
        } if weighed else None,
        "joints": [_joint(spec, model, joint) for joint in body.joints],
        "geoms": [_geom(model, geom) for geom in body.geoms],
    }  # fmt: skip


def _joint(spec: Any, model: Any, joint: Any) -> dict[str, Any]:
    index = model.joint(joint.name).id
    kind = _KINDS[joint.type.name]
    dof, qpos = int(model.jnt_dofadr[index]), int(model.jnt_qposadr[index])
    plain = joint.frame is None
    limits = _list(model.jnt_range[index]) if model.jnt_limited[index] else None
    lower, upper = map(float, joint.range)
    if lower > upper and joint.limited.name != "mjLIMITED_FALSE":
        # MuJoCo ignores such a range without a word.
        unit = 3.141592653589793 / 180.0 if kind == "revolute" and spec.compiler.degree else 1.0
        limits = [lower * unit, upper * unit]
    return {
        "name": joint.name,
        "line": joint.info,
        "kind": kind,
        "axis": _list(joint.axis if plain else model.jnt_axis[index]),
        "anchor": _list(joint.pos if plain else model.jnt_pos[index]),
        "ref": float(model.qpos0[qpos]) if kind in ("revolute", "prismatic") else 0.0,
        "range": limits,
        "armature": float(model.dof_armature[dof]),
        "damping": float(model.dof_damping[dof]),
        "friction": float(model.dof_frictionloss[dof]),
        "spring": bool(model.jnt_stiffness[index] != 0.0),
    }


def _geom(model: Any, geom: Any) -> dict[str, Any]:
    index = model.geom(geom.name).id
    mesh = int(model.geom_dataid[index])
    return {
        "name": geom.name,
        "line": geom.info,
        "size": _list(model.geom_size[index]),
        "pos": _list(model.geom_pos[index]),
        "quat": _list(model.geom_quat[index]),
        # MuJoCo moves a mesh to its centre of mass and principal axes.
        "moved": None if mesh < 0 else [_list(model.mesh_pos[mesh]), _list(model.mesh_quat[mesh])],
    }


def _site(model: Any, site: Any) -> dict[str, Any]:
    index = model.site(site.name).id
    plain = site.frame is None and site.alt.type.name == "mjORIENTATION_QUAT"
    return {
        "name": site.name,
        "line": site.info,
        "parent": site.parent.name,
        "pos": _list(site.pos if plain else model.site_pos[index]),
        "quat": _list(site.quat if plain else model.site_quat[index]),
    }


def _list(values: Any) -> list[float]:
    return [float(value) for value in values]
