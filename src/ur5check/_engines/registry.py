"""Which reference engines there are, and which are here.  Nothing is imported until one is asked
for."""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module, metadata

from numpy.typing import ArrayLike

from .._errors import EngineError, UsageError
from .._robot.serial_arm import SerialArm
from .engine import Engine, MakeEngine

__all__ = ["REGISTRY", "EngineEntry", "engine_class", "installed", "make_engine"]


@dataclass(frozen=True)
class EngineEntry:
    """A reference engine.

    key : how commands name it;  title : how reports do
    module, factory : where its class is, from this package
    distribution : what has to be installed, None for our own side
    extra : of ur5check, that installs it; None for what comes with ur5check
    """

    key: str
    title: str
    module: str
    factory: str
    distribution: str | None = None
    extra: str | None = None

    @property
    def version(self) -> str | None:
        """The installed version, asked without importing anything; None if it is not here."""
        if self.distribution is None:
            from .._version import __version__

            return __version__
        try:
            return metadata.version(self.distribution)
        except metadata.PackageNotFoundError:
            return None


_ENTRIES = (
    EngineEntry("own", "ur5check", ".recursion_engine", "RecursionEngine"),
    EngineEntry("pinocchio", "Pinocchio", ".pinocchio", "PinocchioEngine", "pin"),
    EngineEntry("mujoco", "MuJoCo", ".mujoco", "MuJoCoEngine", "mujoco", "mujoco"),
    EngineEntry("drake", "Drake", ".drake", "DrakeEngine", "drake", "drake"),
    EngineEntry("dart", "DART", ".dart", "DartEngine", "dartpy", "dart"),
    EngineEntry("idyntree", "iDynTree", ".idyntree", "IDynTreeEngine", "idyntree", "idyntree"),
)

#: Every reference engine, in the order in which reports show them; our own side first.
REGISTRY: dict[str, EngineEntry] = {entry.key: entry for entry in _ENTRIES}


def installed() -> tuple[str, ...]:
    """Keys of the reference engines that are here, our own side first."""
    return tuple(key for key, entry in REGISTRY.items() if entry.version is not None)


def engine_class(key: str) -> MakeEngine:
    """The class of a reference engine.  Imports it.

    Raises UsageError for an unknown key, EngineError (with what to install) for an absent one.
    """
    entry = REGISTRY.get(key)
    if entry is None:
        raise UsageError(f"no engine is called {key!r}; choose from {', '.join(REGISTRY)}")
    try:
        module = import_module(entry.module, __package__)
    except ImportError as error:
        wanted = f"ur5check[{entry.extra}]" if entry.extra else str(entry.distribution)
        raise EngineError(
            f"{entry.title} cannot be used here ({error}); pip install '{wanted}'"
        ) from error
    made: MakeEngine = getattr(module, entry.factory)
    return made


def make_engine(key: str, arm: SerialArm, gravity: ArrayLike | None = None) -> Engine:
    """The reference engine of that key, holding an arm.

    Raises EngineError, or UsageError for an unknown key.
    """
    return engine_class(key)(arm, gravity)
