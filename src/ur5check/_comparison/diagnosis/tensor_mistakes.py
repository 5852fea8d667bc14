"""Mistakes in a link's inertia tensor."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..._robot.transforms import Transform
from .common_mistakes import exchanged, scaled
from .cylinder_fit import Cylinder, fit_cylinder
from .link_numbers import LinkPair
from .mistake import LinkMistake, Repair
from .number_mistakes import axis_swaps, words_of

__all__ = ["TENSOR_MISTAKES"]

_FACTORS = (0.5, 2.0, 0.1, 10.0, 0.01, 100.0)  # diameter for radius, and decimal points


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


def _parallel_axes(link_pair: LinkPair, i: int) -> Iterator[Repair]:
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


def _cylinder(field: str, rule_id: str, sources: tuple[str, ...] = ()) -> LinkMistake:
    """Radius or length of the cylinder that the tensor was computed for, wrong by a factor."""

    def repairs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
        body = link_pair.bodies[i]
        fitted = fit_cylinder(body.mass, body.tensor)
        if fitted is None:
            return
        for factor in _FACTORS:
            radius, length = fitted.radius, fitted.length
            if field == "radius":
                radius *= factor
            else:
                length *= factor
            repaired = Cylinder(fitted.axis, radius, length)
            yield words_of(factor), repaired.tensor(body.mass)

    return LinkMistake(
        id=f"cylinder-{field}",
        rule_id=rule_id,
        quantity="tensor",
        says=f"the cylinder's {field} is wrong by a factor",
        repair="compute the tensor from radius (not diameter) and length, in metres",
        bad=f"a cylinder ten times the {field} of the link",
        good=f"the cylinder's {field} as the link has it",
        repairs=repairs,
        sources=sources,
    )


def _twelfth(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    tensor = link_pair.bodies[i].tensor
    for axis in (2, 0, 1):
        across = np.delete(np.arange(3), axis)
        for written in (0.083, 0.0833, 0.08333, 0.083333, 0.0833333):
            repaired = tensor.copy()
            repaired[across, across] *= 1.0 / (12.0 * written)
            yield f"{written} for 1/12, along {'xyz'[axis]}", repaired


#: The likelier first.
TENSOR_MISTAKES: tuple[LinkMistake, ...] = (
    LinkMistake(
        id="tensor-not-rotated",
        rule_id="CMP131",
        quantity="tensor",
        says="the tensor is in another frame's axes",
        repair="rotate it, I = R I Rᵀ",
        bad="a tensor in a URDF's axes copied into a DH table",
        good="R I Rᵀ, with R from the axes it was computed in to those of the file",
        repairs=_not_rotated,
        sources=(
            "petercorke/robotics-toolbox-python#686",
            "google-deepmind/mujoco#3559",
            "dartsim/dart#47",
        ),
    ),
    LinkMistake(
        id="tensor-axes",
        rule_id="CMP132",
        quantity="tensor",
        says="the tensor lies along the wrong axis",
        repair="put the small moment along the link",
        bad="the small moment about z for a link that extends along x",
        good="the small moment about x",
        repairs=_wrong_axis,
        sources=(
            "UniversalRobots/Universal_Robots_ROS2_Description#195",
            "paper",
        ),
    ),
    LinkMistake(
        id="tensor-about-origin",
        rule_id="CMP133",
        quantity="tensor",
        says="the tensor is about the origin, not the centre",
        repair="take off m (c·c 1 − c cᵀ)",
        bad="the tensor about the joint, as some CAD reports give it",
        good="the tensor about the centre of mass",
        repairs=_about_origin,
    ),
    LinkMistake(
        id="tensor-parallel-axes",
        rule_id="CMP134",
        quantity="tensor",
        says="parallel axes were applied once too often",
        repair="give the tensor about the centre of mass",
        bad="m (c·c 1 − c cᵀ) added twice",
        good="the tensor about the centre of mass",
        repairs=_parallel_axes,
    ),
    LinkMistake(
        id="tensor-product-signs",
        rule_id="CMP135",
        quantity="tensor",
        says="products of inertia have the other sign",
        repair="off-diagonal entries of the tensor are −∫xy dm",
        bad="ixy = ∫xy dm",
        good="ixy = −∫xy dm",
        repairs=_product_signs,
    ),
    LinkMistake(
        id="tensor-entry-order",
        rule_id="CMP136",
        quantity="tensor",
        says="the tensor's entries are in another order",
        repair="URDF has ixx ixy ixz iyy iyz izz",
        bad="ixx iyy izz ixy ixz iyz read as ixx ixy ixz iyy iyz izz",
        good="the entries in the order that the format asks for",
        repairs=_entry_order,
    ),
    LinkMistake(
        id="cylinder-3r-squared",
        rule_id="CMP137",
        quantity="tensor",
        says="(3r)² was computed for 3r² in the cylinder",
        repair="I_across = m (3 r² + l²) / 12",
        bad="m ((3 r)² + l²) / 12",
        good="m (3 r² + l²) / 12",
        repairs=_three_r_squared,
        sources=("paper",),
    ),
    _cylinder("radius", "CMP138", ("ros-industrial/universal_robot#426", "erd-ur5")),
    _cylinder("length", "CMP139"),
    LinkMistake(
        id="cylinder-twelfth",
        rule_id="CMP140",
        quantity="tensor",
        says="1/12 was rounded in the cylinder",
        repair="write 1/12",
        bad="0.0833333 m (3 r² + l²)",
        good="m (3 r² + l²) / 12",
        repairs=_twelfth,
        sources=("appendix",),
        alone=True,
    ),
    scaled(
        "tensor",
        "CMP141",
        "the tensor is in another unit, or a decimal point slipped",
        "write kg m²",
        ("13300 (kg mm²)", "0.0133 kg m²"),
    ),
    exchanged("tensor", "CMP142"),
)
