"""Names that a file may not use twice."""

from __future__ import annotations

from collections.abc import Iterable

__all__ = ["unique_names"]


def unique_names(wanted: Iterable[str], stem: str, taken: Iterable[str] = ()) -> list[str]:
    """The names in their order, each once and none of `taken`: `base`, `base_link`, `base_link_2`.

    stem : what an empty name becomes, and what is added to one that is taken
    """
    used, names = set(taken), []
    for name in wanted:
        plain = name.strip() or stem
        free, number = plain, 1
        while free in used:
            free = f"{plain}_{stem}" + (f"_{number}" if number > 1 else "")
            number += 1
        used.add(free)
        names.append(free)
    return names
