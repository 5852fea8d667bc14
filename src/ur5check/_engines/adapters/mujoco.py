"""MuJoCo as reference engine: `mj_rne`, `mj_forward`, the mass matrix of `mj_crb`.

Contacts, limits, springs, damping and dry friction are switched off: what is compared, and what
integrated in `step`, is the rigid-body model.  `imported_model` reports what the model has of them.

MuJoCo merges fixed links into their parents and drops their frames, the tool's among them.  A site
is therefore added at the tool and at the base before compilation; their poses come from MuJoCo's
own kinematics.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, ClassVar

import numpy as np
from lxml import etree
from numpy.typing import ArrayLike

from ..._errors import EngineError
from ..._robot.inertia import Inertia
from ..._robot.robot_tree import ArmOrTree, tree_links
from ..._robot.serial_arm import Joint, Limits
from ..._robot.transforms import Array, Transform
from ..each_state import each_state
from ..engine_entry import EngineEntry
from ..engine_urdf import text_for_engines
from ..imported_model import ImportedBody, ImportedModel
from ..known_issue import KnownIssue
from ..lazy_import import lazy_import

__all__ = ["ENTRY", "MuJoCoEngine"]

mujoco = lazy_import("mujoco")

_BASE, _TOOL = "ur5check_base", "ur5check_tool"
#: What of `mjtDisableBit` is set, so that rigid bodies alone remain.
_DISABLED = ("CONSTRAINT", "CONTACT", "SPRING", "DAMPER", "ACTUATION")


class MuJoCoEngine:
    """MuJoCo's algorithms on one arm or robot; satisfies `engine.Stepper`.

    arm : an arm, or a tree without mimic joints;  gravity : in its base frame [m/s²], its own when
        None.

    Raises EngineError if MuJoCo refuses the model.
    """

    name = "MuJoCo"
    #: `euler` moves positions with the new velocities (semi-implicit)
    integrators: ClassVar[dict[str, int]] = {"euler": 1, "rk4": 4, "implicit": 1, "implicitfast": 1}

    def __init__(self, arm: ArmOrTree, gravity: ArrayLike | None = None) -> None:
        self.arm = arm
        self.route = "URDF text, own parser" if arm.source.urdf else type(arm).__name__
        self.version = str(mujoco.__version__)
        with _captured_warnings() as lines:
            self.model = _compiled(arm)
        self.warnings = tuple(lines)
        self.data = mujoco.MjData(self.model)
        self._joints = [self._joint_id(name) for name in arm.joint_names]
        self._q = self.model.jnt_qposadr[self._joints]
        self._v = self.model.jnt_dofadr[self._joints]
        for name in _DISABLED:
            self.model.opt.disableflags |= int(getattr(mujoco.mjtDisableBit, f"mjDSBL_{name}"))
        mujoco.mj_kinematics(self.model, self.data)
        self._T_base_world = self._site(_BASE).inverse()
        R = self._T_base_world.R
        self._gravity_read = R @ self.model.opt.gravity
        g = np.asarray(arm.gravity if gravity is None else gravity, dtype=np.float64)
        self.model.opt.gravity[:] = R.T @ g

    def forward_kinematics(self, q: Array) -> Array:
        """Pose of the tool in the base frame, from `mj_kinematics`."""

        def pose(x: Array) -> Array:
            self.data.qpos[self._q] = x
            mujoco.mj_kinematics(self.model, self.data)
            return (self._T_base_world @ self._site(_TOOL)).matrix()

        return each_state(pose, self.arm.n, (4, 4), q)

    def inverse_dynamics(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Torques from `mj_rne`, which leaves the motors' inertia out, and that."""

        def torque(x: Array, v: Array, a: Array) -> Array:
            self._place(x, v)
            self.data.qacc[self._v] = a
            motors: Array = self.model.dof_armature[self._v] * a
            return self._rne(1) + motors

        return self._each(torque, q, qd, qdd)

    def forward_dynamics(self, q: Array, qd: Array, tau: Array) -> Array:
        """Accelerations from `mj_forward`."""

        def acceleration(x: Array, v: Array, t: Array) -> Array:
            self.data.qpos[self._q], self.data.qvel[self._v] = x, v
            self.data.qfrc_applied[self._v] = t
            mujoco.mj_forward(self.model, self.data)
            return np.array(self.data.qacc[self._v])

        return self._each(acceleration, q, qd, tau)

    def mass_matrix(self, q: Array) -> Array:
        """M from `mj_crb`, motors' inertia included."""

        def crb(x: Array) -> Array:
            self._place(x, np.zeros(self.arm.n))
            M = np.zeros((self.model.nv, self.model.nv))
            mujoco.mj_fullM(self.model, self.data, M)
            return np.asarray(M[np.ix_(self._v, self._v)])

        return each_state(crb, self.arm.n, (self.arm.n, self.arm.n), q)

    def bias_torque(self, q: Array, qd: Array) -> Array:
        """C q̇ + g from `mj_rne` without acceleration."""

        def bias(x: Array, v: Array) -> Array:
            self._place(x, v)
            return self._rne(0)

        return self._each(bias, q, qd)

    def gravity_torque(self, q: Array) -> Array:
        """g: the bias at rest."""
        return self.bias_torque(q, np.zeros(self.arm.n))

    def step(
        self, q: Array, qd: Array, tau: Array, dt: float, integrator: str | None = None
    ) -> tuple[Array, Array]:
        """(q, q̇) after one `mj_step` of `dt` [s]."""
        kind = f"mjINT_{(integrator or 'euler').upper()}"
        self.model.opt.integrator = getattr(mujoco.mjtIntegrator, kind)
        self.model.opt.timestep = dt
        self.data.qpos[self._q], self.data.qvel[self._v] = q, qd
        self.data.qfrc_applied[self._v] = tau
        mujoco.mj_step(self.model, self.data)
        return np.array(self.data.qpos[self._q]), np.array(self.data.qvel[self._v])

    def imported_model(self) -> ImportedModel:
        """The compiled `MjModel`."""
        self._place(np.zeros(self.arm.n), np.zeros(self.arm.n))
        return ImportedModel(
            tuple(self._imported_joint(k) for k in range(self.model.njnt)),
            self.data.xanchor @ self._T_base_world.R.T + self._T_base_world.p,
            tuple(self._imported_body(b) for b in range(1, self.model.nbody)),
            self._gravity_read,
            (self._T_base_world @ self._site(_TOOL)).matrix(),
            int(self.model.nq),
            self.warnings,
        )

    def _imported_joint(self, k: int) -> Joint:
        model, v = self.model, int(self.model.jnt_dofadr[k])
        sliding = model.jnt_type[k] == mujoco.mjtJoint.mjJNT_SLIDE
        lower, upper = model.jnt_range[k] if model.jnt_limited[k] else (None, None)
        effort = model.jnt_actfrcrange[k][1] if model.jnt_actfrclimited[k] else None
        return Joint(
            model.joint(k).name,
            self._T_base_world.R @ self.data.xaxis[k],
            "prismatic" if sliding else "revolute",
            Limits(_number(lower), _number(upper), None, _number(effort)),
            float(model.dof_armature[v]),
            float(np.ravel(model.dof_damping[v])[0]),
            float(model.dof_frictionloss[v]),
        )

    def _imported_body(self, b: int) -> ImportedBody:
        R = self.data.ximat[b].reshape(3, 3)
        tensor = R @ np.diag(self.model.body_inertia[b]) @ R.T
        inertia = Inertia(self.model.body_mass[b], self.data.xipos[b], tensor)
        return ImportedBody(
            self.model.body(b).name,
            self._carrier(b),
            inertia.expressed_in(self._T_base_world),
        )

    def _carrier(self, b: int) -> int | None:
        """The arm's joint that carries body b: the last one of the first jointed body above."""
        while b:
            if self.model.body_jntnum[b]:
                last = int(self.model.body_jntadr[b] + self.model.body_jntnum[b] - 1)
                return self._joints.index(last)
            b = int(self.model.body_parentid[b])
        return None

    def _joint_id(self, name: str) -> int:
        found = mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_JOINT, name)
        if found < 0:
            raise EngineError(f"MuJoCo's model of {self.arm.name!r} lacks joint {name!r}")
        return int(found)

    def _site(self, name: str) -> Transform:
        site = self.data.site(name)
        return Transform(np.array(site.xmat).reshape(3, 3), np.array(site.xpos))

    def _place(self, q: Array, qd: Array) -> None:
        self.data.qpos[self._q], self.data.qvel[self._v] = q, qd
        mujoco.mj_fwdPosition(self.model, self.data)
        mujoco.mj_fwdVelocity(self.model, self.data)

    def _rne(self, accelerating: int) -> Array:
        torques = np.zeros(self.model.nv)
        mujoco.mj_rne(self.model, self.data, accelerating, torques)
        return np.asarray(torques[self._v])

    def _each(self, one: Callable[..., Array], *arrays: Array) -> Array:
        return each_state(one, self.arm.n, (self.arm.n,), *arrays)


