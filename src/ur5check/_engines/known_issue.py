"""What a known known issue of a reader is: what it does to a model, and what repairs the file for
it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from lxml import etree

__all__ = ["KnownIssue"]


@dataclass(frozen=True)
class KnownIssue:
    """Something that an engine does to a model when it reads it.

    engine : its key in the registry, or "gazebo"
    kinds : of import differences that this known issue explains
    harmful : whether torques change
    rewrite : makes the file right for this engine, in place; None where no rewriting can
    """

    id: str
    engine: str
    kinds: tuple[str, ...]
    harmful: bool
    title: str
    explanation: str
    fix: str
    rewrite: Callable[[Any], None] | None = None

    def applied(self, root: Any) -> bool:
        """Rewrite a URDF's root element for this known issue; returns whether anything changed."""
        if self.rewrite is None:
            return False
        before = etree.tostring(root)
        self.rewrite(root)
        return bool(etree.tostring(root) != before)
