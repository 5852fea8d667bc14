"""“Did you mean …?”, for names that are nearly known ones."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

__all__ = ["did_you_mean"]


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A fix: the nearest known name if one is near, else all of them, or the three most alike."""
    names = sorted(known)
    near = get_close_matches(name, names, n=1)
    if near:
        return f"did you mean {near[0]!r}?"
    if not names:
        return "there is none to choose from"
    if len(names) > 6:
        names = [*get_close_matches(name, names, n=3, cutoff=0.0), "…"]
    shown = ", ".join(names)
    return f"choose one of: {shown}"
