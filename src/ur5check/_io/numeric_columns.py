"""Columns of numbers, by name, from a CSV or a Parquet file: read whole, every number looked at.

For tables that fit in memory, such as a trajectory.  Files of millions of states are read a block
at a time elsewhere (`_sweep.state_log`).
"""

from __future__ import annotations

import csv
import hashlib
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .._errors import StateError, UsageError
from .._robot.transforms import Array

__all__ = ["NumberColumns", "read_columns"]


@dataclass(frozen=True, eq=False)
class NumberColumns:
    """A table.

    columns : by name, each of shape (K,);  sha256 : of the file
    """

    file: str
    columns: dict[str, Array]
    sha256: str

    def __contains__(self, name: str) -> bool:
        return name in self.columns

    def __getitem__(self, name: str) -> Array:
        """Raises StateError for a column that is not there."""
        if name not in self.columns:
            known = ", ".join(list(self.columns)[:12])
            raise StateError(f"{self.file}: there is no column {name!r}; it has {known}")
        return self.columns[name]


def read_columns(file: str | Path) -> NumberColumns:
    """All columns of a .csv (one header line, plain numbers) or .parquet file.

    Raises StateError with file, line, column and value for what is no finite number, for rows of
    another width, and for a file that is neither; UsageError for Parquet without pyarrow.
    """
    path = Path(file)
    readers = {".csv": _csv, ".parquet": _parquet}
    reader = readers.get(path.suffix.lower())
    if reader is None:
        raise StateError(f"{path}: is no table that is read here; give a .csv or a .parquet file")
    try:
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
    except FileNotFoundError:
        raise StateError(f"{path}: there is no such file; correct the path") from None
    except OSError as error:
        raise StateError(f"{path}: cannot be read: {error.strerror}") from None
    columns = reader(path)
    if not columns or not len(next(iter(columns.values()))):
        raise StateError(f"{path}: holds no row of numbers; write one header line, then the rows")
    return NumberColumns(str(path), columns, digest)


def _csv(path: Path) -> dict[str, Array]:
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except UnicodeDecodeError:
        raise StateError(f"{path}: is no text; a CSV is UTF-8") from None
    rows = csv.reader(lines)
    header = [name.strip() for name in next(rows, [])]
    _refuse_doubles(path, header)
    table = []
    for cells in rows:
        number = rows.line_num
        if len(cells) != len(header):
            raise StateError(
                f"{path}:{number}: has {len(cells)} columns where the header has {len(header)}; "
                "write one number a column"
            )
        table.append([_number(path, number, *cell) for cell in zip(header, cells, strict=True)])
    values = np.array(table, dtype=np.float64).reshape(len(table), len(header))
    return dict(zip(header, values.T, strict=True))


def _number(path: Path, line: int, column: str, text: str) -> float:
    try:
        value = float(text) if "_" not in text else math.nan
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise StateError(
            f"{path}:{line}: column {column!r} is no finite number (got {text!r}); repair this line"
        )
    return value


def _parquet(path: Path) -> dict[str, Array]:
    try:
        import pyarrow
        from pyarrow import parquet
    except ImportError:
        raise UsageError("Parquet needs pyarrow; pip install 'ur5check[parquet]'") from None
    try:
        table = parquet.read_table(path)
    except (pyarrow.ArrowException, OSError) as error:
        raise StateError(f"{path}: is no Parquet file: {error}") from None
    _refuse_doubles(path, table.column_names)
    return {name: _checked(path, name, table.column(name)) for name in table.column_names}


def _checked(path: Path, name: str, column: Any) -> Array:
    try:
        values = np.asarray(column.to_numpy(), dtype=np.float64)  # a null becomes nan
    except (TypeError, ValueError):
        raise StateError(
            f"{path}: column {name!r} holds {column.type}; it must hold numbers"
        ) from None
    bad = np.flatnonzero(~np.isfinite(values))
    if len(bad):
        raise StateError(
            f"{path}: row {bad[0] + 1}: column {name!r} is no finite number "
            f"(got {column[int(bad[0])].as_py()}); repair this row"
        )
    return values


def _refuse_doubles(path: Path, header: Sequence[str]) -> None:
    for name in header:
        if header.count(name) > 1:
            raise StateError(f"{path}:1: two columns are called {name!r}; rename one of them")
