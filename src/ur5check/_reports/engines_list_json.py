"""`ur5check engines --list` as JSON."""

from __future__ import annotations

import msgspec

from .._engines.registry import REGISTRY
from .engines_list_document import how_to_install
from .json_report import Report, head

__all__ = ["EnginesListReport", "engines_list_json"]


class KnownEngine(msgspec.Struct, frozen=True):
    """A reference engine, and how it is installed."""

    key: str
    title: str
    version: str | None
    install: str


class EnginesListReport(Report, frozen=True, kw_only=True, tag="ur5check.engines-list/2"):
    """The reference engines, installed or not."""

    engines: list[KnownEngine]


def engines_list_json(*, command: str = "") -> EnginesListReport:
    """The report of `ur5check engines --list`."""
    return EnginesListReport(
        **head((), command),
        engines=[
            KnownEngine(entry.key, entry.title, entry.version, how_to_install(entry))
            for entry in REGISTRY.values()
        ],
    )
