"""Mistakes in where a link's tip frame stands: the length r_{i−1,i} of a DH listing or the next
joint's origin of a URDF, and the twist, a DH α or an origin's rpy."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..._robot.transforms import Array, Transform
from .common_mistakes import exchanged, scaled, sign_lost, swapped_axes
from .link_numbers import LinkPair
from .mistake import LinkMistake, Repair

__all__ = ["GEOMETRY_MISTAKES"]


def _sign(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    yield "turned the other way", link_pair.bodies[i].rotation.T


def _dropped(link_pair: LinkPair, i: int) -> Iterator[Repair]:
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


#: The likelier first.
GEOMETRY_MISTAKES: tuple[LinkMistake, ...] = (
    sign_lost("link_vector", "CMP151", ("paper-listing",)),
    swapped_axes("link_vector", "CMP152"),
    scaled(
        "link_vector", "CMP153", "the length is in another unit", "write metres", ("425", "0.425 m")
    ),
    exchanged("link_vector", "CMP154"),
    LinkMistake(
        id="rotation-sign",
        rule_id="CMP161",
        quantity="rotation",
        says="the sign of the twist (α or rpy) is lost",
        repair="write the sign",
        bad="α = π/2",
        good="α = −π/2",
        repairs=_sign,
    ),
    LinkMistake(
        id="rotation-dropped",
        rule_id="CMP162",
        quantity="rotation",
        says="the twist (α or rpy) is left out",
        repair="write the angle",
        bad="α = 0",
        good="α = π/2",
        repairs=_dropped,
        alone=True,
    ),
    LinkMistake(
        id="rotation-degrees",
        rule_id="CMP163",
        quantity="rotation",
        says="the twist (α or rpy) is in degrees",
        repair="write radians",
        bad="α = 90",
        good="α = 1.5707963267948966 rad",
        repairs=_degrees,
        alone=True,
    ),
)
