"""A sweep's histograms and reach map as Parquet, to plot or merge them.

Two tables, since their rows are about different things: NAME.parquet holds the histograms, one row
a joint and bin that is not empty; NAME.map.parquet the reach map, one row a cell that was visited.
Per-block tables are not written: they would grow with the number of states.
"""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np

from .._errors import UsageError
from .._files import write_whole
from .._sweep.magnitude_histogram import bin_edges
from .._sweep.parquet_log import import_parquet
from .._sweep.reach_map import HEIGHTS
from .._sweep.sweep_result import Sweep

__all__ = ["map_file", "write_parquet"]


def map_file(file: Path) -> Path:
    """Where the reach map goes, beside the histograms."""
    return file.with_suffix(f".map{file.suffix}")


def write_parquet(s: Sweep, file: Path) -> None:
    """Both tables.  Raises UsageError if they cannot be written, or pyarrow is not installed."""
    parquet = import_parquet()
    for path, columns in ((file, _histograms(s)), (map_file(file), _map(s))):
        try:
            write_whole(path, _bytes(parquet, columns))
        except OSError as error:
            raise UsageError(f"--parquet {path}: cannot be written: {error.strerror}") from None


def _histograms(s: Sweep) -> dict[str, Any]:
    joint, bin_ = np.nonzero(s.statistics.bins)
    edges, names = bin_edges(), s.pair.a.joint_names
    return {
        "joint": [names[j] for j in joint],
        "lower": edges[bin_],
        "upper": edges[bin_ + 1],
        "count": s.statistics.bins[joint, bin_],
    }


def _map(s: Sweep) -> dict[str, Any]:
    (seen,) = np.nonzero(s.statistics.visits)
    radii, heights = s.plan.grid.radii(), s.plan.grid.heights()
    column, row = np.divmod(seen, HEIGHTS)
    largest = zip(s.pair.a.joint_names, s.statistics.reach[:, seen], strict=True)
    return {
        "radius_lower": radii[column],
        "radius_upper": radii[column + 1],
        "height_lower": heights[row],
        "height_upper": heights[row + 1],
        "visits": s.statistics.visits[seen],
        **{f"max_{name}": values for name, values in largest},
    }


def _bytes(parquet: Any, columns: dict[str, Any]) -> bytes:
    import pyarrow

    buffer = io.BytesIO()
    parquet.write_table(pyarrow.table(columns), buffer)
    return buffer.getvalue()
