"""Rules of family CMP: every known mistake between two models, for the registry of rules."""

from __future__ import annotations

from .mistakes import MISTAKES

__all__ = ["RULES"]

RULES = tuple(mistake.rule() for mistake in MISTAKES)
