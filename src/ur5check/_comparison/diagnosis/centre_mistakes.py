"""Mistakes in a link's centre of mass."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..._robot.transforms import Array, Transform
from .common_mistakes import exchanged, scaled, sign_lost, swapped_axes
from .cylinder_fit import Cylinder, fit_cylinder
from .link_numbers import LinkPair
from .mistake import LinkMistake, Repair

__all__ = ["CENTRE_MISTAKES"]


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


#: The likelier first; "centre-of-shape" is named only where nothing else fits.
CENTRE_MISTAKES: tuple[LinkMistake, ...] = (
    sign_lost("centre", "CMP121"),
    LinkMistake(
        id="centre-other-end",
        rule_id="CMP122",
        quantity="centre",
        says="the centre of mass is measured from the other end",
        repair="measure it from the frame that the file holds it in",
        bad="measured from the link's tip frame in a file that counts from the joint",
        good="measured from the frame of the file's inertial element",
        repairs=_other_end,
        sources=(
            "ros-industrial/universal_robot#426",
            "erd-ur5",
        ),
    ),
    LinkMistake(
        id="centre-other-frame",
        rule_id="CMP123",
        quantity="centre",
        says="the centre of mass is in another frame's axes",
        repair="turn it into the frame that the file holds it in",
        bad="DH axes in a file that holds centres in a URDF's axes",
        good="c = R c, with R from the axes it was measured in to those of the file",
        repairs=_other_frame,
        sources=("petercorke/robotics-toolbox-python#686",),
    ),
    swapped_axes("centre", "CMP124"),
    scaled(
        "centre",
        "CMP125",
        "the centre of mass is in another unit",
        "write metres",
        ("(280, 0, 0)", "(0.28, 0, 0) m"),
    ),
    exchanged("centre", "CMP126"),
    LinkMistake(
        id="centre-of-shape",
        rule_id="CMP127",
        quantity="centre",
        says="the centre of mass is a point of its cylinder",
        repair="give the measured centre, if there is one",
        bad="the middle of the cylinder that the tensor was computed for",
        good="the centre of mass that CAD or a measurement gives",
        repairs=_middle_of_shape,
        sources=(
            "ros-industrial/universal_robot#504",
            "appendix",
        ),
        alone=True,
    ),
)
