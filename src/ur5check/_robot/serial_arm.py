"""A serial arm as one value, in one form for every source:

    T_base→tool(q) = B · J1(q1) · P1 · J2(q2) · P2 · … · Jn(qn) · Pn

B is constant, J_i(q_i) rotates by q_i about (or translates by q_i along) a unit axis, and P_i, the
link tip frame, is constant.  Frame i lies after P_i, at the tip of link i, as in the paper's
recursion (eqs 9–15).

    source          axis    B                      P_i
    standard DH     z       1                      Trans_z(d) Trans_x(a) Rot_x(α)
    modified DH     z       Rot_x(α0) Trans_x(a0)  Trans_z(d) Rot_x(α) Trans_x(a) of the next row
    URDF            any     first joint's origin   next joint's origin; the tool's for P_n
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Literal, TypeVar

import numpy as np

from .._arguments import choice, instance
from .._errors import ModelError, UsageError
from .._finding import Finding, Place
from .inertia import Inertia
from .transforms import Array, Transform, frozen, unit_vector

if TYPE_CHECKING:
    from .robot import Robot

#: Largest rounding between a frame and the inverse of its inverse.
_SAME_FRAME = 1e-9

#: Writers put the largest double where a format demands a limit and none is known.
NO_LIMIT = 1e100

__all__ = ["NO_LIMIT", "STANDARD_GRAVITY", "Joint", "Limits", "Link", "SerialArm", "Source"]

_T = TypeVar("_T")

#: Gravity in an arm's base frame where the source gives none [m/s²]; Pinocchio's default.
STANDARD_GRAVITY = (0.0, 0.0, -9.81)


@dataclass(frozen=True)
class Limits:
    """Limits of a joint, None where the source gives none.

    Parameters
    ----------
    lower, upper : float or None
        Position [rad] or [m].
    velocity : float or None
        [rad/s] or [m/s]
    effort : float or None
        Torque [N m] or force [N].

    Examples
    --------
    >>> from ur5check import Limits
    >>> Limits(lower=-3.14, upper=3.14, effort=0.0).known_effort is None
    True
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
        known = self.effort is not None and 0.0 < self.effort < NO_LIMIT
        return self.effort if known else None


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint that rotates about, or translates along, an axis through the origin of frame i−1.

    Parameters
    ----------
    name : str
    axis : array-like, shape (3,)
        In frame i−1 (the base after B for the first joint); normalised, must not be zero.
    kind : {"revolute", "prismatic"}
    limits : Limits
    armature : float
        Inertia of the motor reflected through its gear [kg m²] or [kg]: τ_i += armature · q̈_i.
    damping, friction : float
        Viscous [N m s/rad] and dry [N m] friction ([N s/m] and [N] for a prismatic joint).  The
        recursion leaves both out; audits and simulations use them.
    places : mapping of str to Place
        Where "limit" and "dynamics" are written, as far as that is known.

    Raises
    ------
    ModelError
        For an axis that is zero, or not three finite numbers.

    Examples
    --------
    >>> from ur5check import Joint
    >>> Joint("elbow", (0, 0, 2)).axis.tolist()
    [0.0, 0.0, 1.0]
    """

    name: str
    axis: Array
    kind: Literal["revolute", "prismatic"] = "revolute"
    limits: Limits = field(default_factory=Limits)
    armature: float = 0.0
    damping: float = 0.0
    friction: float = 0.0
    places: Mapping[str, Place] = field(default_factory=dict)

    def __post_init__(self) -> None:
        instance("name", self.name, str, "give the joint a name")
        choice("kind", self.kind, ("revolute", "prismatic"))
        instance("limits", self.limits, Limits, "see ur5check.Limits")
        axis = frozen(self.axis, (3,), "axis")
        if not axis.any():
            raise ModelError(
                "the axis is zero", fix="give its direction", element=f"joint {self.name!r}"
            )
        object.__setattr__(self, "axis", frozen(unit_vector(axis), (3,)))

    def motion(self, q: float) -> Transform:
        """The transform J_i(q) of the joint.

        Parameters
        ----------
        q : float
            Joint position [rad] or [m].

        Returns
        -------
        Transform
            Rotation about the axis, or translation along it.
        """
        if self.kind == "prismatic":
            return Transform.translation(self.axis * q)
        return Transform.rotation(self.axis, q)


@dataclass(frozen=True, eq=False)
class Link:
    """Link i: the body that joint i moves.

    Parameters
    ----------
    name : str
    link_tip_frame : Transform
        P_i, the pose of frame i in the frame that joint i moves.
    inertia : Inertia
        Of the link with all bodies fixed to it, in frame i.
    source_frame : Transform
        From the frame in which the source gives the inertia to frame i: the identity for a DH
        table, P_i⁻¹ for a URDF.  Reports use it to show the numbers of the source.
    welded : tuple of (str, Inertia)
        Bodies fixed to the link that `inertia` contains, in frame i.
    tensor_known : bool
        False where the source gives mass and centre of mass only; the tensor of `inertia` is then
        zero, and `SerialArm.require_tensors` keeps it from being used.

    Examples
    --------
    >>> import numpy as np
    >>> from ur5check import Inertia, Link, Transform
    >>> rod = Inertia(1.2, [-0.2, 0.0, 0.0], np.diag([1e-3, 0.016, 0.016]))
    >>> Link("rod", Transform.translation((0.4, 0.0, 0.0)), rod).inertia.mass
    1.2
    """

    name: str
    link_tip_frame: Transform
    inertia: Inertia
    source_frame: Transform = field(default_factory=Transform.identity)
    welded: tuple[tuple[str, Inertia], ...] = ()
    tensor_known: bool = True

    @property
    def held_near(self) -> bool:
        """Whether the source gives the inertia in the joint's frame (a URDF), not the tip frame."""
        between = self.link_tip_frame @ self.source_frame
        return bool(np.abs(between.matrix() - np.eye(4)).max() < _SAME_FRAME)


