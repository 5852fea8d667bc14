"""The states of a log, CSV or Parquet, read block by block."""

from __future__ import annotations

from os import PathLike
from pathlib import Path

from .._errors import StateError
from .._robot.serial_arm import SerialArm
from .csv_log import CsvLog, open_csv
from .parquet_log import ParquetLog, open_parquet

__all__ = ["is_log", "log_sample"]

_SUFFIXES = (".csv", ".parquet")


def is_log(name: str | PathLike[str]) -> bool:
    """Whether a sample is the name of a log."""
    return Path(name).suffix.lower() in _SUFFIXES


def log_sample(file: Path, arm: SerialArm) -> CsvLog | ParquetLog:
    """The states of a log.  Raises StateError for a file that cannot be read as one."""
    if not file.is_file():
        raise StateError(f"{file}: there is no such file; name a .csv or .parquet log")
    try:
        return (open_csv if file.suffix.lower() == ".csv" else open_parquet)(file, arm)
    except OSError as error:
        raise StateError(f"{file}: cannot be read: {error.strerror or error}") from None
