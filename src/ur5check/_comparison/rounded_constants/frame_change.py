"""Changing a link's tip frame without moving its body: which of its numbers were written, and
where.

A link's tip frame P_i also carries frame i, in which its inertia is held.  A DH table writes the
inertia in frame i, so it goes along when P_i changes.  A URDF writes it at the joint, so the body
stays, and its numbers in frame i change.  In the same way a listing may write the vector r_{i−1,i}
in frame i, where a DH row or a URDF writes p in the frame before P_i's rotation.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..._robot.serial_arm import Link, SerialArm
from ..._robot.transforms import Array, Transform
from .decimals import decimals_of

__all__ = ["arm_with_link", "link_vector_is_written_at_link_tip", "with_link_tip_frame"]


def with_link_tip_frame(link: Link, link_tip_frame: Transform) -> Link:
    """The link with another P_i, its inertia kept where the source wrote it."""
    T = link.source_frame
    if not (T.R - np.eye(3)).any() and not T.p.any():
        return replace(link, link_tip_frame=link_tip_frame)
    change = link_tip_frame.inverse() @ link.link_tip_frame  # from the old frame i to the new one
    return Link(link.name, link_tip_frame, link.inertia.expressed_in(change), change @ T)


def link_vector_is_written_at_link_tip(link: Link) -> bool:
    """Whether the translation of P_i was written in frame i, as a listing's r, not before it."""
    return _is_written(link.link_tip_frame.R.T @ link.link_tip_frame.p) and not _is_written(
        link.link_tip_frame.p
    )


def arm_with_link(arm: SerialArm, i: int, link: Link) -> SerialArm:
    """The arm with another link number i, from 0."""
    return replace(arm, links=(*arm.links[:i], link, *arm.links[i + 1 :]))


def _is_written(vector: Array) -> bool:
    return all(abs(x) < 1e-15 or decimals_of(float(x)) is not None for x in vector)
