"""The checkpoint of a sweep: a file with the statistics of the blocks that are done.

The file is JSON: what the sweep depends on, the number of blocks done (from the first on), and
their statistics.  JSON keeps every bit of a float64, so that a resumed sweep ends with the same
digits. It is written atomically, and accepted only by the sweep it was written for.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .._errors import UsageError
from .._files import write_whole
from .statistics import Statistics
from .sweep_plan import Plan

__all__ = ["Checkpoint", "load", "save", "statistics_value"]

_FORMAT = "ur5check.sweep-checkpoint/2"


@dataclass(frozen=True, eq=False)
class Checkpoint:
    """The statistics of blocks 0 … blocks − 1."""

    blocks: int
    statistics: Statistics


def save(path: Path, plan: Plan, done: Checkpoint) -> None:
    """Replace the file in one step.

    Raises UsageError if it cannot be written.
    """
    value = {
        "format": _FORMAT,
        "of": plan.description(),
        "blocks": done.blocks,
        "statistics": statistics_value(done.statistics),
    }
    try:
        write_whole(path, json.dumps(value, allow_nan=False).encode())
    except OSError as error:
        raise UsageError(f"checkpoint {path}: cannot be written: {error.strerror}") from None


def load(path: Path, plan: Plan) -> Checkpoint | None:
    """The checkpoint of this plan; None if there is no such file yet.

    Raises UsageError for a file that is not a checkpoint of this sweep, or a folder that does not
    exist.
    """
    if not path.resolve().parent.is_dir():
        raise UsageError(f"checkpoint {path}: there is no such folder; make it first")
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        return None
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is not a text file"
        raise UsageError(f"checkpoint {path}: cannot be read: {reason}") from None
    try:
        value = json.loads(text)
        if value["format"] != _FORMAT:
            raise ValueError(value["format"])
        _check_same(path, value["of"], plan.description())
        done = Checkpoint(int(value["blocks"]), _statistics(value["statistics"]))
    except (ValueError, KeyError, TypeError, IndexError):
        raise UsageError(
            f"checkpoint {path}: is not a checkpoint of a sweep; name another file, or delete it"
        ) from None
    return done


def _check_same(path: Path, theirs: dict[str, Any], ours: dict[str, Any]) -> None:
    """Raises UsageError, naming what differs."""
    other = [name for name in ours if theirs.get(name) != ours[name]]
    if other:
        raise UsageError(
            f"checkpoint {path}: was written for another sweep (different: {', '.join(other)}); "
            "give the options it was written with, or name another file"
        )


def statistics_value(statistics: Statistics) -> dict[str, Any]:
    """Statistics as plain values, every digit kept; of the histograms only the bins not empty."""
    joint, bin_ = np.nonzero(statistics.bins)
    return {
        "count": statistics.count,
        "squares": [hex(total) for total in statistics.squares],
        "maximum": statistics.maximum.tolist(),
        "worst": statistics.worst.tolist(),
        "worst_states": statistics.worst_states.tolist(),
        "bins": {
            "shape": list(statistics.bins.shape),
            "joint": joint.tolist(),
            "bin": bin_.tolist(),
            "count": statistics.bins[joint, bin_].tolist(),
        },
        "above_tolerance": statistics.above_tolerance.tolist(),
        "visits": statistics.visits.tolist(),
        "reach": statistics.reach.tolist(),
    }


def _statistics(value: dict[str, Any]) -> Statistics:
    bins = np.zeros(value["bins"]["shape"], np.int64)
    bins[value["bins"]["joint"], value["bins"]["bin"]] = value["bins"]["count"]
    return Statistics(
        count=int(value["count"]),
        squares=tuple(int(total, 16) for total in value["squares"]),
        maximum=np.array(value["maximum"]),
        worst=np.array(value["worst"], np.int64),
        worst_states=np.array(value["worst_states"]),
        bins=bins,
        above_tolerance=np.array(value["above_tolerance"], np.int64),
        visits=np.array(value["visits"], np.int64),
        reach=np.array(value["reach"]),
    )