@dataclass(frozen=True, eq=False)
class Source:
    """Where an arm came from.

    Attributes
    ----------
    kind : str
        "dh", "urdf", "xacro", "mjcf", "sdf", "pinocchio" or "value" (built in Python).
    inputs : tuple of (str, str)
        Name and SHA-256 of every file that was read, in reading order.
    urdf : str or None
        The URDF text, after xacro expansion, for reference engines with a parser of their own.
    model : pin.Model or None
        Where the arm was made from one.
    base, tip : str
        Names of the links (or frames) at the ends of the chain.
    held : tuple of (str, float)
        Joints beside the chain and the positions [rad] or [m] at which they are locked.
    notes : tuple of str
        Remarks of the reader for reports ("merged fixed link 'tool0' …").
    faults : tuple of Finding
        Errors of the file about this arm that `load(…, strict=False)` passed over.
    robot : Robot or None
        The whole description that the arm was taken from, with the place of each number.
    """

    kind: str = "value"
    inputs: tuple[tuple[str, str], ...] = ()
    urdf: str | None = None
    model: Any = None
    base: str = "base"
    tip: str = "tool"
    held: tuple[tuple[str, float], ...] = ()
    notes: tuple[str, ...] = ()
    faults: tuple[Finding, ...] = ()
    robot: Robot | None = None

    def as_value(self) -> Source:
        """The same source without what holds the arm's numbers, for an arm with other ones.

        Returns
        -------
        Source
        """
        return replace(self, urdf=None, model=None, faults=(), robot=None)


