"""A DH table in a TOML file to a `SerialArm`.

    schema = "ur5check.dh/1"
    name = "paper"
    convention = "standard"            # or "modified" (Craig's)
    gravity = [0.0, 0.0, -9.81]        # in the base frame [m/s²]; may be left out
    base = { xyz = [0.0, 0.0, 0.1], rpy = [0.0, 0.0, 0.0] }   # of frame 0 in the base frame; and
    tool = { xyz = [0.0, 0.0, 0.0], rpy = [0.0, 0.0, 3.14] }  # of the tip in frame n: both may
                                       # be left out, [m] and [rad], turns as in a URDF

    [[joint]]                          # one table a row, base to tip
    joint = "shoulder_pan_joint"
    link = "shoulder_link"
    d = 0.089159                       # [m]
    a = 0.0                            # [m]
    alpha = "pi/2"                     # [rad]: a number, or a fraction of pi, which stays exact
    mass = 3.7                         # [kg]
    com = [0.0, -0.02561, 0.00193]     # in the DH frame [m]
    inertia = { ixx = 0.0169, iyy = 0.0169, izz = 0.00666 }   # about com, DH axes [kg m²]

A row may also give `kind` ("prismatic"), `offset` [rad], `r` (see `DHRow`), `limits` (lower, upper,
velocity, effort), `armature`, `damping` and `friction` (see `Joint`), and products of inertia ixy,
ixz, iyz (else zero).  `title` at the top and
`source` in a row, a table of texts that says where the numbers come from, are for the reader.
"""

from __future__ import annotations

import hashlib
import tomllib
from typing import Any, Literal, cast

import numpy as np

from ..._errors import ModelError
from ..._robot import (
    STANDARD_GRAVITY,
    DHRow,
    Inertia,
    Limits,
    SerialArm,
    Source,
    Transform,
    arm_from_dh,
)
from ..inertia_checks import Place, check_inertia, printed_tensor
from ..model_format import ModelFile
from ..printed_numbers import Printed
from .dh_values import Table

__all__ = ["SCHEMA", "read_dh", "read_dh_file"]

SCHEMA = "ur5check.dh/1"

_TOP = ("schema", "name", "title", "convention", "gravity", "base", "tool", "joint")
_NEEDED = ("joint", "link", "d", "a", "alpha", "mass", "com", "inertia")
_MOTOR = ("armature", "damping", "friction")
_ROW = (*_NEEDED, "kind", "offset", "r", "limits", *_MOTOR, "source")
_MOMENTS, _PRODUCTS = ("ixx", "iyy", "izz"), ("ixy", "ixz", "iyz")
_LIMITS = ("lower", "upper", "velocity", "effort")


def read_dh_file(file: ModelFile) -> SerialArm:
    """The arm in a DH table.  Raises ModelError as `read_dh` does."""
    return read_dh(file.data, file=file.label)


def read_dh(data: bytes, *, file: str) -> SerialArm:
    """The arm that a DH file describes; `file` is what errors and reports call it.

    Raises ModelError for bad TOML, an unknown or missing key, a value that is no finite number,
    degrees or millimetres by mistake, names used twice, or an inertia that no body has.
    """
    text, values = _parsed(data, file)
    top = Table(values, file=file, text=text)
    top.require("schema")
    if values["schema"] != SCHEMA:
        top.fail("schema", "is unknown", f'write schema = "{SCHEMA}"', values["schema"])
    top.refuse_unknown_keys(_TOP)
    top.require("name", "convention")
    name = top.text("name")
    if "title" in values:
        top.text("title")
    convention = top.text("convention", choices=("standard", "modified"))
    gravity = top.vector("gravity", metres=False) if "gravity" in values else STANDARD_GRAVITY
    tables = values.get("joint", [])
    if not isinstance(tables, list) or not tables or not isinstance(tables[0], dict):
        top.fail("joint", "the table has no rows", "write one [[joint]] for each joint")
    rows = [
        _row(_named_row(i, table, file, text), convention, last=i + 1 == len(tables))
        for i, table in enumerate(tables)
    ]
    _refuse_twins(rows, file, text)
    return arm_from_dh(
        name,
        rows,
        convention=cast(Literal["standard", "modified"], convention),
        gravity=gravity,
        base=_pose(top, "base"),
        tool=_pose(top, "tool"),
        source=Source(
            "dh",
            ((file, hashlib.sha256(data).hexdigest()),),
            base="base",
            tip=rows[-1].link,
        ),
    )


