"""A straight line inside a Numba function computes what Python computes, and refuses all else."""

from __future__ import annotations

import math

import numpy as np
import pytest

numba = pytest.importorskip("numba")

from ur5check.kernels.straight_line import straight_line  # noqa: E402 - it needs Numba

BLOCK = 8


def ran(text: str, rows: int = 3) -> np.ndarray:
    """The scratch array after the lines have run over it; its first row counts from 0.5."""
    line = straight_line(text)

    @numba.njit
    def run(w):
        for k in range(BLOCK):
            line(w, k)

    w = np.zeros(rows * BLOCK)
    w[:BLOCK] = np.arange(BLOCK) + 0.5
    run(w)
    return w.reshape(rows, BLOCK)


def test_sums_products_signs_and_entries() -> None:
    found = ran(f"x = w[k]\ny = -x * 2.0 + 3.0 - x\nw[k + {BLOCK}] = z = y\nw[k + {2 * BLOCK}] = z")
    x = np.arange(BLOCK) + 0.5
    assert np.array_equal(found, [x, -x * 2.0 + 3.0 - x, -x * 2.0 + 3.0 - x])


def test_every_digit_of_a_number_is_kept() -> None:
    assert (ran(f"w[k + {BLOCK}] = {math.pi!r}")[1] == math.pi).all()


def test_terms_are_not_moved() -> None:
    """(1 + 1e20) − 1e20 is 0; a compiler that may regroup makes 1 of it."""
    one = "w[k] - w[k] + 1.0"
    assert (ran(f"w[k + {BLOCK}] = ({one} + 1e20) - 1e20")[1] == 0.0).all()


@pytest.mark.parametrize(
    "text",
    [
        "x = w[k] / 2.0",
        "x = abs(w[k])",
        "x = y",
        "x = 2",  # an integer would be divided and overflow as one
        "x = w[j]",
        "x = v[k]",
        "x = w[k - 8]",
        "w[0] = 1.0",
        "x = +w[k]",
        "x += 1.0",
        "if w[k]: x = 1.0",
    ],
)
def test_anything_else_is_refused_and_named(text: str) -> None:
    with pytest.raises(Exception, match="no straight line") as refused:
        ran(f"fine = w[k]\n{text}")
    assert text.split(":")[0].replace("if ", "") in str(refused.value)


@pytest.mark.parametrize("w", [np.zeros((2, BLOCK)), np.zeros(2 * BLOCK, np.float32)])
def test_another_array_is_refused(w: np.ndarray) -> None:
    line = straight_line("w[k] = 1.0")

    @numba.njit
    def run(w):
        line(w, 0)

    with pytest.raises(numba.TypingError, match="a straight line takes"):
        run(w)
