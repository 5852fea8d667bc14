"""What reproduces a report: versions, inputs, seed, command."""

from __future__ import annotations

import platform
from collections.abc import Iterable
from dataclasses import dataclass, field
from importlib import metadata
from typing import TYPE_CHECKING

from .._version import __version__

if TYPE_CHECKING:
    from .._robot.robot_tree import ArmOrTree

__all__ = ["Provenance", "inputs_of", "library_versions"]

# Name of a library in a report, and the distribution that installs it.
_LIBRARIES = {
    "pinocchio": "pin",
    "numpy": "numpy",
    "scipy": "scipy",
    "xacro": "xacro",
    "trimesh": "trimesh",
    "example-robot-data": "example-robot-data",
}


def library_versions() -> dict[str, str]:
    """Versions by name, Python's first; read from the installation, so that nothing is imported.

    A library that came without a distribution record (from a system package) is left out.
    """
    versions = {"python": platform.python_version()}
    for name, distribution in _LIBRARIES.items():
        try:
            versions[name] = metadata.version(distribution)
        except metadata.PackageNotFoundError:
            continue
    return versions


def inputs_of(arms: Iterable[ArmOrTree]) -> tuple[tuple[str, str], ...]:
    """(name, SHA-256) of every file that the arms were read from, each once, in reading order."""
    return tuple(dict.fromkeys(pair for arm in arms for pair in arm.source.inputs))


@dataclass(frozen=True)
class Provenance:
    """Where a report comes from.

    inputs : (name, SHA-256) of every file that was read
    seed, samples : of the random states; None where there were none
    command : the shell command that repeats the report; empty if it was made from Python
    """

    inputs: tuple[tuple[str, str], ...]
    seed: int | None = None
    samples: int | None = None
    command: str = ""
    version: str = __version__
    libraries: dict[str, str] = field(default_factory=library_versions)

    @property
    def made_by(self) -> str:
        """All versions in one line."""
        others = (f"{name} {version}" for name, version in self.libraries.items())
        return ", ".join([f"ur5check {self.version}", *others])
