"""A known issue of a reader: what it does to a model, why, and the repair of the file for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from lxml import etree

__all__ = ["KnownIssue"]


@dataclass(frozen=True, kw_only=True)
class KnownIssue:
    """One known issue, complete in itself.

    id : its name in reports, docs and tests
    engine : key of the reader in the registry;  measured : version of the reader it was seen in
    kinds : the kinds of import difference that it explains (`audit.import_difference.KINDS`)
    harmful : whether torques change
    title : what the reader does, as a clause;  explanation : the details, in sentences
    fix : what to do about it
    rewrite : repairs a URDF's root element for this reader, in place; None where no rewriting can
    """

    id: str
    engine: str
    measured: str
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
