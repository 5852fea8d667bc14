"""A closed form as a program: inputs, assignments in order, outputs.

Every assignment is a sum of terms, every term a number times names defined before it.  There are no
loops, branches or functions: cosines and sines are inputs.  The printers write a program;
`evaluate` runs it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import reduce
from operator import mul
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..._errors import StateError

__all__ = [
    "STATE",
    "Assignment",
    "Operations",
    "Program",
    "Term",
    "read_input",
    "state_names",
    "value_of",
]

#: Kinds of inputs of a joint's state, joint i from 1: `q1`, cosine `c1`, sine `s1`, rates.
STATE = ("q", "c", "s", "qd", "qdd")


def state_names(kind: str, n: int) -> tuple[str, ...]:
    """`q1`, `q2`, … of one kind of STATE."""
    return tuple(f"{kind}{i}" for i in range(1, n + 1))


def read_input(name: str) -> tuple[str, int]:
    """Its kind, of STATE, and its joint, from 0: "qd3" is ("qd", 2)."""
    kind = name.rstrip("0123456789")
    return kind, int(name.removeprefix(kind)) - 1


@dataclass(frozen=True, slots=True)
class Term:
    """k times the product of the named values."""

    k: float
    factors: tuple[str, ...] = ()

    @property
    def multiplications(self) -> int:
        """A factor of ±1 is a sign: no multiplication."""
        return max(len(self.factors) + (abs(self.k) != 1.0) - 1, 0)


@dataclass(frozen=True, slots=True)
class Assignment:
    """name = Σ terms; zero without terms."""

    name: str
    terms: tuple[Term, ...]


def value_of(line: Assignment, values: Mapping[str, Any]) -> Any:
    """Σ k · (product of the named values), for any scalars with + − ×.

    Signs are free: a k of ±1 is no product, and a negative term is subtracted.
    """
    total: Any = None
    for term in line.terms:
        size, factors = abs(term.k), [values[name] for name in term.factors]
        product = reduce(mul, factors if size == 1.0 and factors else [size, *factors])
        if total is None:
            total = -product if term.k < 0.0 else product
        else:
            total = total - product if term.k < 0.0 else total + product
    return 0.0 if total is None else total


@dataclass(frozen=True, slots=True)
class Operations:
    """Numbers of × and of + (or −).  Signs are free: −x − y counts as one addition."""

    multiplications: int
    additions: int

    @classmethod
    def of(cls, assignments: Sequence[Assignment]) -> Operations:
        return cls(
            sum(term.multiplications for line in assignments for term in line.terms),
            sum(max(len(line.terms) - 1, 0) for line in assignments),
        )

    @property
    def total(self) -> int:
        return self.multiplications + self.additions

    def __str__(self) -> str:
        return f"{self.multiplications} × and {self.additions} +, {self.total} in all"


@dataclass(frozen=True, eq=False)
class Program:
    """One quantity of one arm in closed form.

    Attributes
    ----------
    arm : str
        The arm's name.
    n : int
        Number of joints.
    quantity : str
        "tau", "M", "C", "g", "bias", "regressor" or "difference".
    unit : str
        Of the outputs.
    shape : tuple of int
        Of the result at one state.
    inputs : tuple of str
        Names of the state that are used: q, its cosine c and sine s, qd, qdd of a joint, "c2".
    assignments : tuple of Assignment
        In order; computed once per state.
    outputs : tuple of Assignment
        One per entry of the result, row by row.
    setup : tuple of Assignment
        Of parameters alone, computed once per arm.
    parameters : mapping of str to float
        Symbols with their values of the arm.
    """

    arm: str
    n: int
    quantity: str
    unit: str
    shape: tuple[int, ...]
    inputs: tuple[str, ...]
    assignments: tuple[Assignment, ...]
    outputs: tuple[Assignment, ...]
    setup: tuple[Assignment, ...] = ()
    parameters: Mapping[str, float] = field(default_factory=dict)

    @property
    def operations(self) -> Operations:
        """Per state, without the cosines and sines of the joint angles."""
        return Operations.of((*self.assignments, *self.outputs))

    @property
    def setup_operations(self) -> Operations:
        """Per arm, where parameters are symbols."""
        return Operations.of(self.setup)

    @property
    def arguments(self) -> tuple[str, ...]:
        """Which of q, qd, qdd the quantity depends on."""
        used = {"q", *(read_input(name)[0] for name in self.inputs)}
        return tuple(name for name in ("q", "qd", "qdd") if name in used)

    def evaluate(
        self,
        q: ArrayLike,
        qd: ArrayLike | None = None,
        qdd: ArrayLike | None = None,
        **parameters: float,
    ) -> NDArray[Any]:
        """The quantity at each state, line by line with NumPy.

        Parameters
        ----------
        q, qd, qdd : array-like, shape (..., n)
            [rad], [rad/s], [rad/s²]; those of `arguments`.
        **parameters : float
            Other values for some of the symbols.

        Returns
        -------
        ndarray, shape (..., *shape)
            In `unit`.

        Raises
        ------
        StateError
            For a missing array, a wrong shape or an unknown parameter.
        """
        if unknown := parameters.keys() - self.parameters.keys():
            raise StateError(
                f"{min(unknown)} is not a parameter of this program; see its parameters"
            )
        given = {"q": q, "qd": qd, "qdd": qdd}
        arrays = {name: self._checked(name, given[name]) for name in self.arguments}
        lead = np.broadcast_shapes(*(array.shape[:-1] for array in arrays.values()))
        values: dict[str, Any] = {**self.parameters, **parameters}
        for name in self.inputs:
            kind, joint = read_input(name)
            read = {"c": np.cos, "s": np.sin}.get(kind)
            values[name] = read(arrays["q"][..., joint]) if read else arrays[kind][..., joint]
        for line in (*self.setup, *self.assignments):
            values[line.name] = value_of(line, values)
        entries = [np.broadcast_to(value_of(line, values), lead) for line in self.outputs]
        return np.stack(entries, axis=-1).reshape((*lead, *self.shape))

    def _checked(self, name: str, given: ArrayLike | None) -> NDArray[Any]:
        array = np.asarray(np.nan if given is None else given)
        if array.ndim == 0 or array.shape[-1] != self.n or array.dtype.kind not in "iufc":
            raise StateError(f"{name} must be an array of numbers of shape (..., {self.n})")
        return array