def _number(value: Any) -> float | None:
    return None if value is None else float(value)


def _compiled(arm: ArmOrTree) -> Any:
    try:
        spec = _built(arm) if arm.source.urdf is None else _parsed(arm)
        return spec.compile()
    except ValueError as error:
        reason = " ".join(str(error).split())
        raise EngineError(f"MuJoCo cannot take the model of {arm.name!r}: {reason}") from error


def _parsed(arm: ArmOrTree) -> Any:
    spec = mujoco.MjSpec.from_string(text_for_engines(arm))
    for link, site in ((arm.source.base, _BASE), (arm.source.tip, _TOOL)):
        # The root link has become the world.
        body = spec.body(link) or spec.worldbody
        body.add_site(name=site)
    return spec


def _built(arm: ArmOrTree) -> Any:
    """The arm passed joint by joint."""
    spec = mujoco.MjSpec()
    bodies, tips = {-1: spec.worldbody}, {-1: Transform.identity()}
    spec.worldbody.add_site(name=_BASE)
    links = tree_links(arm)
    for i, each in enumerate(links):
        joint, link, placement = each.joint, each.link, tips[each.parent] @ each.origin
        here = link.inertia.expressed_in(link.link_tip_frame)
        tensor = here.tensor
        bodies[i] = body = bodies[each.parent].add_body(
            name=link.name,
            pos=placement.p,
            quat=_quaternion(placement.R),
            explicitinertial=True,
            mass=here.mass,
            ipos=here.com,
            fullinertia=[tensor[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))],
        )
        kinds = mujoco.mjtJoint
        body.add_joint(
            name=joint.name,
            type=kinds.mjJNT_SLIDE if joint.kind == "prismatic" else kinds.mjJNT_HINGE,
            axis=joint.axis,
            armature=joint.armature,
        )
        tips[i] = link.link_tip_frame
    tool = tips[len(links) - 1]
    bodies[len(links) - 1].add_site(name=_TOOL, pos=tool.p, quat=_quaternion(tool.R))
    return spec


