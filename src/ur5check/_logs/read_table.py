"""Numbers of a CSV, text or Parquet file, by PyArrow: with a header or without one.

Rows of another length than the first are left out and counted; cells that are no numbers are nan.
What is wrong with the numbers themselves, `row_checks` finds.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._errors import UsageError
from .._robot.transforms import Array

__all__ = ["Table", "read_table"]


@dataclass(frozen=True, eq=False)
class Table:
    """Columns of numbers.

    names : () where the file has no header
    values : shape (N, columns); nan for a cell that is no number
    rows : row of the file that each sample stands in, from 1, shape (N,)
    cut : rows of another length than the first: left out
    """

    names: tuple[str, ...]
    values: Array
    rows: NDArray[np.int64]
    cut: tuple[int, ...] = ()


def read_table(file: Path) -> Table:
    """Read a table.  Raises UsageError for a file that holds none."""
    if file.suffix.lower() == ".parquet":
        return _parquet(file)
    return _text(file)


def _arrow() -> Any:
    try:
        import pyarrow.csv
        import pyarrow.parquet
    except ImportError:
        raise UsageError("reading tables needs PyArrow: pip install 'ur5check[logs]'") from None
    return pyarrow


def _parquet(file: Path) -> Table:
    pyarrow = _arrow()
    try:
        table = pyarrow.parquet.read_table(file)
    except (pyarrow.ArrowException, OSError) as error:
        raise UsageError(f"{file}: cannot be read as Parquet: {error}") from None
    return Table(tuple(table.column_names), _numbers(table), np.arange(1, table.num_rows + 1))


def _text(file: Path) -> Table:
    pyarrow = _arrow()
    first, separator = _first_line(file)
    cells = [cell.strip().strip('"') for cell in _split(first, separator)]
    header = not all(map(_is_number, cells))
    cut: list[int] = []

    def skip(row: Any) -> str:
        cut.append(row.number if row.number is not None else 0)
        return "skip"

    csv = pyarrow.csv
    try:
        table = csv.read_csv(
            file,
            # One thread, so that PyArrow numbers the rows that it leaves out.
            read_options=csv.ReadOptions(
                use_threads=False,
                column_names=[str(k) for k in range(len(cells))],
                skip_rows=1 if header else 0,
            ),
            parse_options=csv.ParseOptions(delimiter=separator, invalid_row_handler=skip),
            convert_options=csv.ConvertOptions(
                null_values=["", "nan", "NaN", "NAN", "null"], strings_can_be_null=True
            ),
        )
    except (pyarrow.ArrowException, OSError) as error:
        raise UsageError(f"{file}: cannot be read as a table: {error}") from None
    rows = np.arange(1, table.num_rows + len(cut) + 1) + header
    kept = rows[~np.isin(rows, cut)] if cut else rows
    if len(kept) != table.num_rows:
        kept = np.arange(1, table.num_rows + 1) + header
    return Table(tuple(cells) if header else (), _numbers(table), kept, tuple(cut))


def _first_line(file: Path) -> tuple[str, str]:
    """The first line, and what separates its cells."""
    try:
        with file.open("rb") as stream:
            raw = stream.readline(1_000_000)
        line = raw.decode("utf-8-sig").strip("\r\n")
    except UnicodeDecodeError:
        raise UsageError(f"{file}: is no text; give a CSV, Parquet or bag file") from None
    except OSError as error:
        raise UsageError(f"{file}: cannot be read: {error.strerror}") from None
    if not line.strip():
        raise UsageError(f"{file}: is empty, or begins with an empty line")
    separator = max((",", ";", "\t", " "), key=lambda s: (line.count(s), s == ","))
    return line, separator


def _split(line: str, separator: str) -> list[str]:
    return line.split() if separator == " " else line.split(separator)


def _numbers(table: Any) -> Array:
    """Each column as floats; text cells that are no numbers become nan."""
    values = np.empty((table.num_rows, table.num_columns))
    for k, column in enumerate(table.columns):
        try:
            values[:, k] = column.cast("float64").to_numpy(zero_copy_only=False)
        except Exception:  # noqa: BLE001 - of PyArrow's many: a cell that is no number
            values[:, k] = [_float(cell) for cell in column.to_pylist()]
    return values


def _float(cell: object) -> float:
    try:
        return float(str(cell))
    except ValueError:
        return float("nan")


def _is_number(text: str) -> bool:
    return not np.isnan(_float(text)) or text.strip().lower() in ("", "nan")
