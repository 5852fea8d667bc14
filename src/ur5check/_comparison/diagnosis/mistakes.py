"""The known mistakes, the likelier first: where two mend equally well, the earlier is named first.

Sources: what users reported (docs/diagnosis.md lists the threads) and the slips of the paper
itself.  A `reach` is r_{i−1,i} of a DH listing or the next joint's origin of a URDF; a `turn` is a
DH α or an origin's rpy.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..._robot.inertia import Inertia
from ..._robot.transforms import Array, Transform
from .cylinder_fit import Cylinder, fit_cylinder
from .link_numbers import Scene
from .mistake import Mistake, Quantity, Remedy, value_of
from .number_mistakes import DECADES, axis_swaps, decimal_slips, digit_swaps, sign_flips, words_of

__all__ = ["CATALOGUE"]


# --- any vector ----------------------------------------------------------------------------------


def _signs(quantity: Quantity) -> Mistake:
    def remedies(scene: Scene, i: int) -> Iterator[Remedy]:
        v: Array = value_of(scene.bodies[i], quantity)
        yield from sign_flips(v)
        if np.count_nonzero(v) > 1:
            yield "all signs", -v

    what = "the length" if quantity == "reach" else "the centre of mass"
    return Mistake(
        f"{quantity}-sign", quantity, f"a sign of {what} is lost", "write the sign", remedies
    )


def _swapped_axes(quantity: Quantity) -> Mistake:
    def remedies(scene: Scene, i: int) -> Iterator[Remedy]:
        for how, permutation in axis_swaps():
            yield how, permutation @ value_of(scene.bodies[i], quantity)

    what = "the offset" if quantity == "reach" else "the centre of mass"
    return Mistake(
        f"{quantity}-axes",
        quantity,
        f"{what} has its components on the wrong axes",
        "write each component on its own axis",
        remedies,
    )


def _scaled(quantity: Quantity, says: str, mend: str) -> Mistake:
    def remedies(scene: Scene, i: int) -> Iterator[Remedy]:
        value = value_of(scene.bodies[i], quantity)
        for factor in DECADES:
            yield words_of(factor), factor * value
        if quantity in ("centre", "reach"):
            yield from decimal_slips(value)

    # Not in pairs: shrunk to nothing, a number takes any mistake that adds something.
    return Mistake(f"{quantity}-scaled", quantity, says, mend, remedies, alone=True)


def _exchanged(quantity: Quantity) -> Mistake:
    def remedies(scene: Scene, i: int) -> Iterator[Remedy]:
        mine, mine_due = (value_of(side[i], quantity) for side in (scene.bodies, scene.truth))
        for j, other in enumerate(scene.bodies):
            # An exchange goes both ways: what stands here is what the other link should have.  Two
            # links that should have nearly the same (a UR5's wrists) must have it to the digit.
            due = value_of(scene.truth[j], quantity)
            size = np.linalg.norm(due)
            nearly = 0.1 if np.linalg.norm(mine_due - due) > 0.1 * size else 1e-4
            if j != i and np.linalg.norm(mine - due) < nearly * size:
                yield f"with link {j + 1}", value_of(other, quantity)

    words = {"mass": "mass", "centre": "centre of mass", "tensor": "tensor", "reach": "length"}
    return Mistake(
        f"{quantity}-exchanged",
        quantity,
        f"the {words[quantity]} is exchanged with another link's",
        "put each link's numbers into its own row",
        remedies,
        alone=True,
    )


# --- mass ----------------------------------------------------------------------------------------


def _mass_digits(scene: Scene, i: int) -> Iterator[Remedy]:
    # Two neighbouring digits further back make a difference that any two measurements have: the
    # mended number must be the other one, digit by digit.
    for how, mended in digit_swaps(scene.bodies[i].mass):
        if abs(mended - scene.truth[i].mass) <= 1e-9 * mended:
            yield how, mended


# --- centre of mass ------------------------------------------------------------------------------


def _other_end(scene: Scene, i: int) -> Iterator[Remedy]:
    body = scene.bodies[i]
    if body.reach.any():
        yield "from the far end instead of the joint", body.com + body.reach
        yield "from the joint instead of the far end", body.com - body.reach


def _other_frame(scene: Scene, i: int) -> Iterator[Remedy]:
    body = scene.bodies[i]
    if Transform(body.turn, np.zeros(3)).angle() > 1e-9:
        yield "in the axes of the link's far end", body.turn @ body.com
        yield "in the axes of the link's joint", body.turn.T @ body.com


def _middle_of_shape(scene: Scene, i: int) -> Iterator[Remedy]:
    """A centre that is a point of the link's shape, not a measured one.

    Two models that differ by a few per cent here may both be measured: only a centre that is off by
    more than any measurement is put down to this.
    """
    body, truth = scene.bodies[i], scene.truth[i].com
    apart = float(np.linalg.norm(body.com - truth))
    size = max(float(np.linalg.norm(other.reach)) for other in scene.bodies)
    far = max(float(np.linalg.norm(body.com)), float(np.linalg.norm(truth)))
    fitted = fit_cylinder(body.mass, body.tensor)
    if fitted is None or apart < max(0.15 * far, 0.03 * size):
        return
    half = 0.5 * fitted.length * np.eye(3)[fitted.axis]
    middles = {
        "at its frame's origin": np.zeros(3),
        "half the cylinder's length from it": half,
        "half the cylinder's length behind it": -half,
        "half way along the link": 0.5 * body.reach,
        "at the link's far end": body.reach,
        "half the cylinder's length before the far end": body.reach - _along(body.reach, fitted),
    }
    for how, middle in middles.items():
        if np.linalg.norm(body.com - middle) <= 1e-6:
            yield how, truth


def _along(reach: Array, fitted: Cylinder) -> Array:
    length = float(np.linalg.norm(reach))
    return reach * (0.5 * fitted.length / length) if length > 0.0 else reach


# --- body ----------------------------------------------------------------------------------------


def _child_dropped(scene: Scene, i: int) -> Iterator[Remedy]:
    for name, part in scene.truth[i].welded:
        yield name, scene.bodies[i].whole + part


def _child_twice(scene: Scene, i: int) -> Iterator[Remedy]:
    body = scene.bodies[i]
    for name, part in (*body.welded, *scene.truth[i].welded):
        rest = body.whole.parameters() - part.parameters()
        if rest[0] > 0.0:
            yield name, Inertia.from_parameters(rest)


# --- tensor --------------------------------------------------------------------------------------


def _not_rotated(scene: Scene, i: int) -> Iterator[Remedy]:
    R, tensor = scene.bodies[i].turn, scene.bodies[i].tensor
    if Transform(R, np.zeros(3)).angle() > 1e-9:
        yield "in the axes of the link's far end", R @ tensor @ R.T
        yield "in the axes of the link's joint", R.T @ tensor @ R


def _wrong_axis(scene: Scene, i: int) -> Iterator[Remedy]:
    for how, permutation in axis_swaps():
        yield how, permutation @ scene.bodies[i].tensor @ permutation.T


def _about_origin(scene: Scene, i: int) -> Iterator[Remedy]:
    body = scene.bodies[i]
    yield "it is about the frame's origin", body.tensor - body.steiner


def _steiner(scene: Scene, i: int) -> Iterator[Remedy]:
    body = scene.bodies[i]
    yield "parallel axes were added twice", body.tensor - 2.0 * body.steiner
    yield "parallel axes were taken off where they should not be", body.tensor + body.steiner


def _product_signs(scene: Scene, i: int) -> Iterator[Remedy]:
    tensor = scene.bodies[i].tensor
    pairs = {"xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
    for names in (("xy", "xz", "yz"), ("xy",), ("xz",), ("yz",), ("xy", "xz"), ("xy", "yz"),
                  ("xz", "yz")):  # fmt: skip
        if all(tensor[pairs[name]] != 0.0 for name in names):
            mended = tensor.copy()
            for name in names:
                row, column = pairs[name]
                mended[row, column] = mended[column, row] = -tensor[row, column]
            yield f"signs of I{', I'.join(names)}", mended


_ORDERS = {
    "by rows": ("xx", "xy", "xz", "yy", "yz", "zz"),  # URDF
    "by columns": ("xx", "xy", "yy", "xz", "yz", "zz"),  # Pinocchio
    "diagonal first": ("xx", "yy", "zz", "xy", "xz", "yz"),  # CAD reports, MJCF
    "diagonal first, yz before xy": ("xx", "yy", "zz", "yz", "xz", "xy"),  # Voigt
}


def _entry_order(scene: Scene, i: int) -> Iterator[Remedy]:
    """Six entries listed in one order and read in another."""
    tensor = scene.bodies[i].tensor
    for read, read_order in _ORDERS.items():
        listed = [tensor["xyz".index(name[0]), "xyz".index(name[1])] for name in read_order]
        for written, order in _ORDERS.items():
            if written != read:
                mended = np.empty((3, 3))
                for name, value in zip(order, listed, strict=True):
                    row, column = ("xyz".index(axis) for axis in name)
                    mended[row, column] = mended[column, row] = value
                yield f"listed {written}, read {read}", mended


def _three_r_squared(scene: Scene, i: int) -> Iterator[Remedy]:
    # (3r)² for 3r² adds m (9 − 3) r² / 12 = ½ m r² = I_axis to both moments across the axis.
    tensor = scene.bodies[i].tensor
    for axis in (2, 0, 1):
        across = np.delete(np.arange(3), axis)
        mended = tensor.copy()
        mended[across, across] -= tensor[axis, axis]
        yield f"along {'xyz'[axis]}", mended


def _cylinder(field: str, factors: tuple[float, ...]) -> Mistake:
    def remedies(scene: Scene, i: int) -> Iterator[Remedy]:
        body = scene.bodies[i]
        fitted = fit_cylinder(body.mass, body.tensor)
        if fitted is None:
            return
        for factor in factors:
            radius, length = fitted.radius, fitted.length
            if field == "radius":
                radius *= factor
            else:
                length *= factor
            mended = Cylinder(fitted.axis, radius, length)
            yield words_of(factor), mended.tensor(body.mass)

    return Mistake(
        f"cylinder-{field}",
        "tensor",
        f"the cylinder's {field} is wrong by a factor",
        "compute the tensor from radius (not diameter) and length, in metres",
        remedies,
    )


def _twelfth(scene: Scene, i: int) -> Iterator[Remedy]:
    tensor = scene.bodies[i].tensor
    for axis in (2, 0, 1):
        across = np.delete(np.arange(3), axis)
        for written in (0.083, 0.0833, 0.08333, 0.083333, 0.0833333):
            mended = tensor.copy()
            mended[across, across] *= 1.0 / (12.0 * written)
            yield f"{written} for 1/12, along {'xyz'[axis]}", mended


# --- turn ----------------------------------------------------------------------------------------


def _turned_back(scene: Scene, i: int) -> Iterator[Remedy]:
    yield "turned the other way", scene.bodies[i].turn.T


def _turn_dropped(scene: Scene, i: int) -> Iterator[Remedy]:
    if np.abs(scene.bodies[i].turn - np.eye(3)).max() < 1e-12:
        yield "not turned at all", scene.truth[i].turn


def _degrees(scene: Scene, i: int) -> Iterator[Remedy]:
    true = Transform(scene.truth[i].turn, np.zeros(3))
    angle = true.angle()
    if angle > 0.0:
        wrong = _same_axis(scene.truth[i].turn, float(np.degrees(angle)))
        if np.abs(wrong - scene.bodies[i].turn).max() < 1e-6:
            yield f"{np.degrees(angle):.4g}° taken for radians", scene.truth[i].turn


def _same_axis(R: Array, angle: float) -> Array:
    vector = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    length = float(np.linalg.norm(vector))
    if length < 1e-9:  # half a turn: degrees and radians give the same axis, whichever way round
        outer = (R + np.eye(3)) / 2.0
        vector = outer[:, int(np.diag(outer).argmax())]
        length = float(np.linalg.norm(vector))
    return Transform.rotation(vector / length, angle).R


def _rounded_turn(scene: Scene, i: int) -> Iterator[Remedy]:
    turn = scene.bodies[i].turn
    snapped = np.rint(turn)
    if not np.array_equal(turn, snapped) and np.abs(turn - snapped).max() < 1e-3:
        yield f"{np.abs(turn - snapped).max():.1e} rad off a quarter turn", snapped


CATALOGUE: tuple[Mistake, ...] = (
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
    _signs("reach"),
    _swapped_axes("reach"),
    _scaled("reach", "the length is in another unit", "write metres"),
    _exchanged("reach"),
    Mistake("turn-sign", "turn", "the sign of the twist (α or rpy) is lost", "write the sign",
            _turned_back),
    Mistake("turn-dropped", "turn", "the twist (α or rpy) is left out", "write the angle",
            _turn_dropped, alone=True),
    Mistake("turn-degrees", "turn", "the twist (α or rpy) is in degrees", "write radians",
            _degrees, alone=True),
    Mistake("turn-rounded", "turn", "the twist (α or rpy) is a rounded quarter turn",
            "write π/2 with all digits", _rounded_turn),
)  # fmt: skip
