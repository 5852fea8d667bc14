"""The report of a result, as the commands make it: for `to_text`, `to_json` and notebooks."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from .._comparison.explanation import Explanation
from .._result import Result
from .document import Document
from .json_report import json_text

__all__ = ["document_of", "json_of"]

#: Type of a result, and the name of its report: `NAME_document` and `NAME_json` make it.
_REPORTS = {
    "Difference": "diff",
    "EngineReport": "engines",
    "Explanation": "diff",
    "FleetReport": "engines_fleet",
    "RecordingComparison": "log",
    "Reproduction": "paper",
    "StaticHold": "simulate",
    "Sweep": "sweep",
    "Validation": "validate",
}


def document_of(result: Result) -> Document:
    """The whole report, for a renderer."""
    document: Document = _made(result, "document")
    return document


def json_of(result: Result) -> str:
    """The whole report as JSON text."""
    return json_text(_made(result, "json"))


def _made(result: Result, kind: str) -> Any:
    name = f"{_REPORTS[type(result).__name__]}_{kind}"
    make = getattr(import_module(f".{name}", __package__), name)
    if isinstance(result, Explanation):
        return make(result.difference, result)
    return make(result)
