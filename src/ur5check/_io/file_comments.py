"""Comments at the top of a written file: version, inputs, and what the format cannot carry."""

from __future__ import annotations

from .._robot.serial_arm import SerialArm
from .._version import __version__

__all__ = ["came_from", "xml_comment"]


def came_from(arm: SerialArm) -> list[str]:
    """Version, inputs with their hashes, and the notes of the reading; one line each."""
    lines = [
        f"Arm {arm.name!r}, written by ur5check {__version__}: joints and inertias, no shapes."
    ]
    lines += [f"Read from {name} (SHA-256 {digest})" for name, digest in arm.source.inputs]
    return [*lines, *arm.source.notes]


def xml_comment(text: str) -> str:
    """Text that may stand in a comment, where "--" may not."""
    while "--" in text:
        text = text.replace("--", "- -")
    return "".join(c if c.isprintable() else " " for c in text).rstrip("-")
