"""Stated uncertainties of two models, from a list (`mass=1%,centre=3%`) or from a TOML file:

mass = "1%"            # of both models; a bare number has the quantity's unit
tensor = "10%"
[b]                    # of the second model alone; [a] likewise
centre = 0.002
[b.links.forearm]      # of one of its links
mass = 0.05
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .._errors import UsageError
from .._files import read_regular
from .._robot.serial_arm import SerialArm
from .._robot.uncertainty import ArmUncertainty, BodyUncertainty, Deviation
from .suggestions import did_you_mean

__all__ = ["read_uncertainty"]

_QUANTITIES = ("mass", "centre", "tensor")


def read_uncertainty(
    source: str | Path, a: SerialArm, b: SerialArm
) -> tuple[ArmUncertainty, ArmUncertainty]:
    """The uncertainties of two arms.

    source : a list such as "mass=1%,centre=0.002", or the path of a .toml file

    Raises UsageError for a file that cannot be read, a word or number that has no meaning, a link
    that the arm does not have, and where nothing at all is uncertain.
    """
    text = str(source)
    table = _table_of_file(text) if text.lower().endswith(".toml") else _table_of_list(text)
    common = {key: value for key, value in table.items() if key not in ("a", "b")}
    found = tuple(
        _arm(arm, common, table.get(side, {}), f"{text}: [{side}]" if side in table else text)
        for side, arm in (("a", a), ("b", b))
    )
    deviations = (
        getattr(body, quantity)
        for each in found
        for body in (each.others, *each.links.values())
        for quantity in _QUANTITIES
    )
    if not any(deviation.value for deviation in deviations):
        raise UsageError(f"uncertainty {text}: nothing is uncertain; give mass, centre or tensor")
    return found[0], found[1]


def _table_of_file(name: str) -> dict[str, Any]:
    try:
        return tomllib.loads(read_regular(Path(name)).decode("utf-8"))
    except (OSError, ValueError) as error:  # UnicodeDecodeError and TOMLDecodeError are ValueErrors
        reason = getattr(error, "strerror", None) or str(error)
        raise UsageError(f"uncertainty {name}: cannot be read: {reason}") from None


def _table_of_list(text: str) -> dict[str, Any]:
    table: dict[str, Any] = {}
    for part in text.split(","):
        key, found, value = (word.strip() for word in part.partition("="))
        if not found or key in table:
            raise UsageError(
                f"uncertainty {text!r}: write each of {', '.join(_QUANTITIES)} once, as in "
                "mass=1%,centre=0.002, or name a .toml file"
            )
        table[key] = value
    return table


def _arm(arm: SerialArm, common: Mapping[str, Any], side: Any, where: str) -> ArmUncertainty:
    if not isinstance(side, Mapping):
        raise UsageError(f"{where} must be a table of {', '.join(_QUANTITIES)} and links")
    given = {**common, **{key: value for key, value in side.items() if key != "links"}}
    links = side.get("links", {})
    if not isinstance(links, Mapping) or not all(isinstance(x, Mapping) for x in links.values()):
        raise UsageError(f"{where}: links must be tables, such as [a.links.{arm.links[0].name}]")
    names = [link.name for link in arm.links]
    for name in links:
        if name not in names:
            raise UsageError(
                f"{where}: {arm.label!r} has no moving link {name!r}; {did_you_mean(name, names)}"
            )
    return ArmUncertainty(
        _body(given, where),
        {name: _body({**given, **own}, f"{where} link {name!r}") for name, own in links.items()},
    )


def _body(given: Mapping[str, Any], where: str) -> BodyUncertainty:
    for key in given:
        if key not in _QUANTITIES:
            raise UsageError(f"{where}: {key!r} is no quantity; {did_you_mean(key, _QUANTITIES)}")
    return BodyUncertainty(
        **{key: _deviation(value, f"{where}: {key}") for key, value in given.items()}
    )


def _deviation(value: object, where: str) -> Deviation:
    text = str(value).strip()
    relative = text.endswith("%")
    try:
        if isinstance(value, bool):
            raise ValueError
        number = float(text.removesuffix("%"))
    except ValueError:
        number = math.nan
    if not (math.isfinite(number) and number >= 0.0):
        raise UsageError(f"{where} = {value!r}: give a standard deviation, such as 0.002 or '3%'")
    return Deviation(number / 100.0 if relative else number, relative)
