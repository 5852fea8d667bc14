"""How uncertain the numbers of a body are, and the covariance of its ten inertial parameters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from .inertia import Inertia, parameter_map
from .serial_arm import Link
from .transforms import Array, skew

__all__ = ["ArmUncertainty", "BodyUncertainty", "Deviation"]

_UPPER = ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))  # as in `PARAMETERS`


@dataclass(frozen=True)
class Deviation:
    """A standard deviation: a part of the quantity's size if `relative`, else in its own unit."""

    value: float
    relative: bool

    def of(self, size: Array | float) -> Array:
        """For quantities of this size."""
        return np.asarray(self.value * np.abs(size) if self.relative else self.value + 0.0 * size)


_EXACT = Deviation(0.0, False)


@dataclass(frozen=True)
class BodyUncertainty:
    """Standard deviations of a body's numbers, all independent of each other.

    mass : [kg], or relative to the mass
    centre : of each component [m], or relative to the centre's distance from the frame's origin
    tensor : of each entry about the centre of mass [kg m²], or relative to √(I_ii I_jj), which for
        a moment is its own value
    """

    mass: Deviation = _EXACT
    centre: Deviation = _EXACT
    tensor: Deviation = _EXACT

    def covariance(self, body: Inertia) -> Array:
        """Of `Inertia.parameters()`, shape (10, 10), in the frame of `body`.

        To first order: J diag(σ²) Jᵀ, with J = ∂(m, m c, I_c − m S(c)²)/∂(m, c, I_c).
        """
        m, S = body.mass, skew(body.com)
        J = np.zeros((10, 10))
        J[0, 0] = 1.0
        J[1:4, 0] = body.com
        J[4:, 0] = _entries(-S @ S)
        for k, axis in enumerate(np.eye(3)):
            J[1:4, 1 + k] = m * axis
            J[4:, 1 + k] = _entries(-m * (skew(axis) @ S + S @ skew(axis)))
        J[4:, 4:] = np.eye(6)
        moments = np.abs(np.diag(body.tensor))
        sigma = np.concatenate(
            [
                [float(self.mass.of(m))],
                np.full(3, float(self.centre.of(float(np.linalg.norm(body.com))))),
                self.tensor.of(_entries(np.sqrt(np.outer(moments, moments)))),
            ]
        )
        scaled = J * sigma
        return np.asarray(scaled @ scaled.T)


@dataclass(frozen=True)
class ArmUncertainty:
    """Of every link of an arm: `links` by name, and `others` for those that are not named."""

    others: BodyUncertainty = field(default_factory=BodyUncertainty)
    links: Mapping[str, BodyUncertainty] = field(default_factory=dict)

    def covariance(self, link: Link) -> Array:
        """Of a link's ten parameters in frame i, shape (10, 10).

        The numbers are uncertain in the frame in which the source gives them.
        """
        written = link.inertia.expressed_in(link.source_frame.inverse())
        A = parameter_map(link.source_frame)
        own = self.links.get(link.name, self.others).covariance(written)
        return np.asarray(A @ own @ A.T)


def _entries(tensor: Array) -> Array:
    return np.array([tensor[entry] for entry in _UPPER])
