"""All file formats of models.  Loading, help texts, messages and tests read this list.

A new format is a folder beside this file that declares `FORMAT`, and its name here.
"""

from __future__ import annotations

from pathlib import Path

from .._errors import ModelError
from .dh import FORMAT as DH
from .mjcf import FORMAT as MJCF
from .model_format import ModelFormat
from .sdf import FORMAT as SDF
from .urdf import FORMAT as URDF
from .xacro import FORMAT as XACRO

__all__ = [
    "FORMATS",
    "SUFFIXES",
    "WRITABLE",
    "format_by_suffix",
    "format_of_text",
    "suffixes_in_words",
]

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


def format_of_text(form: ModelFormat, path: Path, data: bytes, label: str) -> ModelFormat:
    """The format of a file's text, where its name says `form`.

    A .xml is what its root element says.  A URDF with xacro's elements is a xacro.  Raises
    ModelError, naming `label`, for a .xml that is neither a robot's description nor XML.
    """
    if path.suffix.lower() == ".xml":
        form = _format_by_root(data, label)
    return XACRO if form is URDF and _has_macros(data, label) else form


def _has_macros(data: bytes, label: str) -> bool:
    """Whether there are xacro's elements in a URDF's text, not only in its comments."""
    from .xml.xml_tree import XmlError, parse_xml

    if b"xmlns:xacro" not in data or b"<xacro:" not in data:
        return False
    try:
        return any(node.tag.startswith("xacro:") for node in parse_xml(data, label).walk())
    except XmlError:
        return False  # whose reader reports it


def _format_by_root(data: bytes, label: str) -> ModelFormat:
    """Both MuJoCo's models and some URDFs are called .xml; the root element decides."""
    from .xml.xml_tree import XmlError, parse_xml

    try:
        root = parse_xml(data, label)
    except XmlError as error:
        raise error.of_file(label) from None
    known = {form.xml_root: form for form in FORMATS.values() if form.xml_root}
    if root.tag not in known:
        raise ModelError(
            "the root element is neither MJCF's nor a URDF's",
            fix="a .xml file is <mujoco> or <robot>; an SDF is called .sdf",
            file=label,
            line=root.place().line,
            element=f"<{root.tag}>",
            rule="XML102",
        )
    return known[root.tag]


def suffixes_in_words() -> str:
    """For help texts: ".urdf (URDF), …, .xml or .mjcf (MJCF)"."""
    return ", ".join(f"{' or '.join(form.suffixes)} ({form.title})" for form in FORMATS.values())
