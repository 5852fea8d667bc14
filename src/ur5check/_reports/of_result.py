"""The report of a result, as the commands make it: for `to_text`, `to_json` and notebooks."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from .._comparison.explanation import Explanation
from .._result import Result
from .document import Document
from .json_values import json_text

__all__ = ["document_of", "json_of"]

#: Type of a result: the report's name, and its module of JSON where that bears another name.
_REPORTS = {
    "Difference": ("diff", "diff"),
    "EngineReport": ("engines", "engines"),
    "Explanation": ("diff", "diff"),
    "FleetReport": ("engines_fleet", "engines"),
    "Reproduction": ("paper", "paper"),
    "StaticHold": ("simulate", "simulate"),
    "Sweep": ("sweep", "sweep"),
    "Validation": ("validate", "diff"),
}


def document_of(result: Result) -> Document:
    """The whole report, for a renderer."""
    report, _ = _REPORTS[type(result).__name__]
    document: Document = _made(f"{report}_document", f"{report}_document", result)
    return document


def json_of(result: Result) -> str:
    """The whole report as JSON text."""
    report, module = _REPORTS[type(result).__name__]
    return json_text(_made(f"{module}_json", f"{report}_json", result))


def _made(module: str, function: str, result: Result) -> Any:
    make = getattr(import_module(f".{module}", __package__), function)
    if isinstance(result, Explanation):
        return make(result.difference, result)
    return make(result)
