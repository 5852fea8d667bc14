"""How a recording is to be read, where the file does not say it: from options or a TOML file."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from .._errors import UsageError

__all__ = ["RecordingOptions", "options_from_toml"]


@dataclass(frozen=True)
class RecordingOptions:
    """What a user says about a recording.

    Attributes
    ----------
    columns : str
        What the columns are.  Without a header the blocks in order, "t,q,qd,tau": each but t has
        one column a joint, "-" is a block to be left out.  With a header "q=actual_q_{i}
        tau=effort_{i}": {i} counts joints from 0 or 1, {name} is a joint's name.
    topic : str
        Of a bag with several of joint states.
    rate : float or None
        Samples a second, where there is no clock [Hz].
    degrees : bool
        Whether angles are in degrees.
    gains : tuple of float, length n or 1
        What a unit of the torque column, or of the current, is worth [N m or N], one for each
        joint or one for all; a negative gain turns the sign.  () for torques as they are.
    offsets : tuple of float, length n
        Taken off each position [rad or m]; () for none.
    coupling : tuple of tuple of float, shape (n, n)
        q_joints = coupling · q_recorded, and torques by its inverse transpose; () for none.
    by_order : bool
        Whether the recording's joints are the model's in order, whatever their names.
    """

    columns: str = ""
    topic: str = ""
    rate: float | None = None
    degrees: bool = False
    gains: tuple[float, ...] = ()
    offsets: tuple[float, ...] = ()
    coupling: tuple[tuple[float, ...], ...] = ()
    by_order: bool = False


def options_from_toml(file: Path) -> RecordingOptions:
    """The options in a TOML file, whose keys are the fields of `RecordingOptions`.

    Raises UsageError for a file that cannot be read, an unknown key or a value of another type.
    """
    try:
        table = tomllib.loads(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise UsageError(f"{file}: cannot be read: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise UsageError(f"{file}: is no TOML: {error}") from None
    known = {field.name for field in fields(RecordingOptions)}
    for key in table:
        if key not in known:
            raise UsageError(f"{file}: {key!r} is no key; known are {', '.join(sorted(known))}")
    return RecordingOptions(**{key: _typed(file, key, value) for key, value in table.items()})


def _typed(file: Path, key: str, value: Any) -> Any:
    if key in ("columns", "topic") and isinstance(value, str):
        return value
    if key in ("degrees", "by_order") and isinstance(value, bool):
        return value
    if key == "rate" and _is_number(value):
        return float(value)
    if key in ("gains", "offsets") and isinstance(value, list) and all(map(_is_number, value)):
        return tuple(map(float, value))
    if (
        key == "coupling"
        and isinstance(value, list)
        and all(isinstance(row, list) and all(map(_is_number, row)) for row in value)
    ):
        return tuple(tuple(map(float, row)) for row in value)
    raise UsageError(f"{file}: {key} = {value!r} has the wrong type; docs/recordings.md shows it")


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
