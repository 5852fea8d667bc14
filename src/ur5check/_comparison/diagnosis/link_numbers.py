"""One link's numbers as its file writes them, and both sides of a comparison in that form.

A mistake is made in a file, in the frames of that file.  So the search takes each side in turn as
the suspect: its numbers stay as they were written, the other side's are expressed in the same
frames, and are what the suspect's should be.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..._robot.inertia import Inertia
from ..._robot.serial_arm import Link, SerialArm
from ..._robot.transforms import Array, Transform
from ..alignment import SAME_LENGTH
from ..arm_pair import Pair, Side

__all__ = ["Body", "LinkPair", "body_of", "changed_bodies", "with_body"]


@dataclass(frozen=True, eq=False)
class Body:
    """The numbers of one link in a file, in the frame in which the file gives them.

    mass [kg];  com, shape (3,) [m];  tensor about it, shape (3, 3) [kg m²]
    link_vector : from the link's joint to its tip frame, shape (3,) [m]
    rotation : of the link's tip frame in the frame at its joint, R(P_i), shape (3, 3)
    offset : the link vector as the file gives it, shape (3,) [m]: before the rotation (a URDF's
        xyz, a DH row's a and d), or after it if `after_rotation` (a listing's r_{i−1,i})
    near : whether the frame stands at the link's joint (a URDF) or at its tip frame (a DH table)
    welded : (name, inertia in the same frame) of the bodies fixed to the link, included in its
        inertia
    """

    mass: float
    com: Array
    tensor: Array
    link_vector: Array
    rotation: Array
    offset: Array
    after_rotation: bool
    near: bool
    welded: tuple[tuple[str, Inertia], ...] = ()

    @property
    def whole(self) -> Inertia:
        """Mass, centre and tensor together."""
        return Inertia(self.mass, self.com, self.tensor)

    def centre_off_link(self) -> float:
        """How far the centre of mass lies from the straight line between joint and tip frame
        [m].
        """
        from_joint = self.com if self.near else self.com + self.link_vector
        length_squared = float(self.link_vector @ self.link_vector)
        along = (
            float(from_joint @ self.link_vector) / length_squared if length_squared > 0.0 else 0.0
        )
        return float(np.linalg.norm(from_joint - min(max(along, 0.0), 1.0) * self.link_vector))

    @property
    def steiner(self) -> Array:
        """Parallel-axis term of the tensor about the frame's origin: m (c·c 1 − c cᵀ)."""
        c = self.com
        return np.asarray(self.mass * (c @ c * np.eye(3) - np.outer(c, c)))


@dataclass(frozen=True, eq=False)
class LinkPair:
    """A suspect's bodies, and what they should be by the other side.

    side : which arm of the pair is the suspect
    bodies, truth : link by link, both in the suspect's own source frames
    """

    side: Side
    bodies: tuple[Body, ...]
    truth: tuple[Body, ...]

    def unequal_offsets(self) -> int:
        """How many links' offsets differ by more than a micrometre."""
        return sum(
            float(np.abs(own.offset - true.offset).max()) > SAME_LENGTH
            for own, true in zip(self.bodies, self.truth, strict=True)
        )

    @classmethod
    def of(cls, pair: Pair, side: Side) -> LinkPair:
        """The pair with `side` as the suspect."""
        arms = {"a": pair.a, "b": pair.given_b}
        suspect, other = (arms[side], arms["a" if side == "b" else "b"])
        maps = [T.inverse() if side == "b" else T for T in pair.link_maps]
        if pair.number_by_number:
            # Number by number, as both files write them; a DH file may write a and d, or r.  Which
            # of them is round shows before rounded angles are exact.
            written = pair.rounded or pair
            ways = [
                cls(
                    side,
                    _bodies(written.a, after_rotation),
                    _bodies(written.given_b, after_rotation),
                )
                for after_rotation in (False, True)
            ]
            after_rotation = ways[1].unequal_offsets() < ways[0].unequal_offsets()
            return cls(side, _bodies(suspect, after_rotation), _bodies(other, after_rotation))
        bodies = _bodies(suspect)
        truth = tuple(
            _taken_over(own, link, T, as_written)
            for own, link, T, as_written in zip(
                suspect.links, other.links, maps, bodies, strict=True
            )
        )
        return cls(side, bodies, truth)


def _bodies(arm: SerialArm, after_rotation: bool = False) -> tuple[Body, ...]:
    return tuple(body_of(arm, i, after_rotation) for i in range(arm.n))


def _taken_over(own: Link, other: Link, T: Transform, as_written: Body) -> Body:
    """The other side's inertia in the suspect's source frame; the geometry is the suspect's."""
    to_source = own.source_frame.inverse() @ T
    inertia = other.inertia.expressed_in(to_source)
    welded = tuple((name, part.expressed_in(to_source)) for name, part in other.welded)
    return replace(
        as_written, mass=inertia.mass, com=inertia.com, tensor=inertia.tensor, welded=welded
    )


def changed_bodies(link_pair: LinkPair, link: int, body: Body) -> LinkPair:
    """The link pair with one of the suspect's bodies replaced."""
    return replace(
        link_pair, bodies=(*link_pair.bodies[:link], body, *link_pair.bodies[link + 1 :])
    )


def body_of(arm: SerialArm, link: int, after_rotation: bool = False) -> Body:
    """The numbers of one link (from 0), as its source writes them.

    after_rotation : whether the source gives r_{i−1,i} rather than the offset before the rotation;
        never so for a URDF
    """
    own = arm.links[link]
    to_source = own.source_frame.inverse()
    inertia = own.inertia.expressed_in(to_source)
    welded = tuple((name, part.expressed_in(to_source)) for name, part in own.welded)
    P, near = own.link_tip_frame, own.held_near
    link_vector = P.p if near else to_source.R @ P.R.T @ P.p
    after_rotation = after_rotation and not near
    return Body(
        inertia.mass,
        inertia.com,
        inertia.tensor,
        link_vector,
        P.R,
        link_vector if after_rotation else P.p,
        after_rotation,
        near,
        welded,
    )


def with_body(arm: SerialArm, link: int, body: Body) -> SerialArm:
    """The arm with the numbers of one link (from 0) replaced by `body`'s, in its source's frame."""
    old, written = arm.links[link], body_of(arm, link, body.after_rotation)
    link_tip_frame, source_frame = old.link_tip_frame, old.source_frame
    same = np.array_equal(body.offset, written.offset) and np.array_equal(
        body.rotation, written.rotation
    )
    if not same:
        p = body.rotation @ source_frame.R @ body.offset if body.after_rotation else body.offset
        link_tip_frame = Transform(body.rotation, p)
        source_frame = link_tip_frame.inverse() if body.near else source_frame
    inertia = body.whole.expressed_in(source_frame)
    new = replace(old, link_tip_frame=link_tip_frame, inertia=inertia, source_frame=source_frame)
    return replace(arm, links=(*arm.links[:link], new, *arm.links[link + 1 :]))
