"""Known mistakes, planted in an arm as they occur in practice.

Written from the names of the mistakes alone: nothing here looks at how
`ur5check._comparison.diagnosis` undoes them.  The numbers are altered where an author alters them,
in the frames of the file: at the link's joint for a URDF, at its tip frame for a DH table.

`plantings` gives every way in which a mistake can be made in one link.  Two mistakes may well come
to the same numbers; `same_inertias` and `same_motion` say so without asking the diagnosis.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, permutations
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ur5check._robot import DHRow, Inertia, Link, SerialArm, Transform, arm_from_dh

__all__ = [
    "GEOMETRY",
    "INERTIAL",
    "MISTAKES",
    "WHOLE_ARM",
    "Planting",
    "Written",
    "in_space",
    "is_nothing",
    "only_moves_the_next_joint",
    "plantings",
    "same_inertias",
    "same_motion",
    "with_written",
    "written",
    "written_inertias",
]

Array = NDArray[np.float64]

#: A mistake that changes less than this share of a number is not planted.
_LEAST = 1e-3

#: Two ways to come to one number to four printed digits cannot be told apart.
_SAME = 1e-4

_TENTHS = (10.0, 0.1, 100.0, 0.01)
_THOUSANDS = (1e3, 1e-3)


@dataclass(frozen=True, eq=False)
class Written:
    """What a file says of one body, in the file's own frame.

    mass [kg];  com, shape (3,) [m];  tensor about it, shape (3, 3) [kg m²]
    """

    mass: float
    com: Array
    tensor: Array


@dataclass(frozen=True, eq=False)
class Planting:
    """One mistake, made in one way.

    mistake : its id;  how : which way
    links : numbers from 1 of the links whose numbers are wrong; empty for the whole arm
    arm : with the mistake
    """

    mistake: str
    how: str
    links: tuple[int, ...]
    arm: SerialArm


# --- numbers as a file holds them -----------------------------------------------------------------


def written(link: Link) -> Written:
    """The numbers of a link in the frame of its source."""
    body = link.inertia.expressed_in(link.source_frame.inverse())
    return Written(body.mass, body.com, body.tensor)


def written_inertias(arm: SerialArm) -> tuple[Written, ...]:
    """Those of all links."""
    return tuple(written(link) for link in arm.links)


def with_written(arm: SerialArm, numbers: dict[int, Written]) -> SerialArm:
    """The arm with other numbers in some links (from 0)."""
    links = list(arm.links)
    for i, body in numbers.items():
        frame = links[i].source_frame
        inertia = Inertia(body.mass, body.com, body.tensor).expressed_in(frame)
        links[i] = replace(links[i], inertia=inertia)
    return replace(arm, links=tuple(links))


def _moved(link: Link, link_tip_frame: Transform, source_frame: Transform) -> Link:
    """The link with another tip frame; what the file says of its bodies stays as it is written."""
    shift = source_frame @ link.source_frame.inverse()
    return replace(
        link,
        link_tip_frame=link_tip_frame,
        source_frame=source_frame,
        inertia=link.inertia.expressed_in(shift),
        welded=tuple((name, body.expressed_in(shift)) for name, body in link.welded),
    )


def _with_link(arm: SerialArm, i: int, link: Link) -> SerialArm:
    return replace(arm, links=(*arm.links[:i], link, *arm.links[i + 1 :]))


# --- files and their conventions ------------------------------------------------------------------

_NOTHING = 1e-9

#: (θ₀, d, a, α) of a fixed transform Rot_z(θ₀) Trans_z(d) Trans_x(a) Rot_x(α).
_Row = tuple[float, float, float, float]


def _kind(arm: SerialArm) -> Literal["urdf", "standard", "modified"]:
    if all(_is_identity(link.link_tip_frame @ link.source_frame) for link in arm.links):
        return "urdf"
    if all(_is_identity(link.source_frame) for link in arm.links):
        return "standard"
    return "modified"


def _is_identity(T: Transform) -> bool:
    return float(np.abs(T.matrix() - np.eye(4)).max()) < 1e-6


def _row(T: Transform) -> _Row:
    theta = float(np.arctan2(T.R[1, 0], T.R[0, 0]))
    alpha = float(np.arctan2(T.R[2, 1], T.R[2, 2]))
    return theta, float(T.p[2]), float(np.cos(theta) * T.p[0] + np.sin(theta) * T.p[1]), alpha


def _from_row(theta: float, d: float, a: float, alpha: float) -> Transform:
    rotation = Transform.rotation((0.0, 0.0, 1.0), theta)
    rest = Transform.translation((a, 0.0, d)) @ Transform.rotation((1.0, 0.0, 0.0), alpha)
    return rotation @ rest


def _with_row(arm: SerialArm, i: int, row: _Row) -> SerialArm:
    """A DH arm with one fixed transform replaced."""
    source_frame = Transform.identity()
    if _kind(arm) == "modified" and i + 1 < arm.n:
        source_frame = _from_row(0.0, 0.0, row[2], row[3]).inverse()
    return _with_link(arm, i, _moved(arm.links[i], _from_row(*row), source_frame))


def _rpy(R: Array) -> Array:
    """Roll, pitch, yaw of URDF; yaw 0 where only their sum is known."""
    if abs(R[2, 0]) > 1.0 - 1e-9:
        pitch = -np.copysign(np.pi / 2, R[2, 0])
        return np.array([np.arctan2(-np.sign(R[2, 0]) * R[0, 1], R[1, 1]), pitch, 0.0])
    angles = np.array(
        [np.arctan2(R[2, 1], R[2, 2]), -np.arcsin(R[2, 0]), np.arctan2(R[1, 0], R[0, 0])]
    )
    angles[np.abs(angles) < 1e-9] = 0.0
    return angles


def _with_origin(arm: SerialArm, i: int, xyz: Array, rpy: Array) -> SerialArm:
    """A URDF arm with the origin of the joint after link i (from 0) replaced."""
    link_tip_frame = Transform.from_rpy(xyz, [float(angle) for angle in rpy])
    return _with_link(arm, i, _moved(arm.links[i], link_tip_frame, link_tip_frame.inverse()))


# --- numbers with an error ------------------------------------------------------------------------


def _adjacent_digits(value: float) -> Iterator[tuple[str, float]]:
    """Two neighbours exchanged among the first five significant digits."""
    text = f"{value:.12g}"
    if "e" in text:
        return
    first = next((k for k, c in enumerate(text) if c in "123456789"), len(text))
    digits = [k for k in range(first, len(text)) if text[k].isdigit()][:5]
    for one, other in pairwise(digits):
        if text[one] != text[other]:
            swapped = list(text)
            swapped[one], swapped[other] = text[other], text[one]
            yield f"{''.join(swapped)} for {text}", float("".join(swapped))


def _lost_signs(v: Array) -> Iterator[tuple[str, Array]]:
    for k in range(3):
        if v[k] != 0.0:
            flipped = v.copy()
            flipped[k] *= -1.0
            yield f"sign of {'xyz'[k]}", flipped
    if np.count_nonzero(v) > 1:
        yield "all signs", -v


def _columns() -> Iterator[tuple[str, list[int]]]:
    for order in permutations(range(3)):
        if order != (0, 1, 2):
            yield "".join("xyz"[k] for k in order), list(order)


def _units(v: Array) -> Iterator[tuple[str, Array]]:
    for factor in _THOUSANDS:
        yield f"all times {factor:g}", v * factor


# --- mistakes in one link's inertial numbers ------------------------------------------------------

_Change = tuple[str, dict[int, Written]]


def _mass_scaled(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    for factor in (*_THOUSANDS, *_TENTHS):
        yield f"times {factor:g}", {i: replace(own, mass=own.mass * factor)}


def _mass_digits(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    for how, mass in _adjacent_digits(own.mass):
        yield how, {i: replace(own, mass=mass)}


def _exchanged(field: str) -> Callable[[SerialArm, int], Iterator[_Change]]:
    def make(arm: SerialArm, i: int) -> Iterator[_Change]:
        own = written(arm.links[i])
        for j in range(arm.n):
            if j != i:
                other = written(arm.links[j])
                yield (
                    f"with link {j + 1}",
                    {
                        i: replace(own, **{field: getattr(other, field)}),
                        j: replace(other, **{field: getattr(own, field)}),
                    },
                )

    return make


def _centre_sign(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    for how, com in _lost_signs(own.com):
        yield how, {i: replace(own, com=com)}


def _centre_other_end(arm: SerialArm, i: int) -> Iterator[_Change]:
    link = arm.links[i]
    own, to_source = written(link), link.source_frame.inverse()
    # Both ends of the link in the frame of the file; the centre is measured from the one which is
    # not the origin there.
    far, joint = to_source.p, (to_source @ link.link_tip_frame.inverse()).p
    how = "from the tip frame" if np.abs(far).max() > np.abs(joint).max() else "from the joint"
    end = far if how == "from the tip frame" else joint
    yield how, {i: replace(own, com=own.com - end)}


def _other_axes(link: Link) -> Array:
    """R with x_other = R x: from the axes of the file to those of the link's other end."""
    to_far = link.source_frame.R
    to_joint = link.link_tip_frame.R @ to_far
    return to_far if np.abs(to_far - np.eye(3)).max() > _NOTHING else to_joint


