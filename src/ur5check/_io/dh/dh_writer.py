"""A `SerialArm` as a DH table in a TOML file.

An arm whose frames are no standard DH frames is given such frames first (`dh_frames`), and then
perhaps a `base` and a `tool`.  A rotation P_i = Rot_z(offset) Trans_z(d) Trans_x(a) Rot_x(α) has a
zero at the start of its third
row; offset and α are then read off.  Its translation must lie along z and the rotated x.  Where it
does not, as in a listing that wrote
r_{i−1,i} out by hand, the row carries `r`, which then stands in place of d and a (see `DHRow`).
"""

from __future__ import annotations

import json
from collections.abc import Iterable

import numpy as np

from ..._robot.serial_arm import Joint, Link, SerialArm
from ..._robot.transforms import Transform
from ..._version import __version__
from ..number_text import as_written, exact
from ..round_trip import angle, rpy_pose
from .dh_frames import ROUNDING, dh_frames

__all__ = ["dh_toml_of"]

_DECIMALS = 14  # of a length [m] or angle [rad]: wider than the rounding of recomputed frames


def dh_toml_of(arm: SerialArm) -> str:
    """The text of a `ur5check.dh/1` file that describes this arm, by the standard convention.

    Raises UsageError where two nearly parallel axes would make the table unbounded.
    """
    links, base, tool = arm.links, Transform.identity(), Transform.identity()
    by_hand = _has_rows(arm)
    if not by_hand:
        frames = dh_frames(arm)
        links, base, tool = frames.links, frames.base, frames.tool
    lines = [f"# Written by ur5check {__version__}."]
    lines += [f"# Read from {name!r} (SHA-256 {digest})" for name, digest in arm.source.inputs]
    lines += [
        "",
        'schema = "ur5check.dh/1"',
        f"name = {_text(arm.name)}",
        'convention = "standard"',
        f"gravity = {_list(arm.gravity)}",
    ]
    for key, T in (("base", base), ("tool", tool)):
        if not np.array_equal(T.matrix(), np.eye(4)):
            pose = rpy_pose(T, _DECIMALS)
            xyz = [round(value, _DECIMALS) for value in pose.xyz]
            lines.append(f"{key} = {{ xyz = {_list(xyz)}, rpy = {_list(pose.turn)} }}")
    for joint, link in zip(arm.joints, links, strict=True):
        lines += ["", "[[joint]]", *_row(joint, link, by_hand=by_hand)]
    return "\n".join([*lines, ""])


def _has_rows(arm: SerialArm) -> bool:
    """Whether the arm's own frames are those of a table, with or without explicit vectors r."""
    return (
        np.array_equal(arm.base.matrix(), np.eye(4))
        and all(np.array_equal(joint.axis, (0.0, 0.0, 1.0)) for joint in arm.joints)
        and all(abs(link.link_tip_frame.R[2, 0]) <= ROUNDING for link in arm.links)
    )


def _row(joint: Joint, link: Link, *, by_hand: bool) -> list[str]:
    R, p = link.link_tip_frame.R, link.link_tip_frame.p
    offset = _angle(float(np.arctan2(R[1, 0], R[0, 0])))
    alpha = _angle(float(np.arctan2(R[2, 1], R[2, 2])))
    a, d = round(float(R[:, 0] @ p), _DECIMALS), round(float(p[2]), _DECIMALS)
    lines = [f"joint = {_text(joint.name)}", f"link = {_text(link.name)}"]
    lines += ['kind = "prismatic"'] if joint.kind == "prismatic" else []
    lines += [f"d = {exact(d)}", f"a = {exact(a)}", f"alpha = {exact(alpha)}"]
    lines += [f"offset = {exact(offset)}"] if offset else []
    scale = max(1.0, float(np.abs(p).max()))
    astray = np.abs(p - a * R[:, 0] - np.array([0.0, 0.0, d])).max()
    if by_hand and astray > ROUNDING * scale:
        r = [as_written(x, ROUNDING / 8 * float(np.abs(p).max())) for x in R.T @ p]
        lines.append(f"r = {_list(r)}  # stands in place of d and a, which do not give it")
    tensor = link.inertia.tensor
    entries = {
        f"i{u}{v}": float(tensor["xyz".index(u), "xyz".index(v)])
        for u, v in ("xx", "yy", "zz", "xy", "xz", "yz")
    }
    written = {key: value for key, value in entries.items() if value or key[1] == key[2]}
    lines += [
        f"mass = {exact(link.inertia.mass)}",
        f"com = {_list(link.inertia.com)}",
    ]
    lines += [f"inertia = {_table(written)}"] if link.tensor_known else []
    motor = ("armature", "damping", "friction")
    lines += [f"{key} = {exact(value)}" for key in motor if (value := getattr(joint, key))]
    names = ("lower", "upper", "velocity", "effort")
    limits = {key: value for key in names if (value := getattr(joint.limits, key)) is not None}
    return lines + ([f"limits = {_table(limits)}"] if limits else [])


def _angle(value: float) -> float:
    """Rounded to the grid; a quarter turn where several rotations give it to rounding."""
    quarter = round(value / (np.pi / 2)) * (np.pi / 2)
    return quarter if abs(value - quarter) <= ROUNDING else angle(value, _DECIMALS)


def _text(text: str) -> str:
    # A JSON string is a TOML string, but for the control character DEL.
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _list(values: Iterable[float]) -> str:
    return f"[{', '.join(exact(value) for value in values)}]"


def _table(values: dict[str, float]) -> str:
    return f"{{ {', '.join(f'{key} = {exact(value)}' for key, value in values.items())} }}"
