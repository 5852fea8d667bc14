"""Where an arm begins in a file that has a world above it (MJCF, SDF)."""

from __future__ import annotations

from .urdf.urdf_chain import Chain, Tree

__all__ = ["chain_from_world"]


def chain_from_world(tree: Tree, base: str | None, tip: str | None, world: str = "world") -> Chain:
    """The chain from `base` to `tip`.

    Without `base`, the world is left at once: the arm begins with the body that stands in it and
    carries the arm, as the root link of a URDF would, not with its pose in the world.
    """
    chain = tree.chain(base, tip)
    first = chain.descended[0]
    if base is None and chain.base == world and not first.moves:
        return tree.chain(first.child, tip)
    return chain
