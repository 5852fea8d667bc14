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
    inertia = { ixx = 0.0169, iyy = 0.0169, izz = 0.00666 }   # about com, DH axes [kg m²]; left
                                       # out, or zero, it is unknown: gravity torques can be had

A row may also give `kind` ("prismatic"), `offset` [rad], `r` (see `DHRow`), `limits` (lower, upper,
velocity, effort), `armature`, `damping` and `friction` (see `Joint`), and products of inertia ixy,
ixz, iyz (else zero).  `title` at the top and
`source` in a row, a table of texts that says where the numbers come from, are for the reader.
"""

from __future__ import annotations

import hashlib
import tomllib
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any, Literal, TypeVar, cast

import numpy as np

from ..._errors import ModelError
from ..._finding import Place as FilePlace
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
from ..._robot.robot import ENTRIES, Inertial, Robot, RobotLink
from ..._rules.finding_log import FindingLog
from ..arm_loading import judged_bodies
from ..inertia_checks import Place, check_inertia, printed_tensor
from ..model_format import ModelFile
from ..printed_numbers import Printed, common_rounding
from ..robot_of_arm import robot_of_arm
from .dh_values import Table

__all__ = ["SCHEMA", "read_dh", "read_dh_file", "read_dh_robot"]

_T = TypeVar("_T")

SCHEMA = "ur5check.dh/1"

_TOP = ("schema", "name", "title", "convention", "gravity", "base", "tool", "joint")
_MOTOR = ("armature", "damping", "friction")
_ROW = (
    "joint",
    "link",
    "d",
    "a",
    "alpha",
    "mass",
    "com",
    "inertia",
    "kind",
    "offset",
    "r",
    "limits",
    *_MOTOR,
    "source",
)
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
    return _arm(data, file, _Faults(None))[0]


def read_dh_robot(data: bytes, file: str, log: FindingLog) -> tuple[Robot | None, SerialArm | None]:
    """The same as a robot without branches; all faults go to `log`, and leave no robot."""
    faults = _Faults(log)
    try:
        arm, rows, tables = _arm(data, file, faults)
    except ModelError as error:
        if not faults.found:
            log.findings.append(error.finding)
        return None, None
    links, joints = {}, {}
    for row, table in zip(rows, tables, strict=True):
        links[row.link] = _inertial(row, table)
        joints[row.joint] = _places(table)
    if faults.found:
        log.findings += judged_bodies([RobotLink(name, body) for name, body in links.items()])
        return None, None
    robot = robot_of_arm(arm, file)
    return replace(
        robot,
        links=tuple(
            replace(
                link, inertial=links.get(link.name), place=_place(links.get(link.name), link.place)
            )
            for link in robot.links
        ),
        joints=tuple(
            replace(joint, place=joints[joint.name]["joint"], places=joints[joint.name])
            for joint in robot.joints
        ),
    ), arm


class _Faults:
    """What is done with a fault: raised where there is no log, else recorded, to read on."""

    def __init__(self, log: FindingLog | None) -> None:
        self.log, self.found = log, 0

    @property
    def strict(self) -> bool:
        """Whether numbers that no arm can have are faults; with a log, rules judge them."""
        return self.log is None

    def of(self, read: Callable[[], _T], instead: _T) -> _T:
        """What `read` returns, or `instead` after a fault."""
        try:
            return read()
        except ModelError as error:
            if self.log is None:
                raise
            self.found += 1
            self.log.findings.append(error.finding)
            return instead


def _arm(data: bytes, file: str, faults: _Faults) -> tuple[SerialArm, list[DHRow], list[Table]]:
    text, values = _parsed(data, file)
    top = Table(values, file=file, text=text)
    top.require("schema")
    if values["schema"] != SCHEMA:
        top.fail("schema", "is unknown", f'write schema = "{SCHEMA}"', values["schema"])
    each = faults.of
    for key in values:
        each(partial(top.refuse_unknown_key, key, _TOP), None)
    name = each(partial(top.text, "name"), "")
    if "title" in values:
        each(partial(top.text, "title"), "")
    choices = ("standard", "modified")
    convention = each(partial(top.text, "convention", choices=choices), "standard")
    gravity = STANDARD_GRAVITY
    if "gravity" in values:
        gravity = each(partial(top.vector, "gravity", metres=False), gravity)
    given = values.get("joint", [])
    if not isinstance(given, list) or not given or not isinstance(given[0], dict):
        top.fail("joint", "the table has no rows", "write one [[joint]] for each joint")
    tables = [_named_row(i, table, file, text) for i, table in enumerate(given)]
    rows = [_row(table, convention, faults, last=table is tables[-1]) for table in tables]
    _refuse_twins(rows, file, text, faults)
    base, tool = each(partial(_pose, top, "base"), None), each(partial(_pose, top, "tool"), None)
    source = Source(
        "dh", ((file, hashlib.sha256(data).hexdigest()),), base="base", tip=rows[-1].link
    )
    arm = arm_from_dh(
        name,
        rows,
        convention=cast(Literal["standard", "modified"], convention),
        gravity=gravity,
        base=base,
        tool=tool,
        source=source,
    )
    return arm, rows, tables


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


def _row(table: Table, convention: str, faults: _Faults, *, last: bool) -> DHRow:
    each, given = faults.of, table.values
    for key in given:
        each(partial(table.refuse_unknown_key, key, _ROW), None)
    if "source" in given:
        each(partial(_source, table), None)
    if "r" in given and convention == "modified":
        fix = "remove r: it belongs to the standard convention's frames"
        problem = "has no meaning under the modified convention"
        each(partial(table.fail, "r", problem, fix), None)
    kinds = ("revolute", "prismatic")
    kind = (
        each(partial(table.text, "kind", choices=kinds), kinds[0]) if "kind" in given else kinds[0]
    )
    r = each(partial(table.vector, "r", metres=True), None) if "r" in given else None
    losses = {key: each(partial(_loss, table, key, faults), 0.0) for key in _MOTOR if key in given}
    inertia, known = _inertia(table, faults, last=last)
    return DHRow(
        each(partial(table.text, "link"), ""),
        each(partial(table.length, "d"), 0.0),
        each(partial(table.length, "a"), 0.0),
        each(partial(table.angle, "alpha"), 0.0),
        inertia,
        each(partial(table.text, "joint"), ""),
        offset=each(partial(table.angle, "offset"), 0.0) if "offset" in given else 0.0,
        kind=cast(Literal["revolute", "prismatic"], kind),
        limits=each(partial(_limits, table, faults), Limits()),
        r=None if r is None or convention == "modified" else np.array(r),
        tensor_known=known,
        **losses,
    )


def _source(table: Table) -> None:
    source = table.table("source", ())
    for key in source.values:
        source.text(key)


def _loss(table: Table, key: str, faults: _Faults) -> float:
    value = float(table.number(key))
    if value < 0.0 and (faults.strict or key == "armature"):
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


def _inertia(table: Table, faults: _Faults, *, last: bool) -> tuple[Inertia, bool]:
    """The inertia, and whether its tensor is known: zeros of a body with mass say nothing."""
    each = faults.of
    mass = each(partial(table.number, "mass"), 0.0)
    com = each(partial(table.vector, "com", metres=True), (0.0, 0.0, 0.0))
    numbers = each(partial(_entries, table), None) if "inertia" in table.values else {}
    numbers = numbers or dict.fromkeys(_MOMENTS + _PRODUCTS, 0.0)
    tensor, digits = printed_tensor(numbers)
    known = bool(tensor.any()) or (mass == 0.0 and "inertia" in table.values)
    if faults.strict:
        place = Place(table.file, f"{table.name} ", table.line("mass"), table.line("inertia"))
        check_inertia(mass, tensor, place, digits=digits, point_mass=not known)
        if last and mass == 0.0:
            problem = "mass zero on a moving tip: no torque would move it, so its motion is free"
            table.fail("mass", problem, "give the last link a mass", 0.0)
    return Inertia(mass, np.array(com), tensor, digits), known


def _entries(table: Table) -> dict[str, float]:
    entries = table.table("inertia", _MOMENTS + _PRODUCTS)
    entries.require(*_MOMENTS)
    return {
        key: entries.number(key) if key in entries.values else 0.0 for key in _MOMENTS + _PRODUCTS
    }


def _inertial(row: DHRow, table: Table) -> Inertial:
    """A row's inertia as the sheet writes it; without entries where the tensor is unknown."""
    entries = {}
    if row.tensor_known:
        inertia = table.values.get("inertia", {})
        for key in ENTRIES:
            written = inertia.get(key, 0.0)
            entries[key] = (
                written
                if isinstance(written, Printed)
                else float(row.inertia.tensor["xyz".index(key[1]), "xyz".index(key[2])])
            )
    parts = {"inertial": None, "mass": "mass", "origin": "com", "inertia": "inertia"}
    places = {part: _where(table, key) for part, key in parts.items()}
    rounding = common_rounding(entries)
    com, axes = row.inertia.com, np.zeros(3)
    return Inertial(float(row.inertia.mass), com, axes, entries, rounding, places)


