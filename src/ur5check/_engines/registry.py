"""Which engines there are, and which are installed: the entries of all files in `adapters`.

No engine is imported before one is made.
"""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules

from numpy.typing import ArrayLike

from .._dynamics.batching import gravity_of
from .._errors import EngineError, UsageError
from .._robot.as_arm import ArmSource, as_arm
from . import adapters
from .engine import Engine, MakeEngine
from .engine_entry import EngineEntry

__all__ = [
    "READERS",
    "REFERENCE",
    "REGISTRY",
    "engine_class",
    "installed",
    "make_engine",
    "steppers",
]


def _entries() -> list[EngineEntry]:
    modules = (
        import_module(f".{file.name}", adapters.__name__)
        for file in iter_modules(adapters.__path__)
    )
    return sorted((module.ENTRY for module in modules), key=lambda entry: entry.order)


#: Every reader of models whose known issues are on record, in the order of reports.
READERS: dict[str, EngineEntry] = {entry.key: entry for entry in _entries()}

#: The readers that have an adapter: engines that answer.  The hand-written recursion comes first.
REGISTRY: dict[str, EngineEntry] = {k: entry for k, entry in READERS.items() if entry.make}

#: Key of the hand-written recursion, with which all others are compared.
REFERENCE = next(iter(REGISTRY))


def installed() -> tuple[str, ...]:
    """Keys of the engines that are installed, in the order of reports."""
    return tuple(key for key, entry in REGISTRY.items() if entry.version is not None)


def steppers() -> tuple[str, ...]:
    """Keys of the engines that can move an arm in time, in the order of reports."""
    return tuple(key for key, entry in REGISTRY.items() if entry.can_step)


def engine_class(key: str) -> MakeEngine:
    """The class of an engine, once its third-party module is known to import.

    Raises UsageError for an unknown key, EngineError (with what to install) for an absent engine.
    """
    entry = REGISTRY.get(key) if isinstance(key, str) else None
    if entry is None or entry.make is None:
        raise UsageError(f"no engine is called {key!r}; choose from {', '.join(REGISTRY)}")
    try:
        if entry.module is not None:
            entry.module()
    except ImportError as error:
        package = f"ur5check[{entry.extra}]" if entry.extra else str(entry.distribution)
        raise EngineError(
            f"{entry.title} cannot be used here ({error}); pip install '{package}'"
        ) from error
    return entry.make


def make_engine(key: str, arm: ArmSource, gravity: ArrayLike | None = None) -> Engine:
    """The engine of that key with an arm loaded; gravity in the arm's base frame [m/s²].

    Raises EngineError, or UsageError for an unknown key.
    """
    make = engine_class(key)
    arm = as_arm(arm)
    arm.require_tensors("an engine's model")
    return make(arm, gravity_of(arm, gravity))
