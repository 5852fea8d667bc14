"""A log as CSV: a header line, then one state per line, numbers separated by commas.

The file is read once for its SHA-256 and the byte at which each block of lines begins.  Any block
is then read on its own.
"""

from __future__ import annotations

import hashlib
import math
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .._errors import StateError
from .._robot.serial_arm import SerialArm
from .._robot.states import States
from .._robot.transforms import Array
from .log_columns import state_columns, states_of
from .state_sample import BLOCK

__all__ = ["CsvLog", "open_csv"]

_CHUNK = 1 << 20  # bytes


@dataclass(frozen=True, eq=False)
class CsvLog:
    """`count` states in a file.

    header : names of all columns;  columns : indices of the 3 n that are read
    starts : byte at which each block begins, and the end of the file
    """

    file: Path
    header: tuple[str, ...]
    columns: tuple[int, ...]
    count: int
    starts: tuple[int, ...]
    sha256: str

    def block(self, k: int) -> States:
        """Raises StateError with file, line and column of an entry that is not a finite number."""
        with self.file.open("rb") as file:
            if file.seek(0, os.SEEK_END) != self.starts[-1]:
                raise self._changed()
            file.seek(self.starts[k])
            text = file.read(self.starts[k + 1] - self.starts[k])
        lines = min(BLOCK, self.count - BLOCK * k)
        rows = self._parsed(text, lines)
        if rows is None:
            self._raise_first_error(
                text.decode("utf-8", "replace").split("\n")[:lines], 2 + BLOCK * k
            )
            raise self._changed()
        return states_of(rows)

    def _parsed(self, text: bytes, lines: int) -> Array | None:
        """3 n rows; None if the text is malformed."""
        if text.count(b",") != (len(self.header) - 1) * lines:
            return None
        try:
            table = np.loadtxt(
                text.decode("utf-8").split("\n"),
                delimiter=",",
                usecols=self.columns,
                comments=None,
                max_rows=lines,
                ndmin=2,
            )
        except (ValueError, UnicodeDecodeError):
            return None
        good = len(table) == lines and np.isfinite(table).all()
        return np.ascontiguousarray(table.T) if good else None

    def _raise_first_error(self, lines: list[str], first: int) -> None:
        """Raises StateError for the first error; `first` is the number of the first line."""
        for number, line in enumerate(lines, start=first):
            cells = line.rstrip("\r").split(",")
            if len(cells) != len(self.header):
                raise StateError(
                    f"{self.file}:{number}: has {len(cells)} columns where the header has "
                    f"{len(self.header)} (got {line[:80]!r}); write one state a line"
                )
            for column in self.columns:
                if not _is_number(cells[column]):
                    raise StateError(
                        f"{self.file}:{number}: column {self.header[column]!r} is not a finite "
                        f"number (got {cells[column]!r}); correct or delete this line"
                    )

    def _changed(self) -> StateError:
        return StateError(f"{self.file}: changed during the sweep; start again")

    def description(self) -> dict[str, Any]:
        """The states depend on the content of the file, not on its name."""
        return {"kind": "csv", "file": self.file.name, "sha256": self.sha256}


def open_csv(file: Path, arm: SerialArm) -> CsvLog:
    """Find the columns of `arm`'s joints, and the byte at which each block begins.

    Raises StateError for a file without states or without a needed column.
    """
    with file.open("rb") as stream:
        first = stream.readline()
    try:
        header = first.decode("utf-8-sig").rstrip("\r\n").split(",")
    except UnicodeDecodeError:
        raise StateError(f"{file}:1: is not text; a CSV log is UTF-8") from None
    names = tuple(name.strip().strip('"') for name in header)
    columns = state_columns(names, arm, file)
    count, starts, digest = _index(file)
    if count == 0:
        raise StateError(f"{file}: contains no state")
    return CsvLog(file.resolve(), names, columns, count, starts, digest)


def _index(file: Path) -> tuple[int, tuple[int, ...], str]:
    """Number of lines after the header, byte at which each block begins (and the end), SHA-256."""
    digest = hashlib.sha256()
    starts: list[int] = []
    lines = size = 0
    last = b"\n"
    with file.open("rb") as stream:
        while chunk := stream.read(_CHUNK):
            digest.update(chunk)
            ends = np.flatnonzero(np.frombuffer(chunk, np.uint8) == ord("\n"))
            # The end of line 1 + k·BLOCK is where block k begins.
            begins = ends[-lines % BLOCK :: BLOCK] if len(ends) else ends
            starts += (size + 1 + begins).tolist()
            lines += len(ends)
            size += len(chunk)
            last = chunk[-1:]
    count = lines - 1 + (last != b"\n")
    return count, (*starts[: -(-count // BLOCK)], size), digest.hexdigest()


def _is_number(text: str) -> bool:
    try:
        return math.isfinite(float(text)) and "_" not in text
    except ValueError:
        return False