def _quaternion(R: Array) -> Array:
    quaternion = np.empty(4)
    mujoco.mju_mat2Quat(quaternion, np.ascontiguousarray(R).ravel())
    return quaternion


@contextmanager
def _captured_warnings() -> Iterator[list[str]]:
    """MuJoCo's warnings during the block; by default they go to a file in the working folder."""
    lines: list[str] = []
    mujoco.set_mju_user_warning(lines.append)
    try:
        yield lines
    finally:
        mujoco.set_mju_user_warning(None)


def _masses_from_inertial_only(root: Any) -> None:
    """Set MuJoCo's compiler to take masses from `<inertial>` only."""
    settings = root.find("mujoco")
    if settings is None:
        settings = etree.SubElement(root, "mujoco")
    compiler = settings.find("compiler")
    if compiler is None:
        compiler = etree.SubElement(settings, "compiler")
    compiler.set("inertiafromgeom", "false")


_KNOWN_ISSUES = (
    KnownIssue(
        id="mujoco-mass-from-shape",
        engine="mujoco",
        measured="4.0",
        kinds=("shape-mass",),
        harmful=True,
        title="a link without <inertial> gets the mass of its collision shape",
        explanation="A body without an inertial is filled with the density of water, 1000 kg/m³, "
        "wherever it has a collision shape, and merged into the link that carries it.",
        fix='set <mujoco><compiler inertiafromgeom="false"/></mujoco>; '
        "`ur5check expand --for mujoco`",
        rewrite=_masses_from_inertial_only,
    ),
    KnownIssue(
        id="mujoco-fuses-fixed-links",
        engine="mujoco",
        measured="4.0",
        kinds=("body-merged", "body-lost"),
        harmful=False,
        title="fixed links are merged into their parents",
        explanation="Links behind fixed joints lose their names and frames, the tool's among them "
        "(fusestatic, on for URDF); their inertias are kept.",
        fix="none is needed for torques; for the frames set fusestatic='false'",
    ),
    KnownIssue(
        id="mujoco-base-is-world",
        engine="mujoco",
        measured="4.0",
        kinds=("base-ignored",),
        harmful=False,
        title="the root link becomes the world",
        explanation="It is fixed and its inertia is dropped: a fixed base loads no joint.",
        fix="none is needed: torques do not change",
    ),
    KnownIssue(
        id="mujoco-no-velocity-limit",
        engine="mujoco",
        measured="4.0",
        kinds=("velocity-limit",),
        harmful=False,
        title="velocity limits are not kept",
        explanation="MuJoCo's joints have position and force ranges only.",
        fix="limit velocities in the controller",
    ),
    KnownIssue(
        id="mujoco-equal-limits",
        engine="mujoco",
        measured="4.0",
        kinds=("position-limit",),
        harmful=False,
        title="equal lower and upper limits are ignored",
        explanation="A joint that is limited to one position turns freely.",
        fix="make it a fixed joint",
    ),
)

ENTRY = EngineEntry(
    key="mujoco",
    title="MuJoCo",
    order=20,
    make=MuJoCoEngine,
    module=mujoco,
    distribution="mujoco",
    extra="mujoco",
    known_issues=_KNOWN_ISSUES,
    finds_packages=False,
)
