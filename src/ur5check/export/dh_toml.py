"""A `SerialArm` as a DH table in a TOML file, for arms whose frames are standard DH frames.

P_i = Rot_z(offset) Trans_z(d) Trans_x(a) Rot_x(α) says of its rotation only that the third row
begins with a zero; offset and α are then read off.  Its translation must lie along z and along the
turned x.  Where it does not, as in a listing that wrote r_{i−1,i} out by hand, the row carries `r`,
which then stands in place of d and a (see `DHRow`).
"""

from __future__ import annotations

import json
from collections.abc import Iterable

import numpy as np

from ..arm.serial_arm import Joint, Link, SerialArm
from ..errors import UsageError
from ..version import __version__
from .numbers import as_written, exact

__all__ = ["dh_toml_of"]

_ROUNDING = 8 * float(np.finfo(np.float64).eps)


def dh_toml_of(arm: SerialArm) -> str:
    """The text of a `ur5check.dh/1` file that describes this arm.

    Raises UsageError where the arm's frames are no standard DH frames; `urdf_of` writes any arm.
    """
    if not np.array_equal(arm.base.matrix(), np.eye(4)):
        _refuse(arm, "its base frame is not where its first joint is")
    lines = [f"# Written by ur5check {__version__}."]
    lines += [f"# Read from {name!r} (SHA-256 {digest})" for name, digest in arm.source.inputs]
    lines += [
        "",
        'schema = "ur5check.dh/1"',
        f"name = {_text(arm.name)}",
        'convention = "standard"',
        f"gravity = {_list(arm.gravity)}",
    ]
    for joint, link in zip(arm.joints, arm.links, strict=True):
        lines += ["", "[[joint]]", *_row(arm, joint, link)]
    return "\n".join([*lines, ""])


def _row(arm: SerialArm, joint: Joint, link: Link) -> list[str]:
    R, p = link.far_end.R, link.far_end.p
    if not np.array_equal(joint.axis, (0.0, 0.0, 1.0)):
        _refuse(arm, f"joint {joint.name!r} does not turn about z")
    if abs(R[2, 0]) > _ROUNDING:
        _refuse(arm, f"the next joint's axis is reached from {link.name!r} by more than one angle")
    offset, alpha = float(np.arctan2(R[1, 0], R[0, 0])), float(np.arctan2(R[2, 1], R[2, 2]))
    a, d = as_written(float(R[:, 0] @ p), _ROUNDING * float(np.abs(p).max())), float(p[2])
    lines = [f"joint = {_text(joint.name)}", f"link = {_text(link.name)}"]
    lines += ['kind = "prismatic"'] if joint.kind == "prismatic" else []
    lines += [f"d = {exact(d)}", f"a = {exact(a)}", f"alpha = {exact(alpha)}"]
    lines += [f"offset = {exact(offset)}"] if offset else []
    astray = np.abs(p - a * R[:, 0] - np.array([0.0, 0.0, d])).max()
    if astray > _ROUNDING * max(1.0, float(np.abs(p).max())):
        r = [as_written(x, _ROUNDING * float(np.abs(p).max())) for x in R.T @ p]
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
        f"inertia = {_table(written)}",
    ]
    names = ("lower", "upper", "velocity", "effort")
    limits = {key: value for key in names if (value := getattr(joint.limits, key)) is not None}
    return lines + ([f"limits = {_table(limits)}"] if limits else [])


def _refuse(arm: SerialArm, why: str) -> None:
    raise UsageError(f"{arm.name!r} is no standard DH table: {why}; write it as a URDF instead")


def _text(text: str) -> str:
    # A JSON string is a TOML string, but for the control character DEL.
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _list(values: Iterable[float]) -> str:
    return f"[{', '.join(exact(value) for value in values)}]"


def _table(values: dict[str, float]) -> str:
    return f"{{ {', '.join(f'{key} = {exact(value)}' for key, value in values.items())} }}"
