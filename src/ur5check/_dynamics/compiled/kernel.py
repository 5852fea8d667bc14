"""`ur5check.compile`: the dynamics of one arm as generated code, for arrays of states.

Each quantity is derived once from the recursion (`symbolic`), regrouped, factored, compiled by LLVM
where llvmlite is installed, and cached on disk.  Without llvmlite the same program runs on NumPy,
on blocks of states.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from importlib.util import find_spec
from threading import Lock
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from ..._arguments import integer
from ..._errors import StateError, UsageError
from ..._robot.as_arm import ArmSource, as_arm
from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array
from .fingerprint import fingerprint
from .kernel_arrays import Layout, as_states, empty_result, refuse_unless_finite
from .kernel_cache import kept

__all__ = ["DifferenceKernel", "Kernel", "Path", "compile", "compile_difference", "default_path"]

#: The path that runs a program.
Path = Literal["llvm", "numpy"]

#: (q, qd, qdd, out) of shape (N, …), None for what a quantity does not depend on.
_Run = Callable[[Array, Array | None, Array | None, Array], None]

#: One thread generates code, the others wait and read it from disk.
_ONE_AT_A_TIME = Lock()


def default_path() -> Path:
    """LLVM where llvmlite is installed, else NumPy."""
    return "llvm" if find_spec("llvmlite") else "numpy"


def compile(  # noqa: A001
    arm: ArmSource, threads: int = 1, *, path: Path | None = None
) -> Kernel:
    """Compiled dynamics of an arm under its own gravity.

    A quantity is compiled at its first call, and later loaded from disk (docs/kernels.md).

    Parameters
    ----------
    arm : name, path, pin.Model or SerialArm
        See `load`.
    threads : int
        Threads that share the states, at least 1; machine code releases the GIL.
    path : {"llvm", "numpy"}, optional
        LLVM where llvmlite is installed (`ur5check[fast]`) when None.

    Returns
    -------
    Kernel

    Raises
    ------
    InputError
        For an arm that cannot be read, fewer threads than 1, or a path that is not installed.

    Examples
    --------
    >>> import numpy as np
    >>> import ur5check
    >>> kernel = ur5check.compile("paper", path="numpy")
    >>> kernel.gravity_torque(np.zeros((1000, 6))).shape
    (1000, 6)
    """
    return Kernel(as_arm(arm), *_checked(threads, path))


def compile_difference(
    a: ArmSource, b: ArmSource, threads: int = 1, *, path: Path | None = None
) -> DifferenceKernel:
    """The compiled torque difference τ_a − τ_b of two arms.

    Parameters
    ----------
    a, b : name, path, pin.Model or SerialArm
        In the same joint coordinates (see `pair_up`).
    threads : int
        Threads that share the states, at least 1.
    path : {"llvm", "numpy"}, optional
        LLVM where llvmlite is installed (`ur5check[fast]`) when None.

    Returns
    -------
    DifferenceKernel

    Raises
    ------
    InputError
        As `compile`, and for arms with different numbers of joints.

    Examples
    --------
    >>> import numpy as np
    >>> import ur5check
    >>> pair = ur5check.pair_up("appendix", "erd-ur5")
    >>> kernel = ur5check.compile_difference(pair.a, pair.b, path="numpy")
    >>> kernel(*np.zeros((3, 1000, 6))).shape
    (1000, 6)
    """
    a, b = as_arm(a), as_arm(b)
    if a.n != b.n:
        raise UsageError(f"arms of {a.n} and {b.n} joints have no torque difference; see pair_up")
    return DifferenceKernel(a, b, *_checked(threads, path))


@dataclass(frozen=True, eq=False)
class Kernel:
    """Compiled functions of one arm.

    Joint arrays are float64 of shape (N, n) with layout="states", (n, N) with layout="joints", or
    one state of shape (n,); none is copied.  Results are (N, *shape) or (*shape, N) likewise;
    `out` takes them where it is given.  Each function raises StateError for another shape, and for
    entries that are no finite numbers.

    Attributes
    ----------
    arm : SerialArm
    threads : int
    path : {"llvm", "numpy"}
    """

    arm: SerialArm
    threads: int
    path: Path

    def rnea(
        self,
        q: ArrayLike,
        qd: ArrayLike,
        qdd: ArrayLike,
        *,
        layout: Layout = "states",
        out: Array | None = None,
    ) -> Array:
        """Inverse dynamics: τ = M q̈ + C q̇ + g.

        Parameters
        ----------
        q, qd, qdd : array-like, shape (N, n)
            [rad], [rad/s], [rad/s²]
        layout : {"states", "joints"}
            Order of the axes.
        out : ndarray, optional
            Takes the result.

        Returns
        -------
        ndarray, shape (N, n)
            [N m]

        Raises
        ------
        StateError
            For another shape, or entries that are not finite numbers.
        """
        return self._compute("tau", (self.arm.n,), {"q": q, "qd": qd, "qdd": qdd}, layout, out)

    def mass_matrix(
        self, q: ArrayLike, *, layout: Layout = "states", out: Array | None = None
    ) -> Array:
        """The joint-space mass matrix M(q).

        Parameters
        ----------
        q : array-like, shape (N, n)
            [rad]
        layout : {"states", "joints"}
            Order of the axes.
        out : ndarray, optional
            Takes the result.

        Returns
        -------
        ndarray, shape (N, n, n)
            [kg m²]

        Raises
        ------
        StateError
            For another shape, or entries that are not finite numbers.
        """
        return self._compute("M", (self.arm.n, self.arm.n), {"q": q}, layout, out)

    def coriolis_matrix(
        self, q: ArrayLike, qd: ArrayLike, *, layout: Layout = "states", out: Array | None = None
    ) -> Array:
        """The matrix C(q, q̇) of Christoffel symbols; C q̇ is the Coriolis and centrifugal torque.

        Parameters
        ----------
        q, qd : array-like, shape (N, n)
            [rad], [rad/s]
        layout : {"states", "joints"}
            Order of the axes.
        out : ndarray, optional
            Takes the result.

        Returns
        -------
        ndarray, shape (N, n, n)
            [N m s]

        Raises
        ------
        StateError
            For another shape, or entries that are not finite numbers.
        """
        return self._compute("C", (self.arm.n, self.arm.n), {"q": q, "qd": qd}, layout, out)

    def gravity_torque(
        self, q: ArrayLike, *, layout: Layout = "states", out: Array | None = None
    ) -> Array:
        """The gravity torque g(q).

        Parameters
        ----------
        q : array-like, shape (N, n)
            [rad]
        layout : {"states", "joints"}
            Order of the axes.
        out : ndarray, optional
            Takes the result.

        Returns
        -------
        ndarray, shape (N, n)
            [N m]

        Raises
        ------
        StateError
            For another shape, or entries that are not finite numbers.
        """
        return self._compute("g", (self.arm.n,), {"q": q}, layout, out)

    def torque_regressor(
        self,
        q: ArrayLike,
        qd: ArrayLike,
        qdd: ArrayLike,
        *,
        layout: Layout = "states",
        out: Array | None = None,
    ) -> Array:
        """The regressor Y(q, q̇, q̈), with τ = Y π.

        Parameters
        ----------
        q, qd, qdd : array-like, shape (N, n)
            [rad], [rad/s], [rad/s²]
        layout : {"states", "joints"}
            Order of the axes.
        out : ndarray, optional
            Takes the result.

        Returns
        -------
        ndarray, shape (N, n, 10 n)
            Columns in the order of `SerialArm.parameters`.

        Raises
        ------
        StateError
            For another shape, or entries that are not finite numbers.
        """
        shape = (self.arm.n, 10 * self.arm.n)
        return self._compute("regressor", shape, {"q": q, "qd": qd, "qdd": qdd}, layout, out)

    def _compute(
        self,
        quantity: Any,
        shape: tuple[int, ...],
        arrays: dict[str, ArrayLike],
        layout: Layout,
        out: Array | None,
    ) -> Array:
        run = _code((self.arm,), quantity, self.path)
        return _shared(run, self.arm, self.threads, shape, arrays, layout, out)


@dataclass(frozen=True, eq=False)
class DifferenceKernel:
    """The compiled torque difference of two arms; values that both need are computed once.

    Attributes
    ----------
    a, b : SerialArm
    threads : int
    path : {"llvm", "numpy"}
    """

    a: SerialArm
    b: SerialArm
    threads: int
    path: Path

    def __call__(
        self,
        q: ArrayLike,
        qd: ArrayLike,
        qdd: ArrayLike,
        *,
        layout: Layout = "states",
        out: Array | None = None,
    ) -> Array:
        """The torque difference τ_a − τ_b.

        Parameters
        ----------
        q, qd, qdd : array-like, shape (N, n)
            [rad], [rad/s], [rad/s²]
        layout : {"states", "joints"}
            Order of the axes, see `Kernel`.
        out : ndarray, optional
            Takes the result.

        Returns
        -------
        ndarray, shape (N, n)
            [N m]

        Raises
        ------
        StateError
            For another shape, or entries that are not finite numbers.
        """
        run = _code((self.a, self.b), "difference", self.path)
        arrays = {"q": q, "qd": qd, "qdd": qdd}
        return _shared(run, self.a, self.threads, (self.a.n,), arrays, layout, out)


@lru_cache(maxsize=64)
def _code(arms: tuple[SerialArm, ...], quantity: Any, path: Path) -> _Run:
    """The generated code of one arm, or of two and their difference.

    Arms are immutable, so each is looked up once.
    """

    def make() -> bytes:
        from .kernel_source import made  # its import takes longer than reading from disk

        return made(arms, quantity, path)

    with _ONE_AT_A_TIME:
        if path == "numpy":
            key = fingerprint(arms, quantity, path)
            names: dict[str, Any] = {}
            exec(kept(f"{quantity}_{key}.py", make), names)  # noqa: S102 - generated here
            python: _Run = names["run"]
            return python
        from .machine_code import KernelCode, processor

        key = fingerprint(arms, quantity, path, processor())
        return KernelCode(kept(f"{quantity}_{key}.o", make))


def _shared(
    run: _Run,
    arm: SerialArm,
    threads: int,
    shape: tuple[int, ...],
    arrays: dict[str, ArrayLike],
    layout: Layout,
    out: Array | None,
) -> Array:
    """Run the code on the states, shared among threads."""
    views, single = as_states(arm, arrays, layout)
    count = len(views["q"])
    result, flat = empty_result(count, shape, layout, out)
    for name, view in views.items():
        if np.may_share_memory(view, flat):
            raise StateError(f"out overlaps {name} in memory; give an array of its own")

    def share(part: slice) -> None:
        qd, qdd = (views[name][part] if name in views else None for name in ("qd", "qdd"))
        run(views["q"][part], qd, qdd, flat[part])

    if threads == 1 or count < 2 * threads:
        share(slice(None))
    else:
        edges = np.linspace(0, count, threads + 1).astype(int)
        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(share, map(slice, edges[:-1], edges[1:])))
    refuse_unless_finite(arm, views, flat)
    if not single:
        return result
    one: Array = result[0] if layout == "states" else result[..., 0]
    return one


def _checked(threads: int, path: Path | None) -> tuple[int, Path]:
    threads = integer("threads", threads, least=1)
    path = path or default_path()
    if path not in get_args(Path):
        raise UsageError(f"path must be one of {', '.join(get_args(Path))}, not {path!r}")
    if path == "llvm" and default_path() != "llvm":
        raise UsageError("llvmlite is not installed; pip install 'ur5check[fast]', or path='numpy'")
    return threads, path
