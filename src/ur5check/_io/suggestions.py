"""“Did you mean …?”, for names that were almost right."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

__all__ = ["did_you_mean"]


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A fix: the nearest known name if one is near, else some of them (at most six)."""
    names = sorted(known)
    near = get_close_matches(name, names, n=1)
    if near:
        return f"did you mean {near[0]!r}?"
    if not names:
        return "there is none to choose from"
    shown = ", ".join(names[:6]) + (", …" if len(names) > 6 else "")
    return f"choose one of: {shown}"