@dataclass(frozen=True, eq=False)
class SerialArm:
    """A fixed-base serial chain of n joints with the inertias of its links; immutable.

    Parameters
    ----------
    name : str
    joints : sequence of Joint, length n
    links : sequence of Link, length n
        Link i is moved by joint i.
    base : Transform
        B, from the base frame to the first joint.
    gravity : array-like, shape (3,)
        In the base frame [m/s²].
    source : Source
    given_label : str
        What reports call the arm instead of its name.

    Raises
    ------
    ModelError
        For no joint, different numbers of joints and links, or gravity that is not three finite
        numbers.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.load("paper").joint_names[:2]
    ('base', 'shoulder')
    """

    name: str
    joints: tuple[Joint, ...]
    links: tuple[Link, ...]
    base: Transform = field(default_factory=Transform.identity)
    gravity: Array = field(default_factory=lambda: np.array(STANDARD_GRAVITY))
    source: Source = field(default_factory=Source)
    given_label: str = ""

    def __post_init__(self) -> None:
        instance("name", self.name, str, "give the arm a name")
        object.__setattr__(self, "joints", _all_of("joints", self.joints, Joint))
        object.__setattr__(self, "links", _all_of("links", self.links, Link))
        object.__setattr__(self, "gravity", frozen(self.gravity, (3,), "gravity"))
        if not self.joints or len(self.joints) != len(self.links):
            raise ModelError(
                f"arm {self.name!r} has {len(self.joints)} joints and {len(self.links)} links",
                fix="give one link for each joint, and at least one joint",
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
        """Names of the joints, from base to tip."""
        return tuple(joint.name for joint in self.joints)

    @property
    def unknown_tensors(self) -> tuple[str, ...]:
        """Names of the links whose inertia tensor the source does not give."""
        return tuple(link.name for link in self.links if not link.tensor_known)

    def require_tensors(self, what: str) -> None:
        """Refuse an arm with an unknown inertia tensor.

        Parameters
        ----------
        what : str
            What cannot be had without the tensors ("the mass matrix").

        Raises
        ------
        ModelError
            Where a tensor is unknown.
        """
        if not self.unknown_tensors:
            return
        links = ", ".join(map(repr, self.unknown_tensors))
        raise ModelError(
            f"the inertia tensors of {links} are unknown: only gravity torques can be had, not "
            f"{what}",
            fix="give the tensors, or ask for gravity_torque",
            file=self.source.inputs[0][0] if self.source.inputs else None,
            element=f"arm {self.label!r}",
            rule="INE117",
        )

    def parameters(self) -> Array:
        """The inertial parameters π of all links.

        Returns
        -------
        ndarray, shape (10 n,)
            `Inertia.parameters()` of link 1, link 2, …, each in its frame i.
        """
        return np.concatenate([link.inertia.parameters() for link in self.links])

    def with_inertias(self, inertias: Sequence[Inertia]) -> SerialArm:
        """The same chain with other inertias.

        Its source then has neither text nor model: engines would read the old inertias from them.

        Parameters
        ----------
        inertias : sequence of Inertia, length n
            One a link, each in its frame i.

        Returns
        -------
        SerialArm

        Raises
        ------
        UsageError
            For another number of inertias, or values of another type.
        """
        bodies = _all_of("inertias", inertias, Inertia)
        if len(bodies) != self.n:
            raise UsageError(f"arm {self.name!r} has {self.n} links; give {self.n} inertias")
        links = tuple(
            replace(link, inertia=inertia, tensor_known=True)
            for link, inertia in zip(self.links, bodies, strict=True)
        )
        return replace(self, links=links, source=self.source.as_value())

    @property
    def armature(self) -> Array:
        """Motor inertia of each joint, shape (n,) [kg m²] or [kg]."""
        return np.array([joint.armature for joint in self.joints])

    def with_armature(self, armature: Sequence[float] | Array) -> SerialArm:
        """The same arm with other motor inertias.

        Parameters
        ----------
        armature : array-like, shape (n,)
            Reflected through the gear [kg m²]; [kg] for a prismatic joint.

        Returns
        -------
        SerialArm

        Raises
        ------
        ModelError
            For another shape, or entries that are not finite numbers.
        """
        joints = tuple(
            replace(joint, armature=value)
            for joint, value in zip(
                self.joints, frozen(armature, (self.n,), "armature").tolist(), strict=True
            )
        )
        return replace(self, joints=joints, source=self.source.as_value())

    def with_gravity(self, gravity: Sequence[float] | Array) -> SerialArm:
        """The same arm under another gravity.

        Parameters
        ----------
        gravity : array-like, shape (3,)
            In the arm's base frame [m/s²].

        Returns
        -------
        SerialArm

        Raises
        ------
        ModelError
            For another shape, or entries that are not finite numbers.
        """
        return replace(self, gravity=frozen(gravity, (3,), "gravity"))

    def __repr__(self) -> str:
        return f"<SerialArm {self.name!r}: {self.n} joints, from {self.source.kind}>"


def _all_of(name: str, values: Sequence[_T], kind: type[_T]) -> tuple[_T, ...]:
    """`values` as a tuple, each of them a `kind`.  Raises UsageError."""
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise UsageError(f"{name} must be a sequence of {kind.__name__}, not {values!r:.80}")
    hint = f"see ur5check.{kind.__name__}"
    return tuple(instance(f"{name}[{i}]", value, kind, hint) for i, value in enumerate(values))
