"""What an adapter file declares of its engine: the registry entry."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import metadata
from typing import Any

from .engine import MakeEngine
from .known_issue import KnownIssue
from .lazy_import import LazyModule

__all__ = ["EngineEntry"]


@dataclass(frozen=True)
class EngineEntry:
    """A reader of models: an engine with an adapter, or one whose known issues only are on record.

    key : its name on the command line and in JSON;  title : its name in reports
    order : its position in reports, smallest first
    make : the adapter class; None for a reader without adapter
    module : the third-party module that the adapter uses; None for our own recursion
    distribution : the package that provides it, None for our own recursion
    extra : the extra of ur5check that installs it; None for what comes with ur5check
    known_issues : what it does to models, with the repairs of the URDF
    finds_packages : whether it resolves package:// addresses of meshes by itself
    """

    key: str
    title: str
    order: int
    make: MakeEngine | None = None
    module: LazyModule | None = None
    distribution: str | None = None
    extra: str | None = None
    known_issues: tuple[KnownIssue, ...] = ()
    finds_packages: bool = True

    @property
    def version(self) -> str | None:
        """The installed version, without importing the engine; None if it is not installed."""
        if self.distribution is None:
            from .._version import __version__

            return __version__
        try:
            return metadata.version(self.distribution)
        except metadata.PackageNotFoundError:
            return None

    @property
    def can_step(self) -> bool:
        """Whether the adapter satisfies `engine.Stepper`: it has a step and names integrators."""
        step: Callable[..., Any] | None = getattr(self.make, "step", None)
        return callable(step) and bool(getattr(self.make, "integrators", None))