def _places(table: Table) -> dict[str, FilePlace]:
    keys = {"joint": "joint", "origin": "d", "limit": "limits", **dict.fromkeys(_LIMITS, "limits")}
    keys |= {"damping": "damping", "friction": "friction"}
    return {part: _where(table, key) for part, key in keys.items() if key in table.values} | {
        "joint": _where(table, "joint")
    }


def _where(table: Table, key: str | None) -> FilePlace:
    element = " ".join(part for part in (table.name, key) if part)
    return FilePlace(table.file, table.line(key) or 0, 0, element)


def _place(inertial: Inertial | None, instead: FilePlace) -> FilePlace:
    return instead if inertial is None else inertial.place("inertial")


def _limits(table: Table, faults: _Faults) -> Limits:
    if "limits" not in table.values:
        return Limits()
    limits = table.table("limits", _LIMITS)
    given = {key: float(limits.number(key)) for key in limits.values}
    if not faults.strict:
        return Limits(**given)
    for key in ("velocity", "effort"):
        if given.get(key, 0.0) < 0.0:
            limits.fail(key, "is negative", "it bounds a magnitude: write it positive", given[key])
    if given.get("lower", -np.inf) > given.get("upper", np.inf):
        limits.fail(None, "lower exceeds upper", "swap them", given)
    return Limits(**given)


def _refuse_twins(rows: list[DHRow], file: str, text: str, faults: _Faults) -> None:
    for key in ("joint", "link"):
        names = [getattr(row, key) for row in rows]
        for i, name in enumerate(names):
            if name and name in names[:i]:
                twin = Table({}, file=file, text=text, name=f"joint {i + 1}", row=i)
                first = names.index(name) + 1
                problem = f"is the name of row {first} already"
                faults.of(
                    partial(twin.fail, key, problem, f"give each {key} its own name", name), None
                )
