"""The numbers of two arms side by side, link by link, in the frames of the first one's file."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._robot.inertia import Inertia
from .._robot.serial_arm import Link
from .._robot.transforms import Array
from .arm_pair import Pair

__all__ = ["LinkParameters", "compare_parameters"]


@dataclass(frozen=True, eq=False)
class LinkParameters:
    """One link's numbers in both arms, in the frame in which arm a's source wrote them.

    Attributes
    ----------
    link : int
        From 1.
    name_a, name_b : str
        The link's name in either source.
    a, b : Inertia
    reach_a, reach_b : ndarray, shape (3,)
        From the link's joint to its tip frame [m]: r_{i−1,i} of a DH listing, the next joint's
        origin of a URDF.  Where axes coincide, two files may still put frames at different places
        along them; then these differ and nothing else does.
    tensors_known : bool
        Whether both sources give the link's inertia tensor.
    """

    link: int
    name_a: str
    name_b: str
    a: Inertia
    b: Inertia
    reach_a: Array
    reach_b: Array
    tensors_known: bool = True

    def rows(self) -> list[tuple[str, str, float, float]]:
        """The ten numbers of a link as files write them, side by side.

        Returns
        -------
        list of (str, str, float, float)
            Quantity, unit, value in a, value in b; without the tensor where one is unknown.
        """
        rows = [("mass", "kg", self.a.mass, self.b.mass)]
        for axis, com_a, com_b in zip("xyz", self.a.com, self.b.com, strict=True):
            rows.append((f"centre of mass {axis}", "m", float(com_a), float(com_b)))
        for entry in ("xx", "yy", "zz", "xy", "xz", "yz") if self.tensors_known else ():
            where = ("xyz".index(entry[0]), "xyz".index(entry[1]))
            tensor_a, tensor_b = float(self.a.tensor[where]), float(self.b.tensor[where])
            rows.append((f"I{entry}", "kg m²", tensor_a, tensor_b))
        return rows

    def centre_distance(self) -> float:
        """Distance between the two centres of mass.

        Returns
        -------
        float
            [m]
        """
        return float(np.linalg.norm(self.a.com - self.b.com))

    def moment_ratio(self) -> float:
        """Largest ratio a : b of corresponding principal moments, inverted if below one.

        Returns
        -------
        float
            nan where a moment is not positive.
        """
        moments_a, moments_b = self.a.principal_moments(), self.b.principal_moments()
        if moments_a.min() <= 0.0 or moments_b.min() <= 0.0:
            return float("nan")  # no body has such moments, and their ratio says nothing
        ratios = moments_a / moments_b
        return float(max(ratios.max(), 1.0 / ratios.min()))


def compare_parameters(pair: Pair) -> tuple[LinkParameters, ...]:
    """Every link's inertia in both arms, in arm a's source frames."""
    rows = []
    for i, (la, lb, T) in enumerate(
        zip(pair.a.links, pair.b.links, pair.link_maps, strict=True), 1
    ):
        to_source = la.source_frame.inverse()
        rows.append(
            LinkParameters(
                i,
                la.name,
                lb.name,
                la.inertia.expressed_in(to_source),
                lb.inertia.expressed_in(to_source @ T),
                to_source.R @ _reach(la),
                to_source.R @ T.R @ _reach(lb),
                la.tensor_known and lb.tensor_known,
            )
        )
    return tuple(rows)


def _reach(link: Link) -> Array:
    """r_{i−1,i}: from the joint to the tip frame, in frame i."""
    return link.link_tip_frame.R.T @ link.link_tip_frame.p
