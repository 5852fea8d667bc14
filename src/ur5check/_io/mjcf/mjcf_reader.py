"""A MuJoCo model's text (MJCF) to a `SerialArm`, through MuJoCo's own parser and compiler.

Read are bodies, joints, inertials, gravity, defaults, the actuators' ranges, and couplings between
joints. Omitted is what no
torque of a rigid arm depends on: sensors, contacts, keyframes, textures, and the shapes of every
body whose mass the file states. A mesh is opened only where MuJoCo computes a body's mass from it;
a note records this, and the file's hash is kept.
"""

from __future__ import annotations

import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from ..._errors import ModelError
from ..._robot import SerialArm, Source, Transform
from ..._robot.transforms import Array
from ..chain_assembly import assemble
from ..model_format import ModelFile
from ..world_body import chain_from_world
from .mjcf_bodies import WORLD, Bodies, name_all
from .mjcf_coupling import Motor, couplings, motors, refuse_couplings
from .mjcf_text import MjcfText

__all__ = ["read_mjcf", "read_mjcf_file"]

# Sections without effect on the dynamics; errors in them are ignored.
_LEFT_OUT = (
    "sensors", "keys", "pairs", "excludes", "skins", "hfields", "textures", "cameras", "lights",
    "numerics", "texts", "tuples", "actuators", "equalities", "tendons",
)  # fmt: skip


def read_mjcf_file(file: ModelFile) -> SerialArm:
    """The arm in an MJCF.  Raises ModelError as `read_mjcf` does."""
    return read_mjcf(
        file.data, file=file.label, folder=file.path.parent, base=file.base, tip=file.tip
    )


def read_mjcf(
    data: bytes, *, file: str, folder: Path, base: str | None = None, tip: str | None = None
) -> SerialArm:
    """The arm between two bodies of an MJCF model.

    data : the file's bytes;  file : what errors and reports call it
    folder : where its included files and meshes are
    base : body to start from (default: the body that stands in the world and carries the arm)
    tip : body or site to end at (default: the end of the only chain of moving joints)

    Raises ModelError for a faulty file, for what is not part of a serial arm of rigid bodies (a
    ball, a
    free body, a spring, a constraint or tendon across the arm), and where MuJoCo refuses.
    """
    mujoco = _mujoco(file)
    text = MjcfText(data, file=file, folder=folder)
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            spec = mujoco.MjSpec.from_string(text.text)
        except ValueError as error:
            raise text.warnings_of_mujoco(error) from None
        name_all(spec)
        motor, tied = motors(spec), couplings(spec, text)
        model = _compiled(spec, text)
    efforts = {name: m.effort for name, m in motor.items() if m.effort is not None}
    sites = [name for name in (base, tip) if name is not None and spec.body(name) is None]
    bodies = Bodies(spec, model, text, sites=sites, efforts=efforts)
    chain = chain_from_world(bodies.tree, base, tip)
    refuse_couplings(tied, bodies, chain)
    parts = assemble(bodies, chain)
    notes = parts.notes + tuple(f"MuJoCo says: {warning.message}" for warning in said)
    if bodies.weighed:
        shown = ", ".join(map(repr, dict.fromkeys(bodies.weighed)))
        notes += (f"mass and inertia made by MuJoCo's compiler, not written in the file: {shown}",)
    return SerialArm(
        spec.modelname or "model",
        tuple(_with_motor(joint, motor[joint.name]) for joint in parts.joints),
        parts.links,
        base=parts.base,
        gravity=_gravity(mujoco, model, bodies, chain.base, text),
        source=Source("mjcf", text.inputs, base=chain.base, tip=chain.tip, notes=notes),
    )


def _mujoco(file: str) -> Any:
    try:
        import mujoco
    except ImportError:
        raise ModelError(
            "MJCF is read through MuJoCo, which is not installed here",
            fix="pip install 'ur5check[mujoco]'",
            file=file,
        ) from None
    return mujoco


def _compiled(spec: Any, text: MjcfText) -> Any:
    """The model without the sections ignored here, its meshes passed as bytes."""
    by_shape = spec.compiler.inertiafromgeom.name == "mjINERTIAFROMGEOM_TRUE"
    for geom in list(spec.geoms):
        unweighed = geom.mass == 0.0 or (np.isnan(geom.mass) and geom.density == 0.0)
        stated = geom.parent.explicitinertial and not by_shape
        if geom.parent.name == WORLD or unweighed or stated:
            spec.delete(geom)
        else:
            geom.material = ""
    for section in _LEFT_OUT:
        for element in list(getattr(spec, section)):
            spec.delete(element)
    needed = {geom.meshname: geom.parent.name for geom in spec.geoms if geom.meshname}
    assets = {}
    for mesh in list(spec.meshes):
        name = mesh.name or Path(mesh.file).stem
        if name not in needed:
            spec.delete(mesh)
        elif mesh.file:
            path = str(Path(spec.compiler.meshdir or "") / mesh.file)
            assets[mesh.file] = text.bytes_of(path, f"body {needed[name]!r} (has no <inertial>)")
    for site in spec.sites:
        site.material = ""
    for material in list(spec.materials):
        spec.delete(material)
    spec.assets = assets
    spec.compiler.fusestatic = False
    try:
        return spec.compile()
    except ValueError as error:
        raise text.warnings_of_mujoco(error) from None


def _with_motor(joint: Any, motor: Motor) -> Any:
    return replace(
        joint, armature=joint.armature + motor.armature, damping=joint.damping + motor.damping
    )


def _gravity(mujoco: Any, model: Any, bodies: Bodies, base: str, text: MjcfText) -> Array:
    """Gravity in the base body's frame [m/s²], in the posture that the file describes."""
    option = model.opt
    if option.density or option.viscosity or option.wind.any():
        raise ModelError(
            "density, viscosity or wind is set: the arm moves in a fluid",
            fix="remove them: drag is no rigid body's",
            file=text.file,
            element="<option>",
        )
    if option.disableflags & mujoco.mjtDisableBit.mjDSBL_GRAVITY:
        return np.zeros(3)
    pose, link = Transform.identity(), base
    while link in bodies.tree.above:
        edge = bodies.tree.above[link]
        pose, link = bodies.held_pose(edge, frozenset()) @ pose, edge.parent
    return np.asarray(pose.inverse().R @ np.array(option.gravity))
