"""One link's numbers as its file writes them, and both sides of a comparison in that form.

A mistake is made in a file, in the frames of that file.  So the search looks at each side in turn
as the suspect, holds the suspect's numbers as they were written, and takes the other side's numbers
into the same frames: those are what the suspect's should have been.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..arm.inertia import Inertia
from ..arm.serial_arm import Link, SerialArm
from ..arm.transforms import Array, Transform
from ..comparison.alignment import SAME_ANGLE, SAME_LENGTH
from ..comparison.pair import Pair, Side

__all__ = ["Body", "Scene", "body_of", "changed_bodies", "with_body"]


@dataclass(frozen=True, eq=False)
class Body:
    """What a file says of one link, in the frame in which it says it.

    mass [kg];  com, shape (3,) [m];  tensor about it, shape (3, 3) [kg m²]
    reach : from the link's joint to its far end, shape (3,) [m]
    turn : rotation from the link's far frame to its near one, R(P_i), shape (3, 3)
    welded : (name, inertia in the same frame) of the bodies fixed to the link, which it contains
    """

    mass: float
    com: Array
    tensor: Array
    reach: Array
    turn: Array
    welded: tuple[tuple[str, Inertia], ...] = ()

    @property
    def whole(self) -> Inertia:
        """Mass, centre and tensor together."""
        return Inertia(self.mass, self.com, self.tensor)

    @property
    def steiner(self) -> Array:
        """What parallel axes add to the tensor about the frame's origin: m (c·c 1 − c cᵀ)."""
        c = self.com
        return np.asarray(self.mass * (c @ c * np.eye(3) - np.outer(c, c)))


@dataclass(frozen=True, eq=False)
class Scene:
    """A suspect's bodies, and what the other side says that they should be.

    side : which arm of the pair is the suspect
    bodies, truth : link by link, both in the suspect's own source frames
    """

    side: Side
    bodies: tuple[Body, ...]
    truth: tuple[Body, ...]

    @classmethod
    def of(cls, pair: Pair, side: Side) -> Scene:
        """The pair with `side` as the suspect."""
        suspect, other = (pair.b, pair.a) if side == "b" else (pair.a, pair.b)
        to_suspect = [T.inverse() if side == "b" else T for T in pair.link_maps]
        bodies, truth = [], []
        before = Transform.identity()  # the base frame is common
        for own, foreign, T in zip(suspect.links, other.links, to_suspect, strict=True):
            far_end = before @ foreign.far_end @ T.inverse()
            moved = replace(
                foreign,
                far_end=far_end,
                inertia=foreign.inertia.expressed_in(T),
                welded=tuple((name, part.expressed_in(T)) for name, part in foreign.welded),
            )
            near = _held_near(own)
            bodies.append(_body(own, own.source_frame, near))
            truth.append(_body(moved, _own_frame(own, moved, near), near))
            before = T
        return cls(side, tuple(bodies), tuple(truth))


def _own_frame(own: Link, other: Link, near: bool) -> Transform:
    """The frame in which `own`'s source would have written the other link."""
    return other.far_end.inverse() if near else own.source_frame


def changed_bodies(scene: Scene, link: int, body: Body) -> Scene:
    """The scene with one of the suspect's bodies replaced."""
    return replace(scene, bodies=(*scene.bodies[:link], body, *scene.bodies[link + 1 :]))


def body_of(arm: SerialArm, link: int) -> Body:
    """The numbers of one link (from 0), as its source writes them."""
    own = arm.links[link]
    return _body(own, own.source_frame, _held_near(own))


def with_body(arm: SerialArm, link: int, body: Body) -> SerialArm:
    """The arm with the numbers of one link (from 0) replaced by `body`'s, in its source's frame."""
    old, written = arm.links[link], body_of(arm, link)
    near = _held_near(old)
    far_end, source_frame = old.far_end, old.source_frame
    same = np.array_equal(body.reach, written.reach) and np.array_equal(body.turn, written.turn)
    if not same:
        p = body.reach if near else body.turn @ old.source_frame.R @ body.reach
        far_end = Transform(body.turn, p)
        source_frame = far_end.inverse() if near else source_frame
    inertia = body.whole.expressed_in(source_frame)
    new = replace(old, far_end=far_end, inertia=inertia, source_frame=source_frame)
    return replace(arm, links=(*arm.links[:link], new, *arm.links[link + 1 :]))


def _held_near(link: Link) -> bool:
    """Whether the source holds the link's numbers at its joint (a URDF) or at its far end (DH)."""
    between = link.far_end @ link.source_frame
    return between.angle() < SAME_ANGLE and bool(np.abs(between.p).max() < SAME_LENGTH)


def _body(link: Link, source_frame: Transform, near: bool) -> Body:
    to_source = source_frame.inverse()
    inertia = link.inertia.expressed_in(to_source)
    welded = tuple((name, part.expressed_in(to_source)) for name, part in link.welded)
    P = link.far_end
    reach = P.p if near else source_frame.R.T @ P.R.T @ P.p
    return Body(inertia.mass, inertia.com, inertia.tensor, reach, P.R, welded)
