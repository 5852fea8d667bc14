"""The known mistakes, the likelier first: where two repair equally well, the earlier is named
first.

Sources: what users reported (docs/diagnosis.md lists the threads) and the mistakes of the paper
itself.  A `link_vector` is r_{i−1,i} of a DH listing or the next joint's origin of a URDF; a
`rotation` is a DH α or an origin's rpy.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..._robot.inertia import Inertia
from ..._robot.transforms import Array, Transform
from .cylinder_fit import Cylinder, fit_cylinder
from .link_numbers import LinkPair
from .mistake import Mistake, Quantity, Repair, value_of
from .number_mistakes import (
    DECADES,
    axis_swaps,
    digit_swaps,
    shifted_decimals,
    sign_flips,
    words_of,
)

__all__ = ["MISTAKES"]

#: What ids call a quantity, where it is not the field's name.
_NAMES: dict[Quantity, str] = {"link_vector": "length"}


# --- any vector ----------------------------------------------------------------------------------


def _signs(quantity: Quantity) -> Mistake:
    def repairs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
        v: Array = value_of(link_pair.bodies[i], quantity)
        yield from sign_flips(v)
        if np.count_nonzero(v) > 1:
            yield "all signs", -v

    what = "the length" if quantity == "link_vector" else "the centre of mass"
    return Mistake(
        f"{_NAMES.get(quantity, quantity)}-sign",
        quantity,
        f"a sign of {what} is lost",
        "write the sign",
        repairs,
    )


def _swapped_axes(quantity: Quantity) -> Mistake:
    def repairs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
        for how, permutation in axis_swaps():
            yield how, permutation @ value_of(link_pair.bodies[i], quantity)

    what = "the offset" if quantity == "link_vector" else "the centre of mass"
    return Mistake(
        f"{_NAMES.get(quantity, quantity)}-axes",
        quantity,
        f"{what} has its components on the wrong axes",
        "write each component on its own axis",
        repairs,
    )


def _scaled(quantity: Quantity, says: str, repair: str) -> Mistake:
    def repairs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
        value = value_of(link_pair.bodies[i], quantity)
        for factor in DECADES:
            yield words_of(factor), factor * value
        if quantity in ("centre", "link_vector"):
            yield from shifted_decimals(value)

    # Not in pairs: shrunk to nothing, a number takes any mistake that adds something.
    return Mistake(
        f"{_NAMES.get(quantity, quantity)}-scaled", quantity, says, repair, repairs, alone=True
    )


def _exchanged(quantity: Quantity) -> Mistake:
    def repairs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
        mine, mine_due = (
            value_of(side[i], quantity) for side in (link_pair.bodies, link_pair.truth)
        )
        for j, other in enumerate(link_pair.bodies):
            # An exchange goes both ways: what stands here is what the other link should have.  Two
            # links that should have nearly the same (a UR5's wrists) must have it to the digit.
            due = value_of(link_pair.truth[j], quantity)
            size = np.linalg.norm(due)
            nearly = 0.1 if np.linalg.norm(mine_due - due) > 0.1 * size else 1e-4
            if j != i and np.linalg.norm(mine - due) < nearly * size:
                yield f"with link {j + 1}", value_of(other, quantity)

    words = {
        "mass": "mass",
        "centre": "centre of mass",
        "tensor": "tensor",
        "link_vector": "length",
    }
    return Mistake(
        f"{_NAMES.get(quantity, quantity)}-exchanged",
        quantity,
        f"the {words[quantity]} is exchanged with another link's",
        "put each link's numbers into its own row",
        repairs,
        alone=True,
    )


# --- mass ----------------------------------------------------------------------------------------


def _mass_digits(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    # Two neighbouring digits further back make a difference that any two measurements have: the
    # repaired number must be the other one, digit by digit.
    for how, repaired in digit_swaps(link_pair.bodies[i].mass):
        if abs(repaired - link_pair.truth[i].mass) <= 1e-9 * repaired:
            yield how, repaired


# --- centre of mass ------------------------------------------------------------------------------


def _other_end(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    body = link_pair.bodies[i]
    if body.link_vector.any():
        yield "from the tip frame instead of the joint", body.com + body.link_vector
        yield "from the joint instead of the tip frame", body.com - body.link_vector


def _other_frame(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    body = link_pair.bodies[i]
    if Transform(body.rotation, np.zeros(3)).angle() > 1e-9:
        yield "in the axes of the link's tip frame", body.rotation @ body.com
        yield "in the axes of the link's joint", body.rotation.T @ body.com


def _middle_of_shape(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    """A centre that is a point of the link's shape, not a measured one.

    Two models that differ by a few per cent here may both be measured: only a centre that is off by
    more than any measurement is put down to this.
    """
    body, truth = link_pair.bodies[i], link_pair.truth[i].com
    apart = float(np.linalg.norm(body.com - truth))
    size = max(float(np.linalg.norm(other.link_vector)) for other in link_pair.bodies)
    far = max(float(np.linalg.norm(body.com)), float(np.linalg.norm(truth)))
    fitted = fit_cylinder(body.mass, body.tensor)
    if fitted is None or apart < max(0.15 * far, 0.03 * size):
        return
    half = 0.5 * fitted.length * np.eye(3)[fitted.axis]
    middles = {
        "at its frame's origin": np.zeros(3),
        "half the cylinder's length from it": half,
        "half the cylinder's length behind it": -half,
        "half way along the link": 0.5 * body.link_vector,
        "at the link's tip frame": body.link_vector,
        "half the cylinder's length before the tip frame": body.link_vector
        - _along(body.link_vector, fitted),
    }
    for how, middle in middles.items():
        if np.linalg.norm(body.com - middle) <= 1e-6:
            yield how, truth


def _along(link_vector: Array, fitted: Cylinder) -> Array:
    length = float(np.linalg.norm(link_vector))
    return link_vector * (0.5 * fitted.length / length) if length > 0.0 else link_vector


# --- body ----------------------------------------------------------------------------------------


def _child_dropped(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    for name, part in link_pair.truth[i].welded:
        yield name, link_pair.bodies[i].whole + part


def _child_twice(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    body = link_pair.bodies[i]
    for name, part in (*body.welded, *link_pair.truth[i].welded):
        rest = body.whole.parameters() - part.parameters()
        if rest[0] > 0.0:
            yield name, Inertia.from_parameters(rest)


# --- tensor --------------------------------------------------------------------------------------


def _not_rotated(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    R, tensor = link_pair.bodies[i].rotation, link_pair.bodies[i].tensor
    if Transform(R, np.zeros(3)).angle() > 1e-9:
        yield "in the axes of the link's tip frame", R @ tensor @ R.T
        yield "in the axes of the link's joint", R.T @ tensor @ R


def _wrong_axis(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    for how, permutation in axis_swaps():
        yield how, permutation @ link_pair.bodies[i].tensor @ permutation.T


def _about_origin(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    body = link_pair.bodies[i]
    yield "it is about the frame's origin", body.tensor - body.steiner


def _steiner(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    body = link_pair.bodies[i]
    yield "parallel axes were added twice", body.tensor - 2.0 * body.steiner
    yield "parallel axes were taken off where they should not be", body.tensor + body.steiner


def _product_signs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    tensor = link_pair.bodies[i].tensor
    pairs = {"xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
    for names in (("xy", "xz", "yz"), ("xy",), ("xz",), ("yz",), ("xy", "xz"), ("xy", "yz"),
                  ("xz", "yz")):  # fmt: skip
        if all(tensor[pairs[name]] != 0.0 for name in names):
            repaired = tensor.copy()
            for name in names:
                row, column = pairs[name]
                repaired[row, column] = repaired[column, row] = -tensor[row, column]
            yield f"signs of I{', I'.join(names)}", repaired


_ORDERS = {
    "by rows": ("xx", "xy", "xz", "yy", "yz", "zz"),  # URDF
    "by columns": ("xx", "xy", "yy", "xz", "yz", "zz"),  # Pinocchio
    "diagonal first": ("xx", "yy", "zz", "xy", "xz", "yz"),  # CAD reports, MJCF
    "diagonal first, yz before xy": ("xx", "yy", "zz", "yz", "xz", "xy"),  # Voigt
}


def _entry_order(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    """Six entries listed in one order and read in another."""
    tensor = link_pair.bodies[i].tensor
    for read, read_order in _ORDERS.items():
        listed = [tensor["xyz".index(name[0]), "xyz".index(name[1])] for name in read_order]
        for written, order in _ORDERS.items():
            if written != read:
                repaired = np.empty((3, 3))
                for name, value in zip(order, listed, strict=True):
                    row, column = ("xyz".index(axis) for axis in name)
                    repaired[row, column] = repaired[column, row] = value
                yield f"listed {written}, read {read}", repaired


def _three_r_squared(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    # (3r)² for 3r² adds m (9 − 3) r² / 12 = ½ m r² = I_axis to both moments across the axis.
    tensor = link_pair.bodies[i].tensor
    for axis in (2, 0, 1):
        across = np.delete(np.arange(3), axis)
        repaired = tensor.copy()
        repaired[across, across] -= tensor[axis, axis]
        yield f"along {'xyz'[axis]}", repaired


def _cylinder(field: str, factors: tuple[float, ...]) -> Mistake:
    def repairs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
        body = link_pair.bodies[i]
        fitted = fit_cylinder(body.mass, body.tensor)
        if fitted is None:
            return
        for factor in factors:
            radius, length = fitted.radius, fitted.length
            if field == "radius":
                radius *= factor
            else:
                length *= factor
            repaired = Cylinder(fitted.axis, radius, length)
            yield words_of(factor), repaired.tensor(body.mass)

    return Mistake(
        f"cylinder-{field}",
        "tensor",
        f"the cylinder's {field} is wrong by a factor",
        "compute the tensor from radius (not diameter) and length, in metres",
        repairs,
    )


def _twelfth(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    tensor = link_pair.bodies[i].tensor
    for axis in (2, 0, 1):
        across = np.delete(np.arange(3), axis)
        for written in (0.083, 0.0833, 0.08333, 0.083333, 0.0833333):
            repaired = tensor.copy()
            repaired[across, across] *= 1.0 / (12.0 * written)
            yield f"{written} for 1/12, along {'xyz'[axis]}", repaired


# --- turn ----------------------------------------------------------------------------------------


def _turned_back(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    yield "turned the other way", link_pair.bodies[i].rotation.T


def _turn_dropped(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    if np.abs(link_pair.bodies[i].rotation - np.eye(3)).max() < 1e-12:
        yield "not turned at all", link_pair.truth[i].rotation


def _degrees(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    true = Transform(link_pair.truth[i].rotation, np.zeros(3))
    angle = true.angle()
    if angle > 0.0:
        wrong = _same_axis(link_pair.truth[i].rotation, float(np.degrees(angle)))
        if np.abs(wrong - link_pair.bodies[i].rotation).max() < 1e-6:
            yield f"{np.degrees(angle):.4g}° taken for radians", link_pair.truth[i].rotation


def _same_axis(R: Array, angle: float) -> Array:
    vector = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    length = float(np.linalg.norm(vector))
    if length < 1e-9:  # half a turn: degrees and radians give the same axis, whichever way round
        outer = (R + np.eye(3)) / 2.0
        vector = outer[:, int(np.diag(outer).argmax())]
        length = float(np.linalg.norm(vector))
    return Transform.rotation(vector / length, angle).R


def _rounded_turn(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    rotation = link_pair.bodies[i].rotation
    snapped = np.rint(rotation)
    if not np.array_equal(rotation, snapped) and np.abs(rotation - snapped).max() < 1e-3:
        yield f"{np.abs(rotation - snapped).max():.1e} rad off a quarter turn", snapped


MISTAKES: tuple[Mistake, ...] = (
    Mistake("body-dropped", "body", "the inertial of a body fixed to the link is left out",
            "add it to the link, or keep it on its own link", _child_dropped, alone=True),
    Mistake("body-twice", "body", "the inertial of a body fixed to the link is counted twice",
            "count it in the link or in its own, not in both", _child_twice, alone=True),
    _scaled("mass", "the mass is in another unit", "write kilograms"),
    Mistake("mass-digits", "mass", "two digits of the mass are exchanged", "write the mass again",
            _mass_digits),
    _exchanged("mass"),
    _signs("centre"),
    Mistake("centre-other-end", "centre", "the centre of mass is measured from the other end",
            "measure it from the frame that the file holds it in", _other_end),
    Mistake("centre-other-frame", "centre", "the centre of mass is in another frame's axes",
            "turn it into the frame that the file holds it in", _other_frame),
    _swapped_axes("centre"),
    _scaled("centre", "the centre of mass is in another unit", "write metres"),
    _exchanged("centre"),
    Mistake("centre-of-shape", "centre", "the centre of mass is a point of its cylinder",
            "give the measured centre, if there is one", _middle_of_shape, alone=True),
    Mistake("tensor-not-rotated", "tensor", "the tensor is in another frame's axes",
            "rotate it, I = R I Rᵀ", _not_rotated),
    Mistake("tensor-axes", "tensor", "the tensor lies along the wrong axis",
            "put the small moment along the link", _wrong_axis),
    Mistake("tensor-about-origin", "tensor", "the tensor is about the origin, not the centre",
            "take off m (c·c 1 − c cᵀ)", _about_origin),
    Mistake("tensor-parallel-axes", "tensor", "parallel axes were applied once too often",
            "give the tensor about the centre of mass", _steiner),
    Mistake("tensor-product-signs", "tensor", "products of inertia have the other sign",
            "off-diagonal entries of the tensor are −∫xy dm", _product_signs),
    Mistake("tensor-entry-order", "tensor", "the tensor's entries are in another order",
            "URDF has ixx ixy ixz iyy iyz izz", _entry_order),
    Mistake("cylinder-3r-squared", "tensor", "(3r)² was computed for 3r² in the cylinder",
            "I_across = m (3 r² + l²) / 12", _three_r_squared),
    _cylinder("radius", (0.5, 2.0, 0.1, 10.0, 0.01, 100.0)),
    _cylinder("length", (0.5, 2.0, 0.1, 10.0, 0.01, 100.0)),
    Mistake("cylinder-twelfth", "tensor", "1/12 was rounded in the cylinder", "write 1/12",
            _twelfth, alone=True),
    _scaled("tensor", "the tensor is in another unit, or a decimal point slipped",
            "write kg m²"),
    _exchanged("tensor"),
    _signs("link_vector"),
    _swapped_axes("link_vector"),
    _scaled("link_vector", "the length is in another unit", "write metres"),
    _exchanged("link_vector"),
    Mistake("rotation-sign", "rotation", "the sign of the twist (α or rpy) is lost",
            "write the sign", _turned_back),
    Mistake("rotation-dropped", "rotation", "the twist (α or rpy) is left out", "write the angle",
            _turn_dropped, alone=True),
    Mistake("rotation-degrees", "rotation", "the twist (α or rpy) is in degrees", "write radians",
            _degrees, alone=True),
    Mistake("rotation-rounded", "rotation", "the twist (α or rpy) is a rounded quarter turn",
            "write π/2 with all digits", _rounded_turn),
)  # fmt: skip
