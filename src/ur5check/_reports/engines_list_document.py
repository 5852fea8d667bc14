"""The report of `engines` without a model: the engines, their versions, what installs them."""

from __future__ import annotations

from .._engines.engine_entry import EngineEntry
from .._engines.registry import REGISTRY
from .document import Column, Document, Row, Section, Table
from .provenance import Provenance
from .wording import MISSING

__all__ = ["engines_list_document", "how_to_install"]


def engines_list_document(*, command: str = "") -> Document:
    """The engines as a report."""
    rows = [
        Row(
            (
                e.title,
                e.key,
                e.version or "not installed",
                MISSING if e.version else how_to_install(e),
            )
        )
        for e in REGISTRY.values()
    ]
    columns = (Column("engine"), Column("--with"), Column("version"), Column("to install it"))
    lines = ("`ur5check engines MODEL` compares them on a model.",)
    section = Section("Engines", (), (Table(columns, tuple(rows)),))
    return Document("Engines", None, lines, (section,), Provenance((), command=command))


def how_to_install(entry: EngineEntry) -> str:
    """What installs a reference engine."""
    return f"pip install 'ur5check[{entry.extra}]'" if entry.extra else "comes with ur5check"
