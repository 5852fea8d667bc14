"""Checks of what a caller passes: one line each where a public function begins.

Each returns the value in the type that the function works with, or raises an `InputError` that
names the argument, what was given and what to give instead.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Collection, Iterable, Mapping
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import InputError, StateError, UsageError

__all__ = [
    "callback",
    "choice",
    "instance",
    "integer",
    "names",
    "number",
    "number_array",
    "text_map",
]

_T = TypeVar("_T")


def integer(name: str, value: object, *, least: int | None = None) -> int:
    """`value` as an int; a bool is none.  Raises UsageError for anything else, or below `least`."""
    at_least = "" if least is None else f" of at least {least}"
    try:
        if isinstance(value, bool | np.bool_):
            raise TypeError
        whole = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        raise UsageError(f"{name} must be a whole number{at_least}, not {value!r}") from None
    if least is not None and whole < least:
        raise UsageError(f"{name} must be a whole number{at_least}, not {whole}")
    return whole


def number(name: str, value: object, *, positive: bool = False) -> float:
    """`value` as a finite float, above zero if `positive`.  Raises UsageError."""
    wanted = "a positive finite number" if positive else "a finite number"
    try:
        if isinstance(value, bool | np.bool_ | str | bytes):
            raise TypeError
        real = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise UsageError(f"{name} must be {wanted}, not {value!r}") from None
    if not np.isfinite(real) or (positive and real <= 0.0):
        raise UsageError(f"{name} must be {wanted}, not {real}")
    return real


def choice(name: str, value: object, allowed: Collection[str]) -> str:
    """`value`, which must be one of `allowed`.  Raises UsageError."""
    if isinstance(value, str) and value in allowed:
        return value
    raise UsageError(f"{name} must be one of {', '.join(map(repr, allowed))}, not {value!r}")


def instance(name: str, value: object, kind: type[_T], hint: str) -> _T:
    """`value`, which must be a `kind`; `hint` says where one comes from.  Raises UsageError."""
    if isinstance(value, kind):
        return value
    raise UsageError(f"{name} must be a {kind.__name__}, not {value!r:.80}; {hint}")


def number_array(
    name: str,
    values: ArrayLike,
    *,
    complex_too: bool = False,
    error: Callable[[str], InputError] = StateError,
) -> NDArray[Any]:
    """`values` as an array of numbers, of their own type and any shape, not necessarily finite.

    Raises `error` for text, None, booleans, objects, ragged lists and masked arrays.
    """
    if np.ma.isMaskedArray(values):
        raise error(f"{name} is a masked array; give a plain one, `{name}.filled(value)`")
    try:
        array = np.asarray(values)
    except (TypeError, ValueError) as reason:  # ragged nested lists
        raise error(f"{name} is not an array of numbers: {reason}") from None
    if array.dtype.kind not in ("iufc" if complex_too else "iuf"):
        numbers = "numbers" if complex_too else "real numbers"
        raise error(f"{name} must hold {numbers}, not {array.dtype.name}: {values!r:.60}")
    return array


def callback(name: str, value: Callable[[str], None] | None) -> Callable[[str], None]:
    """`value`, or a function that does nothing for None.  Raises UsageError."""
    if value is None:
        return lambda line: None
    if not callable(value):
        raise UsageError(f"{name} must be a function of one string, not {value!r:.80}")
    return value


def names(name: str, values: object) -> tuple[str, ...]:
    """`values` as a tuple of strings; one string alone is none.  Raises UsageError."""
    if isinstance(values, Iterable) and not isinstance(values, str | bytes):
        given = tuple(values)
        if all(isinstance(value, str) for value in given):
            return given
    raise UsageError(f"{name} must be a sequence of names, not {values!r:.80}")


def text_map(name: str, values: object) -> None:
    """Raise UsageError unless `values` is None or a mapping whose keys are strings."""
    if values is None:
        return
    if not isinstance(values, Mapping) or not all(isinstance(key, str) for key in values):
        raise UsageError(f"{name} must be a mapping from names to values, not {values!r:.80}")
