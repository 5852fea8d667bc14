"""A DH table read by the other convention's rule.

In the standard convention a row's a and α come after its joint, in the modified one (Craig's)
before it.  Both give fixed transforms of one form, P = Rot_z(θ₀) Trans_z(d) Trans_x(a) Rot_x(α);
reading by the wrong rule moves every (a, α) to the neighbouring joint.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Transform

__all__ = ["read_by_the_other_rule"]

_X, _Z = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)
_NOTHING = 1e-9

#: (offset, d, a, α) of one fixed transform.
_Row = tuple[float, float, float, float]


def read_by_the_other_rule(arm: SerialArm) -> list[SerialArm]:
    """The arm as its DH table reads by the other convention; empty if it comes from no DH table."""
    if any(abs(joint.axis[2] - 1.0) > _NOTHING for joint in arm.joints):
        return []
    base = _row(arm.base)
    rows = [_row(link.link_tip_frame) for link in arm.links]
    if base is None or any(row is None for row in rows):
        return []
    table = [row for row in rows if row is not None]
    offset, d, a_0, alpha_0 = base
    if abs(offset) > _NOTHING or abs(d) > _NOTHING:
        return []
    if abs(a_0) < _NOTHING and abs(alpha_0) < _NOTHING:
        shifted = [(a, alpha) for _, _, a, alpha in table]  # standard, to be read as modified
        first, after = shifted[0], [*shifted[1:], (0.0, 0.0)]
    else:
        before = [(a_0, alpha_0), *((a, alpha) for _, _, a, alpha in table)]
        first, after = (0.0, 0.0), before[: arm.n]
    link_tip_frames = [
        _transform((offset, d, a, alpha))
        for (offset, d, _, _), (a, alpha) in zip(table, after, strict=True)
    ]
    links = []
    for link, link_tip_frame, (a, alpha) in zip(arm.links, link_tip_frames, after, strict=True):
        # The numbers stay as written: in the frame that the other rule puts at that row.
        standard = first == (0.0, 0.0)
        frame = Transform.identity() if standard else _transform((0.0, 0.0, a, alpha)).inverse()
        written = link.inertia.expressed_in(link.source_frame.inverse())
        links.append(
            replace(
                link,
                link_tip_frame=link_tip_frame,
                source_frame=frame,
                inertia=written.expressed_in(frame),
            )
        )
    return [replace(arm, base=_transform((0.0, 0.0, *first)), links=tuple(links))]


def _row(T: Transform) -> _Row | None:
    if abs(T.R[2, 0]) > _NOTHING:
        return None
    offset = float(np.arctan2(T.R[1, 0], T.R[0, 0]))
    a, across, d = Transform.rotation(_Z, -offset).R @ T.p
    if abs(across) > _NOTHING:
        return None
    return offset, float(d), float(a), float(np.arctan2(T.R[2, 1], T.R[2, 2]))


def _transform(row: _Row) -> Transform:
    offset, d, a, alpha = row
    return (
        Transform.rotation(_Z, offset)
        @ Transform.translation((a, 0.0, d))
        @ Transform.rotation(_X, alpha)
    )
