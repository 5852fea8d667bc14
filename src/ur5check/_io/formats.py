"""All file formats of models.  Loading, help texts, messages and tests read this list.

A new format is a folder beside this file that declares `FORMAT`, and its name here.
"""

from __future__ import annotations

from pathlib import Path

from .dh import FORMAT as DH
from .mjcf import FORMAT as MJCF
from .model_format import ModelFormat
from .sdf import FORMAT as SDF
from .urdf import FORMAT as URDF
from .xacro import FORMAT as XACRO

__all__ = ["FORMATS", "SUFFIXES", "WRITABLE", "format_by_suffix", "suffixes_in_words"]

#: By kind.
FORMATS: dict[str, ModelFormat] = {form.kind: form for form in (URDF, XACRO, DH, MJCF, SDF)}

#: Every suffix of a model's file.
SUFFIXES: tuple[str, ...] = tuple(s for form in FORMATS.values() for s in form.suffixes)

#: The formats that can be written, by kind.
WRITABLE: dict[str, ModelFormat] = {k: form for k, form in FORMATS.items() if form.writer}


def format_by_suffix(path: str | Path) -> ModelFormat | None:
    """The format that a file's name says; None for another suffix.  A .xml may be a URDF too."""
    suffix = Path(path).suffix.lower()
    return next((form for form in FORMATS.values() if suffix in form.suffixes), None)


def suffixes_in_words() -> str:
    """For help texts: ".urdf (URDF), …, .xml or .mjcf (MJCF)"."""
    return ", ".join(f"{' or '.join(form.suffixes)} ({form.title})" for form in FORMATS.values())
