"""Which of a robot's joints make the arm: the path from a base link to a tip link.

A graph of names only.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NoReturn

from ..._errors import ModelError
from ..suggestions import did_you_mean

__all__ = ["Chain", "Edge", "Tree"]

_CHOOSE = "choose the arm with base= and tip="


@dataclass(frozen=True)
class Edge:
    """A joint, as far as the graph is concerned."""

    joint: str
    kind: str
    parent: str
    child: str

    @property
    def moves(self) -> bool:
        return self.kind != "fixed"


@dataclass(frozen=True)
class Chain:
    """climbed : fixed joints from `base` up to the link where the way turns down
    descended : joints from there down to `tip`, fixed and moving
    notes : choices that were made for the reader
    """

    base: str
    tip: str
    climbed: tuple[Edge, ...]
    descended: tuple[Edge, ...]
    notes: tuple[str, ...] = ()

    @cached_property
    def moving(self) -> tuple[Edge, ...]:
        return tuple(edge for edge in self.descended if edge.moves)

    @cached_property
    def moving_joints(self) -> frozenset[str]:
        return frozenset(edge.joint for edge in self.moving)


class Tree:
    """A robot's links and joints; `edges` must form a tree."""

    def __init__(self, links: Sequence[str], edges: Sequence[Edge], file: str) -> None:
        self.links = tuple(links)
        self.file = file
        self.above = {edge.child: edge for edge in edges}
        self.below: dict[str, list[Edge]] = {link: [] for link in links}
        for edge in edges:
            self.below[edge.parent].append(edge)
        (self.root,) = (link for link in links if link not in self.above)

    def chain(self, base: str | None, tip: str | None) -> Chain:
        """The way from `base` (default: the root) to `tip` (default: where the only arm ends)."""
        for option, link in (("base", base), ("tip", tip)):
            if link is not None and link not in self.below:
                self._fail("is no link of this file", did_you_mean(link, self.links), option, link)
        base = self.root if base is None else base
        notes: tuple[str, ...] = ()
        if tip is None:
            tip, notes = self._default_tip(base)
        up, down = self._way_up(base), self._way_up(tip)
        while up and down and up[-1] is down[-1]:  # the part above the turning point
            up, down = up[:-1], down[:-1]
        for edge in up:
            if edge.moves:
                problem = f"the way to tip {tip!r} climbs moving joint {edge.joint!r} backwards"
                self._fail(
                    problem, "choose a base from which every moving joint leads away", "base", base
                )
        chain = Chain(base, tip, tuple(up), tuple(reversed(down)), notes)
        if not chain.moving:
            problem = f"no moving joint lies between base {base!r} and tip {tip!r}"
            self._fail(problem, _CHOOSE + " so that one does")
        return chain

    def rigid_group(self, link: str, chain: Chain) -> list[Edge]:
        """The joints from `link` down to all that moves with it, parents first.

        They stop at the chain's own moving joints; joints beside the chain are held still.
        """
        own = chain.moving_joints
        reached, edges = [link], []
        for end in reached:  # grows while we walk it: breadth first
            found = [edge for edge in self.below[end] if edge.joint not in own]
            edges += found
            reached += [edge.child for edge in found]
        return edges

    def _way_up(self, link: str) -> list[Edge]:
        way = []
        while link in self.above:
            way.append(self.above[link])
            link = self.above[link].parent
        return way

    def _default_tip(self, base: str) -> tuple[str, tuple[str, ...]]:
        """The end of the only arm below the top of what is rigidly joined to `base`."""
        top = base
        while top in self.above and not self.above[top].moves:
            top = self.above[top].parent
        reached = [top]
        for link in reached:
            reached += [edge.child for edge in self.below[link]]
        moved = [link for link in reached if link != top and self.above[link].moves]
        inner = {e.child for link in moved for e in self._way_up(link)[1:] if e.moves}
        ends = [link for link in moved if link not in inner]
        if not ends:
            self._fail("has no moving joint", "an arm needs one", "robot")
        if len(ends) > 1:
            shown = ", ".join(repr(end) for end in ends[:8]) + (", …" if len(ends) > 8 else "")
            problem = f"branches into {len(ends)} chains of moving joints, ending at {shown}"
            self._fail(problem, _CHOOSE, "robot")
        return self._fixed_leaf(ends[0])

    def _fixed_leaf(self, last: str) -> tuple[str, tuple[str, ...]]:
        below = [last]
        for link in below:
            below += [edge.child for edge in self.below[link]]
        leaves = [link for link in below if not self.below[link]]
        if len(leaves) == 1:
            return leaves[0], ()
        shown = ", ".join(repr(leaf) for leaf in leaves)
        return last, (
            f"tip is {last!r}, the last moving link: {len(leaves)} links end there ({shown})",
        )

    def _fail(
        self, problem: str, fix: str, element: str | None = None, value: object = None
    ) -> NoReturn:
        raise ModelError(problem, fix=fix, file=self.file, element=element, value=value)
