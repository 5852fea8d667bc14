"""Which engines there are, and which are installed: the entries of all files in `adapters`.

No engine is imported before one is made.
"""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules

from numpy.typing import ArrayLike

from .._dynamics.batching import gravity_of
from .._errors import EngineError, UsageError
from .._robot.as_arm import ModelSource, as_arm_or_tree
from .._robot.robot_tree import RobotTree
from . import adapters
from .engine import Engine, MakeEngine
from .engine_entry import EngineEntry
from .mimic_constraint import Constrained

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
    """Keys of the engines that are installed, in the order of reports.

    Returns
    -------
    tuple of str

    Examples
    --------
    >>> import ur5check
    >>> ur5check.installed_engines()[:2]
    ('ur5check', 'pinocchio')
    """
    return tuple(key for key, entry in REGISTRY.items() if entry.version is not None)


def steppers() -> tuple[str, ...]:
    """Keys of the engines that can move an arm in time, in the order of reports.

    Returns
    -------
    tuple of str
        Installed or not.

    Examples
    --------
    >>> import ur5check
    >>> "mujoco" in ur5check.steppers()
    True
    """
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


def make_engine(key: str, arm: ModelSource, gravity: ArrayLike | None = None) -> Engine:
    """The engine of that key with an arm or a tree loaded.

    An arm that came from a URDF reaches the engine as that text, through the engine's own parser;
    any other arm is passed joint by joint.  Of a tree with mimic joints the engine has every joint,
    and answers in the tree's coordinates (see `mimic_constraint`).

    Parameters
    ----------
    key : str
        One of `installed_engines()`.
    arm : name, path, pin.Model, SerialArm or RobotTree
        See `load`.
    gravity : array-like, shape (3,), optional
        In the base frame [m/s²]; `arm.gravity` when None.

    Returns
    -------
    Engine

    Raises
    ------
    EngineError
        For an engine that is not installed, or refuses the model.
    InputError
        For an unknown key, an arm that cannot be read, or invalid gravity.

    Examples
    --------
    >>> import ur5check
    >>> engine = ur5check.make_engine("pinocchio", "appendix")
    >>> engine.gravity_torque([0.0] * 6)[1:3].round(2).tolist()
    [-57.97, -14.48]
    """
    make = engine_class(key)
    arm = as_arm_or_tree(arm)
    if not isinstance(arm, RobotTree):  # which has every tensor
        arm.require_tensors("an engine's model")
    g = gravity_of(arm, gravity)
    if isinstance(arm, RobotTree) and arm.followers and key != REFERENCE:
        return Constrained(make(arm.unconstrained, g), arm)
    return make(arm, g)
