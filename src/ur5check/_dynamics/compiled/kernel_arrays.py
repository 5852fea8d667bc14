"""The joint arrays of a kernel: (N, n) or (n, N) by the caller's layout, not copied."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from ..._arguments import number_array
from ..._errors import StateError, UsageError
from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array
from ..batching import joint_array

__all__ = ["Layout", "as_states", "empty_result", "refuse_unless_finite"]

#: "states": one row per state, (N, n);  "joints": one row per joint, (n, N).  Never guessed.
Layout = Literal["states", "joints"]


def as_states(
    arm: SerialArm, arrays: dict[str, ArrayLike], layout: Layout
) -> tuple[dict[str, Array], bool]:
    """Views of shape (N, n), and whether a single state of shape (n,) was given.

    Raises StateError for another shape or different numbers of states, UsageError for an unknown
    layout.
    """
    if layout not in ("states", "joints"):
        raise UsageError(f"layout must be 'states' or 'joints', not {layout!r}")
    views, counts, single = {}, set(), False
    for name, given in arrays.items():
        array = number_array(name, given).astype(np.float64, copy=False)
        single = array.ndim == 1
        if single:
            array = array[None, :] if layout == "states" else array[:, None]
        wanted = f"({arm.n}, N)" if layout == "joints" else f"(N, {arm.n})"
        joints = array.shape[0 if layout == "joints" else -1] if array.ndim == 2 else None
        if joints != arm.n:
            raise StateError(
                f"{name} has shape {np.shape(given)}, but a kernel of arm {arm.name!r} takes "
                f"{wanted} with layout={layout!r}"
            )
        views[name] = array.T if layout == "joints" else array
        counts.add(len(views[name]))
    if len(counts) > 1:
        shapes = ", ".join(f"{name} {np.shape(array)}" for name, array in arrays.items())
        raise StateError(f"these arrays hold different numbers of states: {shapes}")
    return views, single


def empty_result(
    count: int, shape: Sequence[int], layout: Layout, out: Array | None
) -> tuple[Array, Array]:
    """The result in the caller's layout, and a view of it of shape (N, entries).

    Raises StateError for an unsuitable `out`.
    """
    entries = prod(shape)
    wanted = (count, *shape) if layout == "states" else (*shape, count)
    result = np.empty(wanted) if out is None else out
    if not isinstance(result, np.ndarray):
        raise StateError(f"out must be a NumPy array, not {type(result).__name__}")
    if result.shape != wanted or result.dtype != np.float64 or not result.flags.carray:
        raise StateError(
            f"out must be a contiguous float64 array of shape {wanted} that may be written, not "
            f"{result.dtype} {result.shape}"
        )
    flat = (
        result.reshape(count, entries) if layout == "states" else result.reshape(entries, count).T
    )
    return result, flat


def refuse_unless_finite(arm: SerialArm, views: dict[str, Array], result: Array) -> None:
    """Raise StateError, naming the entry, if a state is not finite.

    The sum of the results is tested first: it takes a hundredth of the time of computing them.
    """
    with np.errstate(invalid="ignore", over="ignore"):
        if np.isfinite(result.sum()):
            return
    for name, array in views.items():
        joint_array(arm, name, array)
