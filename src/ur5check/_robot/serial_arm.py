"""One value for an arm, whatever it was read from.

Every source becomes a `SerialArm`, built on one grammar:

    T_base→tool(q) = B · J1(q1) · P1 · J2(q2) · P2 · … · Jn(qn) · Pn

`B` is fixed, `Ji(qi)` turns by qi about (or slides by qi along) a unit axis, `Pi` is fixed.
Frame i sits at the tip frame of link i, right after Pi, where the paper's recursion (eqs 9–15) has
it.

    source          axis    B                      P_i
    standard DH     z       1                      Trans_z(d) Trans_x(a) Rot_x(α)
    modified DH     z       Rot_x(α0) Trans_x(a0)  Trans_z(d) Rot_x(α) Trans_x(a) of the next row
    URDF            any     first joint's origin   next joint's origin; the tool's for P_n
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np

from .inertia import Inertia
from .transforms import Array, Transform, frozen

_SAME_FRAME = 1e-9  # a frame and its inverse's inverse, rounded

#: Writers put the largest double where a format demands a limit and none is known.
_NO_LIMIT = 1e100

__all__ = ["STANDARD_GRAVITY", "Joint", "Limits", "Link", "SerialArm", "Source"]

#: Gravity in an arm's base frame unless its source says otherwise [m/s²]; Pinocchio's default.
STANDARD_GRAVITY = (0.0, 0.0, -9.81)


@dataclass(frozen=True)
class Limits:
    """What a joint may do; None where the source does not say.

    lower, upper : position [rad] or [m];  velocity : [rad/s] or [m/s];  effort : [N m] or [N]
    """

    lower: float | None = None
    upper: float | None = None
    velocity: float | None = None
    effort: float | None = None

    @property
    def known_effort(self) -> float | None:
        """The effort limit where one is known [N m] or [N].

        Unknown is what is absent, and also zero (it would forbid all motion; files hold it where
        the author did not know the limit), and a number so large that it limits nothing.
        """
        known = self.effort is not None and 0.0 < self.effort < _NO_LIMIT
        return self.effort if known else None


@dataclass(frozen=True, eq=False)
class Joint:
    """Joint i: J_i(q_i) turns about, or slides along, the unit vector `axis` through the origin of
    the frame it starts from (frame i−1 after P_{i−1}, or the base after B).

    armature : inertia of the joint's own motor, seen through its gear, [kg m²] or [kg].  It resists
        the joint's acceleration and nothing else: τ_i += armature · q̈_i
    damping, friction : of the joint's bearing, [N m s/rad] and [N m], or [N s/m] and [N].  Held
        for audits and simulations; the recursion is about rigid bodies and leaves both out
    """

    name: str
    axis: Array
    kind: Literal["revolute", "prismatic"] = "revolute"
    limits: Limits = field(default_factory=Limits)
    armature: float = 0.0
    damping: float = 0.0
    friction: float = 0.0

    def __post_init__(self) -> None:
        axis = frozen(self.axis, (3,))
        length = float(np.linalg.norm(axis))
        if length == 0.0:
            raise ValueError(f"joint {self.name!r}: the axis must not be zero")
        # Dividing an axis that is a unit vector already would only smear its exact zeros and ones.
        unit = axis if abs(length - 1.0) <= np.finfo(float).eps else axis / length
        object.__setattr__(self, "axis", frozen(unit, (3,)))

    def motion(self, q: float) -> Transform:
        """J_i(q)."""
        if self.kind == "prismatic":
            return Transform.translation(self.axis * q)
        return Transform.rotation(self.axis, q)


@dataclass(frozen=True, eq=False)
class Link:
    """Link i: the body that joint i moves.

    far_end : P_i, the pose of frame i seen from the joint's moving side
    inertia : of the link with all that is fixed to it, in frame i
    source_frame : T from the frame in which the source wrote this link's inertia to frame i; the
        identity for a DH table, P_i⁻¹ for a URDF.  Only reports use it: they speak to the reader in
        the numbers of the reader's own file.
    welded : bodies fixed to the link that `inertia` contains, (name, inertia in frame i)
    """

    name: str
    link_tip_frame: Transform
    inertia: Inertia
    source_frame: Transform = field(default_factory=Transform.identity)
    welded: tuple[tuple[str, Inertia], ...] = ()

    @property
    def held_near(self) -> bool:
        """Whether the source holds the link's numbers at its joint (a URDF), not at its tip
        frame.
        """
        between = self.link_tip_frame @ self.source_frame
        return bool(np.abs(between.matrix() - np.eye(4)).max() < _SAME_FRAME)


@dataclass(frozen=True, eq=False)
class Source:
    """Where an arm came from.

    kind : "dh", "urdf", "xacro", "mjcf", "sdf", "pinocchio" or "value" (built in Python)
    inputs : (name, SHA-256) of every file that was read, in reading order
    urdf : the URDF text, after xacro expansion, for reference engines that bring their own parser
    model : the `pin.Model` itself, when that is what was given
    base, tip : names of the links (or frames) between which the arm was taken
    notes : what a reader of a report should know of the reading ("merged fixed link 'tool0' …")
    """

    kind: str = "value"
    inputs: tuple[tuple[str, str], ...] = ()
    urdf: str | None = None
    model: Any = None
    base: str = "base"
    tip: str = "tool"
    notes: tuple[str, ...] = ()

    def as_value(self) -> Source:
        """The same origin without the text or model, for an arm whose numbers were changed."""
        return replace(self, urdf=None, model=None)


@dataclass(frozen=True, eq=False)
class SerialArm:
    """A fixed-base serial chain of n joints, with its inertias.  Immutable.

    base : B [m], from the base frame to the first joint
    gravity : in the base frame, shape (3,) [m/s²]
    given_label : what reports call the arm where its name would not do (`labelled`)
    """

    name: str
    joints: tuple[Joint, ...]
    links: tuple[Link, ...]
    base: Transform = field(default_factory=Transform.identity)
    gravity: Array = field(default_factory=lambda: np.array(STANDARD_GRAVITY))
    source: Source = field(default_factory=Source)
    given_label: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "joints", tuple(self.joints))
        object.__setattr__(self, "links", tuple(self.links))
        object.__setattr__(self, "gravity", frozen(self.gravity, (3,)))
        if not self.joints:
            raise ValueError(f"arm {self.name!r} has no joint")
        if len(self.joints) != len(self.links):
            raise ValueError(
                f"arm {self.name!r} has {len(self.joints)} joints but {len(self.links)} links"
            )

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.joints)

    @property
    def label(self) -> str:
        """What reports call the arm: its name, unless it was given a label."""
        return self.given_label or self.name

    @property
    def joint_names(self) -> tuple[str, ...]:
        return tuple(joint.name for joint in self.joints)

    def parameters(self) -> Array:
        """π, shape (10 n,): `Inertia.parameters()` of link 1, link 2, …, each in its frame i."""
        return np.concatenate([link.inertia.parameters() for link in self.links])

    def with_inertias(self, inertias: Sequence[Inertia]) -> SerialArm:
        """The same chain carrying other inertias, given in the frames i.

        It is no longer what its file or `pin.Model` says: no engine shall read it from there.
        """
        links = tuple(
            replace(link, inertia=inertia)
            for link, inertia in zip(self.links, inertias, strict=True)
        )
        return replace(self, links=links, source=self.source.as_value())

    @property
    def armature(self) -> Array:
        """The joints' motor inertias, shape (n,) [kg m²] or [kg]."""
        return np.array([joint.armature for joint in self.joints])

    def with_armature(self, armature: Sequence[float] | Array) -> SerialArm:
        """The same arm with other motor inertias, shape (n,)."""
        joints = tuple(
            replace(joint, armature=float(value))
            for joint, value in zip(self.joints, armature, strict=True)
        )
        return replace(self, joints=joints, source=self.source.as_value())

    def with_gravity(self, gravity: Sequence[float] | Array) -> SerialArm:
        """The same arm under another gravity, in its base frame [m/s²]."""
        return replace(self, gravity=np.asarray(gravity, dtype=np.float64))

    def __repr__(self) -> str:
        return f"<SerialArm {self.name!r}: {self.n} joints, from {self.source.kind}>"