def _centre_other_frame(arm: SerialArm, i: int) -> Iterator[_Change]:
    own, R = written(arm.links[i]), _other_axes(arm.links[i])
    yield "in the axes of the other end", {i: replace(own, com=R @ own.com)}


def _centre_axes(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    for how, order in _columns():
        yield how, {i: replace(own, com=own.com[order])}


def _centre_scaled(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    for how, com in _units(own.com):
        yield how, {i: replace(own, com=com)}
    for k in range(3):
        for factor in (10.0, 0.1):
            com = own.com.copy()
            com[k] *= factor
            yield f"{'xyz'[k]} times {factor:g}", {i: replace(own, com=com)}


def _tensor_not_rotated(arm: SerialArm, i: int) -> Iterator[_Change]:
    own, R = written(arm.links[i]), _other_axes(arm.links[i])
    yield "in the axes of the other end", {i: replace(own, tensor=R @ own.tensor @ R.T)}


def _tensor_axes(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    for how, order in _columns():
        yield how, {i: replace(own, tensor=own.tensor[np.ix_(order, order)])}


def _parallel_axes(body: Written) -> Array:
    """What the tensor about the origin has more than that about the centre."""
    x, y, z = body.com
    return np.asarray(
        body.mass
        * np.array(
            [[y * y + z * z, -x * y, -x * z], [-x * y, x * x + z * z, -y * z],
             [-x * z, -y * z, x * x + y * y]]
        )
    )  # fmt: skip


def _tensor_about_origin(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    yield "about the origin", {i: replace(own, tensor=own.tensor + _parallel_axes(own))}


def _tensor_parallel_axes(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    added = _parallel_axes(own)
    yield "added twice", {i: replace(own, tensor=own.tensor + 2.0 * added)}
    yield "taken off from the centre's", {i: replace(own, tensor=own.tensor - added)}


def _tensor_product_signs(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    mirror = {"all": None, "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
    for name, entry in mirror.items():
        tensor = own.tensor.copy()
        if entry is None:
            tensor = 2.0 * np.diag(np.diag(tensor)) - tensor
        else:
            tensor[entry] *= -1.0
            tensor[entry[::-1]] *= -1.0
        yield name, {i: replace(own, tensor=tensor)}


#: Orders in which the six entries are listed: by rows (URDF), by columns (Pinocchio), the diagonal
#: first (MuJoCo's fullinertia), Voigt's.
_ORDERS = {
    "by rows": ("xx", "xy", "xz", "yy", "yz", "zz"),
    "by columns": ("xx", "xy", "yy", "xz", "yz", "zz"),
    "diagonal first": ("xx", "yy", "zz", "xy", "xz", "yz"),
    "Voigt": ("xx", "yy", "zz", "yz", "xz", "xy"),
}


def _tensor_entry_order(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    slots = _ORDERS["by rows"]
    for how in ("by columns", "diagonal first", "Voigt"):
        tensor = np.zeros((3, 3))
        for slot, entry in zip(slots, _ORDERS[how], strict=True):
            row, column = ("xyz".index(letter) for letter in slot)
            value = own.tensor["xyz".index(entry[0]), "xyz".index(entry[1])]
            tensor[row, column] = tensor[column, row] = value
        yield f"{how}, read by rows", {i: replace(own, tensor=tensor)}


def _cylinder(body: Written) -> tuple[int, float, float] | None:
    """(axis, radius, length) of the solid cylinder that this body is, or None."""
    moments = np.diag(body.tensor)
    if body.mass <= 0.0 or np.abs(body.tensor - np.diag(moments)).max() > _SAME * moments.max():
        return None
    for axis in (2, 0, 1):
        one, other = np.delete(moments, axis)
        radius_squared = 2.0 * moments[axis] / body.mass
        length_squared = 12.0 * one / body.mass - 3.0 * radius_squared
        if abs(one - other) < _SAME * one and radius_squared > 0.0 and length_squared > 1e-6:
            return axis, float(np.sqrt(radius_squared)), float(np.sqrt(length_squared))
    return None


def _cylinder_moments(axis: int, along: float, across: float) -> Array:
    moments = np.full(3, across)
    moments[axis] = along
    return np.diag(moments)


def _cylinder_mistake(
    wrong: Callable[[float, float, float], Iterator[tuple[str, float, float]]],
) -> Callable[[SerialArm, int], Iterator[_Change]]:
    """From (mass, radius, length) to the moments along and across that the author computed."""

    def make(arm: SerialArm, i: int) -> Iterator[_Change]:
        own = written(arm.links[i])
        found = _cylinder(own)
        if found is not None:
            axis, radius, length = found
            for how, along, across in wrong(own.mass, radius, length):
                tensor = _cylinder_moments(axis, along, across)
                yield f"{how}, along {'xyz'[axis]}", {i: replace(own, tensor=tensor)}

    return make


def _three_r_squared(m: float, r: float, length: float) -> Iterator[tuple[str, float, float]]:
    yield "(3r)² for 3r²", m * r**2 / 2.0, m * ((3.0 * r) ** 2 + length**2) / 12.0


def _wrong_radius(m: float, r: float, length: float) -> Iterator[tuple[str, float, float]]:
    for factor in (2.0, 0.5, 10.0, 0.1):
        wrong = factor * r
        yield f"r times {factor:g}", m * wrong**2 / 2.0, m * (3.0 * wrong**2 + length**2) / 12.0


def _wrong_length(m: float, r: float, length: float) -> Iterator[tuple[str, float, float]]:
    for factor in (2.0, 0.5, 10.0, 0.1):
        wrong = factor * length
        yield f"l times {factor:g}", m * r**2 / 2.0, m * (3.0 * r**2 + wrong**2) / 12.0


def _rounded_twelfth(m: float, r: float, length: float) -> Iterator[tuple[str, float, float]]:
    for twelfth in (0.083, 0.0833):
        yield f"{twelfth} for 1/12", m * r**2 / 2.0, twelfth * m * (3.0 * r**2 + length**2)


def _tensor_scaled(arm: SerialArm, i: int) -> Iterator[_Change]:
    own = written(arm.links[i])
    for factor in (*_THOUSANDS, *_TENTHS, 1e4, 1e-4, 1e6, 1e-6):
        yield f"times {factor:g}", {i: replace(own, tensor=own.tensor * factor)}


#: id to the ways in which it changes what a file says of a body.
INERTIAL: dict[str, Callable[[SerialArm, int], Iterator[_Change]]] = {
    "mass-scaled": _mass_scaled,
    "mass-digits": _mass_digits,
    "mass-exchanged": _exchanged("mass"),
    "centre-sign": _centre_sign,
    "centre-other-end": _centre_other_end,
    "centre-other-frame": _centre_other_frame,
    "centre-axes": _centre_axes,
    "centre-scaled": _centre_scaled,
    "centre-exchanged": _exchanged("com"),
    "tensor-not-rotated": _tensor_not_rotated,
    "tensor-axes": _tensor_axes,
    "tensor-about-origin": _tensor_about_origin,
    "tensor-parallel-axes": _tensor_parallel_axes,
    "tensor-product-signs": _tensor_product_signs,
    "tensor-entry-order": _tensor_entry_order,
    "cylinder-3r-squared": _cylinder_mistake(_three_r_squared),
    "cylinder-radius": _cylinder_mistake(_wrong_radius),
    "cylinder-length": _cylinder_mistake(_wrong_length),
    "cylinder-twelfth": _cylinder_mistake(_rounded_twelfth),
    "tensor-scaled": _tensor_scaled,
    "tensor-exchanged": _exchanged("tensor"),
}


# --- mistakes in bodies that are fixed to a link --------------------------------------------------

_Mutant = tuple[str, SerialArm]


def _body_dropped(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    link = arm.links[i]
    for k, (name, body) in enumerate(link.welded):
        left = link.inertia.parameters() - body.parameters()
        if body.mass >= _LEAST * link.inertia.mass and left[0] > _LEAST * link.inertia.mass:
            welded = link.welded[:k] + link.welded[k + 1 :]
            mutant = replace(link, inertia=Inertia.from_parameters(left), welded=welded)
            yield name, _with_link(arm, i, mutant)


def _body_twice(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    link = arm.links[i]
    for name, body in link.welded:
        if body.mass >= _LEAST * link.inertia.mass:
            yield name, _with_link(arm, i, replace(link, inertia=link.inertia + body))


# --- mistakes in one link's geometry --------------------------------------------------------------


def _reach_sign(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    link_tip_frame = arm.links[i].link_tip_frame
    if _kind(arm) == "urdf":
        for how, xyz in _lost_signs(link_tip_frame.p):
            yield how, _with_origin(arm, i, xyz, _rpy(link_tip_frame.R))
    else:
        theta, d, a, alpha = _row(link_tip_frame)
        yield "sign of d", _with_row(arm, i, (theta, -d, a, alpha))
        yield "sign of a", _with_row(arm, i, (theta, d, -a, alpha))


def _reach_axes(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    link_tip_frame = arm.links[i].link_tip_frame
    if _kind(arm) == "urdf":
        for how, order in _columns():
            yield how, _with_origin(arm, i, link_tip_frame.p[order], _rpy(link_tip_frame.R))
    else:
        theta, d, a, alpha = _row(link_tip_frame)
        yield "d and a exchanged", _with_row(arm, i, (theta, a, d, alpha))


def _reach_scaled(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    link_tip_frame = arm.links[i].link_tip_frame
    if _kind(arm) == "urdf":
        for how, xyz in _units(link_tip_frame.p):
            yield how, _with_origin(arm, i, xyz, _rpy(link_tip_frame.R))
        for k in range(3):
            for factor in (10.0, 0.1):
                xyz = link_tip_frame.p.copy()
                xyz[k] *= factor
                how = f"{'xyz'[k]} times {factor:g}"
                yield how, _with_origin(arm, i, xyz, _rpy(link_tip_frame.R))
    else:
        theta, d, a, alpha = _row(link_tip_frame)
        for factor in _THOUSANDS:
            how = f"d and a times {factor:g}"
            yield how, _with_row(arm, i, (theta, d * factor, a * factor, alpha))
        for factor in (10.0, 0.1):
            yield f"d times {factor:g}", _with_row(arm, i, (theta, d * factor, a, alpha))
            yield f"a times {factor:g}", _with_row(arm, i, (theta, d, a * factor, alpha))


def _reach_exchanged(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    for j in range(arm.n):
        if j != i:
            one, other = arm.links[i].link_tip_frame, arm.links[j].link_tip_frame
            if _kind(arm) == "urdf":
                mutant = _with_origin(arm, i, other.p, _rpy(one.R))
                yield f"with link {j + 1}", _with_origin(mutant, j, one.p, _rpy(other.R))
            else:
                (theta, d, a, alpha), (theta_j, d_j, a_j, alpha_j) = _row(one), _row(other)
                mutant = _with_row(arm, i, (theta, d_j, a_j, alpha))
                yield f"with link {j + 1}", _with_row(mutant, j, (theta_j, d, a, alpha_j))


def _angles(
    arm: SerialArm, i: int, wrong: Callable[[Array], Iterator[tuple[str, Array]]]
) -> Iterator[_Mutant]:
    """The angles that a file writes for a link: rpy, or α alone."""
    link_tip_frame = arm.links[i].link_tip_frame
    if _kind(arm) == "urdf":
        for how, rpy in wrong(_rpy(link_tip_frame.R)):
            yield how, _with_origin(arm, i, link_tip_frame.p, rpy)
    else:
        theta, d, a, alpha = _row(link_tip_frame)
        for how, angles in wrong(np.array([alpha])):
            yield how, _with_row(arm, i, (theta, d, a, float(angles[0])))


def _turn_sign(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    def wrong(angles: Array) -> Iterator[tuple[str, Array]]:
        for k, angle in enumerate(angles):
            if angle != 0.0:
                flipped = angles.copy()
                flipped[k] *= -1.0
                yield f"{angles[k]:.4g} read as {flipped[k]:.4g}", flipped

    yield from _angles(arm, i, wrong)


def _turn_dropped(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    def wrong(angles: Array) -> Iterator[tuple[str, Array]]:
        yield "no angle", np.zeros_like(angles)

    yield from _angles(arm, i, wrong)


def _turn_degrees(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    def wrong(angles: Array) -> Iterator[tuple[str, Array]]:
        degrees = np.round(np.degrees(angles), 6)
        yield f"{degrees.tolist()} read as radians", degrees

    yield from _angles(arm, i, wrong)


def _turn_rounded(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    def wrong(angles: Array) -> Iterator[tuple[str, Array]]:
        quarters = np.rint(angles / (np.pi / 2))
        right = (quarters != 0) & (np.abs(angles - quarters * np.pi / 2) < 1e-6)
        for half, pi in ((1.57, 3.14), (1.571, 3.142), (1.5707, 3.1415)):
            rounded = np.array(
                [
                    np.sign(k) * (half if abs(k) == 1 else pi) if is_right else angle
                    for angle, k, is_right in zip(angles, quarters, right, strict=True)
                ]
            )
            if right.any():
                yield f"{half} for π/2, {pi} for π", rounded

    yield from _angles(arm, i, wrong)


def _joint_reversed(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    joint = replace(arm.joints[i], axis=-arm.joints[i].axis)
    yield "axis reversed", replace(arm, joints=(*arm.joints[:i], joint, *arm.joints[i + 1 :]))


def _zero_shifted(arm: SerialArm, i: int) -> Iterator[_Mutant]:
    if i == 0:
        return  # a turn of the base, and planted as such
    sizes = (0.1, -0.05) if arm.joints[i].kind == "prismatic" else (np.pi / 2, -np.pi / 2, np.pi, 1)
    for size in sizes:
        motion = arm.joints[i].motion(float(size))
        if _kind(arm) == "urdf":  # in the origin of the joint, which ends the link before it
            link = arm.links[i - 1]
            link_tip_frame = link.link_tip_frame @ motion
            mutant = _with_link(arm, i - 1, _moved(link, link_tip_frame, link_tip_frame.inverse()))
        else:  # in the row's θ or d
            link = arm.links[i]
            mutant = _with_link(arm, i, replace(link, link_tip_frame=motion @ link.link_tip_frame))
        yield f"by {size:.4g}", mutant


#: id to the ways in which it moves a link.
GEOMETRY: dict[str, Callable[[SerialArm, int], Iterator[_Mutant]]] = {
    "length-sign": _reach_sign,
    "length-axes": _reach_axes,
    "length-scaled": _reach_scaled,
    "length-exchanged": _reach_exchanged,
    "rotation-sign": _turn_sign,
    "rotation-dropped": _turn_dropped,
    "rotation-degrees": _turn_degrees,
    "rotation-rounded": _turn_rounded,
    "joint-reversed": _joint_reversed,
    "zero-shifted": _zero_shifted,
}

_BODIES: dict[str, Callable[[SerialArm, int], Iterator[_Mutant]]] = {
    "body-dropped": _body_dropped,
    "body-twice": _body_twice,
}


# --- mistakes of the whole arm --------------------------------------------------------------------


def _dh_convention(arm: SerialArm) -> Iterator[_Mutant]:
    kind = _kind(arm)
    if kind == "urdf":
        return
    rows = [_row(link.link_tip_frame) for link in arm.links]
    if kind == "modified":
        after, base = [(a, alpha) for *_, a, alpha in rows], _row(arm.base)
        before = [base[2:], *after[:-1]]
        rows = [(*row[:2], *pair) for row, pair in zip(rows, before, strict=True)]
    table = []
    for (theta, d, a, alpha), joint, link in zip(rows, arm.joints, arm.links, strict=True):
        body = written(link)
        inertia = Inertia(body.mass, body.com, body.tensor)
        table.append(
            DHRow(link.name, d, a, alpha, inertia, joint.name, theta, joint.kind, joint.limits)
        )
    other: Literal["standard", "modified"] = "modified" if kind == "standard" else "standard"
    mutant = arm_from_dh(arm.name, table, convention=other, gravity=arm.gravity, source=arm.source)
    yield f"{kind} read as {other}", mutant


def _base_turned(arm: SerialArm) -> Iterator[_Mutant]:
    vertical = arm.gravity / np.linalg.norm(arm.gravity)
    for angle in (np.pi, np.pi / 2, -np.pi / 2):
        rotation = Transform.rotation(vertical, angle)
        yield (
            f"by {np.degrees(angle):.0f}° about the vertical",
            replace(arm, base=rotation @ arm.base),
        )


def _gravity_sign(arm: SerialArm) -> Iterator[_Mutant]:
    yield "upwards", arm.with_gravity(-arm.gravity)


def _gravity_value(arm: SerialArm) -> Iterator[_Mutant]:
    size = float(np.linalg.norm(arm.gravity))
    for other in (9.8, 9.80665, 10.0):
        yield f"{other} for {size:.6g}", arm.with_gravity(arm.gravity * (other / size))


WHOLE_ARM: dict[str, Callable[[SerialArm], Iterator[_Mutant]]] = {
    "dh-convention": _dh_convention,
    "base-turned": _base_turned,
    "gravity-sign": _gravity_sign,
    "gravity-value": _gravity_value,
}

#: Every id, in the order of the report.
MISTAKES = (*INERTIAL, *_BODIES, *GEOMETRY, *WHOLE_ARM)


def plantings(mistake: str, arm: SerialArm, link: int) -> Iterator[Planting]:
    """Every way to make a mistake in link number `link` (from 1), as long as it changes something.

    A mistake of the whole arm is made with link 1, once.
    """
    if mistake in INERTIAL:
        for how, change in INERTIAL[mistake](arm, link - 1):
            if not _changes_little(mistake, arm, change):
                links = tuple(sorted(i + 1 for i in change))
                yield Planting(mistake, how, links, with_written(arm, change))
    elif mistake in _BODIES:
        for how, mutant in _BODIES[mistake](arm, link - 1):
            yield Planting(mistake, how, (link,), mutant)
    elif mistake in GEOMETRY:
        for how, mutant in GEOMETRY[mistake](arm, link - 1):
            if not is_nothing(arm, mutant):
                yield Planting(mistake, how, (link,), mutant)
    elif link == 1:
        for how, mutant in WHOLE_ARM[mistake](arm):
            yield Planting(mistake, how, (), mutant)


def _changes_little(mistake: str, arm: SerialArm, change: dict[int, Written]) -> bool:
    # What is written with three or four digits changes less than the others, and on purpose.
    least = 1e-4 if mistake == "cylinder-twelfth" else _LEAST
    return _same_written({i: written(arm.links[i]) for i in change}, change, least)


def _same_written(one: dict[int, Written], other: dict[int, Written], tolerance: float) -> bool:
    return all(
        _close(getattr(one[i], field), getattr(other[i], field), tolerance)
        for i in one
        for field in ("mass", "com", "tensor")
    )


def _close(one: Array | float, other: Array | float, tolerance: float) -> bool:
    size = max(float(np.linalg.norm(one)), float(np.linalg.norm(other)))
    apart = float(np.linalg.norm(np.asarray(one) - np.asarray(other)))
    return apart <= tolerance * size or apart < 1e-12


# --- mistakes with the same result ----------------------------------------------------------------


def same_inertias(one: SerialArm, other: SerialArm, places: Sequence[int]) -> bool:
    """Whether two arms of one geometry carry the same numbers in these links (from 0)."""
    return all(
        _close(one.links[i].inertia.mass, other.links[i].inertia.mass, _SAME)
        and _close(one.links[i].inertia.tensor, other.links[i].inertia.tensor, _SAME)
        and _close(written(one.links[i]).com, written(other.links[i]).com, _SAME)
        for i in places
    )


def only_moves_the_next_joint(arm: SerialArm, planting: Planting) -> bool:
    """Whether a link's changed geometry is nothing but another zero of the joint after it."""
    i = planting.links[0]
    if i == arm.n or planting.mistake.split("-")[0] not in ("link_vector", "rotation"):
        return False
    change = arm.links[i - 1].link_tip_frame.inverse() @ planting.arm.links[i - 1].link_tip_frame
    axis = arm.joints[i].axis
    if arm.joints[i].kind == "prismatic":
        across = change.p - (axis @ change.p) * axis
        return change.angle() < 1e-9 and float(np.abs(across).max()) < 1e-9
    return bool(np.abs(change.R @ axis - axis).max() < 1e-9 and np.abs(change.p).max() < 1e-9)


def is_nothing(arm: SerialArm, mutant: SerialArm) -> bool:
    """Whether a change of geometry moves no axis and no body: that of a URDF's last link does not,
    it moves the tool only."""
    return same_motion(in_space(arm), in_space(mutant), 1e-7)


def in_space(arm: SerialArm) -> tuple[Array, Array]:
    """Axes and bodies in the base frame at q = 0, which determine the motion at every q.

    Directions and moments of the axes, shape (n, 6); mass, first and second moments of the bodies,
    shape (n, 10).
    """
    T, axes, bodies = arm.base, [], []
    for joint, link in zip(arm.joints, arm.links, strict=True):
        axis = T.R @ joint.axis
        about = np.zeros(3) if joint.kind == "prismatic" else np.cross(T.p, axis)
        axes.append([*axis, *about])
        T = T @ link.link_tip_frame
        bodies.append(link.inertia.expressed_in(T).parameters())
    return np.array(axes), np.array(bodies)


def same_motion(
    one: tuple[Array, Array], other: tuple[Array, Array], tolerance: float = 1e-6
) -> bool:
    """Whether two arms, as `in_space` has them, move alike under the same torques."""
    axes = float(np.abs(one[0] - other[0]).max())
    bodies = np.abs(one[1] - other[1]) / (1e-3 + np.abs(one[1]).max(axis=1, keepdims=True))
    return axes < tolerance and float(bodies.max()) < tolerance
