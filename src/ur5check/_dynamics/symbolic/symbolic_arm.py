"""An arm whose numbers are symbols.

Zeros of the arm stay zero, and rotations stay numbers: the closed form is short, and valid for arms
of this structure.  All other numbers get a name, with i from 1:

    m_i                     mass [kg]
    cx_i cy_i cz_i          centre of mass in frame i, the paper's r_{i,ci} [m]
    Ixx_i Ixy_i … Izz_i     tensor about it, along the axes of frame i [kg m²]
    a_i d_i                 lengths of a DH row [m]; for a chain that is not a DH table
    rx_i ry_i rz_i          the vector from origin i−1 to origin i, in frame i [m]
    A_i                     armature [kg m²]
    gx gy gz                gravity in the base frame [m/s²]

written without the underscore: m2, Ixx3, a2.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from ..._robot.serial_arm import SerialArm
from ..chain_constants import Chain, LinkConstants, chain_of
from ..vectors import Matrix, Scalar, Vector
from .expression_graph import Graph

__all__ = ["Symbols"]

_SAME_LENGTH = 1e-12  # [m]: rounding of a length by a rotation and its inverse


class Symbols:
    """Names for an arm's numbers, as inputs of a graph; `values` collects their values."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self.values: dict[str, float] = {}

    def chain(self, arm: SerialArm) -> Chain:
        """The arm's chain, its numbers named."""
        chain = chain_of(arm)
        links = [self._link(i, link) for i, link in enumerate(chain.links, 1)]
        return replace(chain, links=tuple(links))

    def gravity(self, arm: SerialArm) -> Vector:
        """Gravity in the base frame, its components named."""
        return self._vector("g", "", arm.gravity)

    def _link(self, i: int, link: LinkConstants) -> LinkConstants:
        rows = [list(row) for row in link.I.rows]
        for j, row in enumerate("xyz"):
            for k, column in enumerate("xyz"[j:], j):
                rows[j][k] = rows[k][j] = self._named(f"I{row}{column}{i}", rows[j][k])
        return replace(
            link,
            m=self._named(f"m{i}", link.m),
            c=self._vector("c", i, link.c),
            I=Matrix(rows),
            armature=self._named(f"A{i}", link.armature),
            r=self._lengths(i, link),
        )

    def _lengths(self, i: int, link: LinkConstants) -> Vector:
        """r = (a, 0, 0) + d b where possible, as for every row of a standard DH table."""
        r, b = np.array([*link.r]), np.array([*link.b])
        a, d = float(r[0]), float(r @ b)
        along_x = np.array([a, 0.0, 0.0])
        if link.prismatic or b[0] != 0.0 or np.abs(r - along_x - d * b).max() > _SAME_LENGTH:
            return self._vector("r", i, r)
        along_b: Vector = link.b * self._named(f"d{i}", d)
        return Vector(self._named(f"a{i}", a), 0.0, 0.0) + along_b

    def _vector(self, letter: str, i: int | str, values: Iterable[Scalar]) -> Vector:
        named = (
            self._named(f"{letter}{axis}{i}", v) for axis, v in zip("xyz", values, strict=True)
        )
        return Vector(*named)

    def _named(self, name: str, value: Scalar) -> Scalar:
        if float(value) == 0.0:
            return 0.0
        self.values[name] = float(value)
        return self.graph.input(name)
