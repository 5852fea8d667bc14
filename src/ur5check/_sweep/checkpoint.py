"""What is done so far, on disk: whole or not there, and only for the sweep that it was written for.

The file is JSON: what the sweep depends on, how many blocks from the first are done, their tally.
JSON keeps a float64 to its last bit, so a sweep that goes on ends at the digits it would have had.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .._errors import UsageError
from .._files import write_whole
from .statistics import Tally
from .sweep_plan import Plan

__all__ = ["Checkpoint", "load", "save", "tally_value"]

_FORMAT = "ur5check.sweep-checkpoint/1"


@dataclass(frozen=True, eq=False)
class Checkpoint:
    """Blocks 0 … blocks − 1, and what was kept of them."""

    blocks: int
    tally: Tally


def save(path: Path, plan: Plan, done: Checkpoint) -> None:
    """Write beside the old file, then put it in its place in one step.

    Raises UsageError if it cannot be written.
    """
    value = {
        "format": _FORMAT,
        "of": plan.description(),
        "blocks": done.blocks,
        "tally": tally_value(done.tally),
    }
    try:
        write_whole(path, json.dumps(value, allow_nan=False).encode())
    except OSError as error:
        raise UsageError(f"checkpoint {path}: cannot be written: {error.strerror}") from None


def load(path: Path, plan: Plan) -> Checkpoint | None:
    """What is done of this plan; None if there is no such file yet.

    Raises UsageError for a file that is no checkpoint, or one of another sweep, and where none
    could be written.
    """
    if not path.resolve().parent.is_dir():
        raise UsageError(f"checkpoint {path}: there is no such folder; make it first")
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        return None
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is no text"
        raise UsageError(f"checkpoint {path}: cannot be read: {reason}") from None
    try:
        value = json.loads(text)
        if value["format"] != _FORMAT:
            raise ValueError(value["format"])
        _check_same(path, value["of"], plan.description())
        done = Checkpoint(int(value["blocks"]), _tally(value["tally"]))
    except (ValueError, KeyError, TypeError, IndexError):
        raise UsageError(
            f"checkpoint {path}: is no checkpoint of a sweep; name another file, or delete it"
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


def tally_value(tally: Tally) -> dict[str, Any]:
    """A tally as plain values, every digit kept.  Histograms are mostly empty: only what is not."""
    joint, bin_ = np.nonzero(tally.bins)
    return {
        "count": tally.count,
        "squares": [hex(total) for total in tally.squares],
        "maximum": tally.maximum.tolist(),
        "worst": tally.worst.tolist(),
        "worst_states": tally.worst_states.tolist(),
        "bins": {
            "shape": list(tally.bins.shape),
            "joint": joint.tolist(),
            "bin": bin_.tolist(),
            "count": tally.bins[joint, bin_].tolist(),
        },
        "over": tally.over.tolist(),
        "visits": tally.visits.tolist(),
        "reach": tally.reach.tolist(),
    }


def _tally(value: dict[str, Any]) -> Tally:
    bins = np.zeros(value["bins"]["shape"], np.int64)
    bins[value["bins"]["joint"], value["bins"]["bin"]] = value["bins"]["count"]
    return Tally(
        count=int(value["count"]),
        squares=tuple(int(total, 16) for total in value["squares"]),
        maximum=np.array(value["maximum"]),
        worst=np.array(value["worst"], np.int64),
        worst_states=np.array(value["worst_states"]),
        bins=bins,
        over=np.array(value["over"], np.int64),
        visits=np.array(value["visits"], np.int64),
        reach=np.array(value["reach"]),
    )
