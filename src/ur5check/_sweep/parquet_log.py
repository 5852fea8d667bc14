"""A log as Parquet: numeric columns, read by row groups."""

from __future__ import annotations

import hashlib
import threading
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from .._errors import StateError, UsageError
from .._robot.serial_arm import SerialArm
from .._robot.states import States
from .._robot.transforms import Array
from .log_columns import state_columns, states_of
from .state_sample import BLOCK

__all__ = ["ParquetLog", "import_parquet", "open_parquet"]

_CACHED_GROUPS = 4
_reading = threading.Lock()


@dataclass(frozen=True, eq=False)
class ParquetLog:
    """`count` states in a file.

    columns : names of the 3 n columns that are read
    groups : number of rows before each row group, and of the whole file
    """

    file: Path
    columns: tuple[str, ...]
    count: int
    groups: tuple[int, ...]
    sha256: str

    def block(self, k: int) -> States:
        """Raises StateError with file, row and column of an entry that is not a finite number."""
        start, stop = BLOCK * k, min(BLOCK * (k + 1), self.count)
        parts = list(self._parts(start, stop))
        return states_of(parts[0] if len(parts) == 1 else np.concatenate(parts, axis=1))

    def _parts(self, start: int, stop: int) -> Iterator[Array]:
        """Rows start … stop − 1, from the row groups that hold them."""
        group = bisect_right(self.groups, start) - 1
        while start < stop:
            base, end = self.groups[group], self.groups[group + 1]
            with _reading:  # one thread reads, the others use the cache
                rows = _row_group(self, group)
            yield rows[:, start - base : min(stop, end) - base]
            start, group = end, group + 1

    def description(self) -> dict[str, Any]:
        """The states depend on the content of the file, not on its name."""
        return {"kind": "parquet", "file": self.file.name, "sha256": self.sha256}


@lru_cache(maxsize=_CACHED_GROUPS)
def _row_group(log: ParquetLog, group: int) -> Array:
    """One row group, shape (3 n, rows).  Raises StateError for a number that is not finite."""
    with import_parquet().ParquetFile(log.file) as file:
        if file.metadata.num_rows != log.count:
            raise StateError(f"{log.file}: changed during the sweep; start again")
        table = file.read_row_group(group, columns=list(log.columns), use_threads=False)
    rows = np.empty((len(log.columns), table.num_rows))
    for row, name in zip(rows, log.columns, strict=True):
        column = table.column(name)
        row[:] = column.to_numpy()  # a null becomes nan
        if not np.isfinite(row).all():
            at = int(np.flatnonzero(~np.isfinite(row))[0])
            raise StateError(
                f"{log.file}: row {log.groups[group] + at + 1}: column {name!r} is not a finite "
                f"number (got {column[at].as_py()}); correct or delete this row"
            )
    return rows


def open_parquet(file: Path, arm: SerialArm) -> ParquetLog:
    """Find the columns of `arm`'s joints.

    Raises StateError for a file that is not Parquet, has no rows or lacks columns, UsageError
    without pyarrow.
    """
    parquet = import_parquet()
    import pyarrow

    try:
        with parquet.ParquetFile(file) as opened:
            metadata, schema = opened.metadata, opened.schema_arrow
    except pyarrow.ArrowException as error:
        raise StateError(f"{file}: is not a Parquet file: {error}") from None
    names = tuple(schema.names[k] for k in state_columns(schema.names, arm, file))
    for name in names:
        kind = schema.field(name).type
        if not (pyarrow.types.is_floating(kind) or pyarrow.types.is_integer(kind)):
            raise StateError(f"{file}: column {name!r} holds {kind}; it must hold numbers")
    if metadata.num_rows == 0:
        raise StateError(f"{file}: contains no state")
    sizes = [metadata.row_group(i).num_rows for i in range(metadata.num_row_groups)]
    with file.open("rb") as stream:
        digest = hashlib.file_digest(stream, "sha256").hexdigest()
    groups = tuple(np.cumsum([0, *sizes]).tolist())
    return ParquetLog(file.resolve(), names, metadata.num_rows, groups, digest)


def import_parquet() -> Any:
    """`pyarrow.parquet`.  Raises UsageError where it is not installed."""
    try:
        from pyarrow import parquet
    except ImportError:
        raise UsageError(
            "Parquet needs pyarrow; install it with `pip install 'ur5check[parquet]'`"
        ) from None
    return parquet
