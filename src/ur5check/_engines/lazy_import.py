"""A third-party engine's module that is imported at its first use.

The registry imports every adapter file to read its entry, and must load no engine by doing so.
"""

from __future__ import annotations

import warnings
from importlib import import_module
from typing import Any

__all__ = ["LazyModule", "lazy_import"]


class LazyModule:
    """Stands for a module; reading an attribute imports it.  ImportError if it is not installed."""

    def __init__(self, name: str, ignored: type[Warning] | None = None) -> None:
        self._name, self._ignored = name, ignored

    def __call__(self) -> Any:
        """The module itself, imported now."""
        with warnings.catch_warnings():
            if self._ignored is not None:
                warnings.simplefilter("ignore", self._ignored)
            return import_module(self._name)

    def __getattr__(self, attribute: str) -> Any:
        value = getattr(self(), attribute)
        # Found in the instance from now on: as fast as a module's own attribute.
        self.__dict__[attribute] = value
        return value


def lazy_import(name: str, *, ignored: type[Warning] | None = None) -> Any:
    """A `LazyModule`, typed as any module without type information.

    ignored : a category of warnings that the module raises while it is imported
    """
    return LazyModule(name, ignored)