def _parsed(data: bytes, file: str) -> tuple[str, dict[str, Any]]:
    fix = "correct the TOML (https://toml.io)"
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise ModelError(
            "the file is not UTF-8 text", fix="save it as UTF-8", file=file, line=line
        ) from None
    try:
        return text, tomllib.loads(text, parse_float=Printed)
    except tomllib.TOMLDecodeError as error:
        # "… (at line 3, column 7)" is all that Python 3.11 tells of the place.
        problem, _, place = str(error).partition(" (at line ")
        digits = place.partition(",")[0]
        raise ModelError(
            f"the file is not TOML: {problem}",
            fix=fix,
            file=file,
            line=int(digits) if digits.isdigit() else None,
        ) from None
    except (RecursionError, ValueError) as error:  # nested too deep; an integer of 5,000 digits
        raise ModelError(f"the file is not TOML: {error}", fix=fix, file=file) from None


def _named_row(i: int, table: object, file: str, text: str) -> Table:
    values = table if isinstance(table, dict) else {}
    joint = values.get("joint")
    name = f"joint {i + 1}" + (f" ({joint})" if isinstance(joint, str) else "")
    return Table(values, file=file, text=text, name=name, row=i)


def _row(table: Table, convention: str, *, last: bool) -> DHRow:
    table.refuse_unknown_keys(_ROW)
    table.require(*_NEEDED)
    given = table.values
    if "source" in given:
        source = table.table("source", ())
        for key in source.values:
            source.text(key)
    if "r" in given and convention == "modified":
        fix = "remove r: it belongs to the standard convention's frames"
        table.fail("r", "has no meaning under the modified convention", fix)
    kind = table.text("kind", choices=("revolute", "prismatic")) if "kind" in given else "revolute"
    return DHRow(
        table.text("link"),
        table.length("d"),
        table.length("a"),
        table.angle("alpha"),
        _inertia(table, last=last),
        table.text("joint"),
        offset=table.angle("offset") if "offset" in given else 0.0,
        kind=cast(Literal["revolute", "prismatic"], kind),
        limits=_limits(table),
        r=np.array(table.vector("r", metres=True)) if "r" in given else None,
        **{key: _loss(table, key) for key in _MOTOR if key in given},
    )


def _loss(table: Table, key: str) -> float:
    value = float(table.number(key))
    if value < 0.0:
        table.fail(
            key, "is negative", "a motor takes energy, it gives none: write it positive", value
        )
    return value


def _pose(top: Table, key: str) -> Transform | None:
    if key not in top.values:
        return None
    table = top.table(key, ("xyz", "rpy"))
    table.require("xyz", "rpy")
    rpy = table.vector("rpy", metres=False)
    if max(map(abs, rpy)) > 2 * np.pi:
        table.fail(
            "rpy", "is beyond a full turn: it looks like degrees", "write radians", list(rpy)
        )
    return Transform.from_rpy(table.vector("xyz", metres=True), rpy)


def _inertia(table: Table, *, last: bool) -> Inertia:
    mass = table.number("mass")
    com = table.vector("com", metres=True)
    entries = table.table("inertia", _MOMENTS + _PRODUCTS)
    entries.require(*_MOMENTS)
    numbers = {
        key: entries.number(key) if key in entries.values else 0.0 for key in _MOMENTS + _PRODUCTS
    }
    tensor, digits = printed_tensor(numbers)
    place = Place(table.file, f"{table.name} ", table.line("mass"), table.line("inertia"))
    check_inertia(mass, tensor, place, digits=digits)
    if last and mass == 0.0:
        problem = "mass zero on a moving tip: no torque would move it, so its motion is free"
        table.fail("mass", problem, "give the last link a mass", 0.0)
    return Inertia(mass, np.array(com), tensor, digits)


def _limits(table: Table) -> Limits:
    if "limits" not in table.values:
        return Limits()
    limits = table.table("limits", _LIMITS)
    given = {key: float(limits.number(key)) for key in limits.values}
    for key in ("velocity", "effort"):
        if given.get(key, 0.0) < 0.0:
            limits.fail(key, "is negative", "it bounds a magnitude: write it positive", given[key])
    if given.get("lower", -np.inf) > given.get("upper", np.inf):
        limits.fail(None, "lower exceeds upper", "swap them", given)
    return Limits(**given)


def _refuse_twins(rows: list[DHRow], file: str, text: str) -> None:
    for key in ("joint", "link"):
        names = [getattr(row, key) for row in rows]
        for i, name in enumerate(names):
            if name in names[:i]:
                twin = Table({}, file=file, text=text, name=f"joint {i + 1}", row=i)
                first = names.index(name) + 1
                problem = f"is the name of row {first} already"
                twin.fail(key, problem, f"give each {key} its own name", name)
