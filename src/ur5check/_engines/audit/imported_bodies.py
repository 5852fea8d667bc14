"""The inertias that an engine holds, against those that the file writes: which link, what of it.

Engines keep links apart or merge those that are fixed to each other.  A *part* is the least that
can be held side by side: bodies of the engine, and the links of the file that they stand for.
Where a part's ten parameters differ, known misreadings of its links are tried, alone, all of one
kind, and in pairs; the fewest that account for the difference to rounding are its names.  What no
known misreading accounts for is told as mass, centre and tensor.  Δπ is shared out whole.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from ..._comparison.shapley import shares
from ..._dynamics.kinematics import link_frames
from ..._robot.inertia import Inertia
from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array, Transform
from ..imported_model import ImportedModel
from .audit_tolerances import parameter_rounding
from .import_difference import ImportDifference, Kind
from .written_bodies import Misreading, WrittenBody, written_arm

__all__ = ["body_differences"]

_Choice = tuple[tuple[WrittenBody, Misreading], ...]


@dataclass(frozen=True, eq=False)
class _Part:
    """Links of the file (the first gives the part its name) and what the engine has for them."""

    written: tuple[WrittenBody, ...]
    held: Array  # (10,) in frame i


def body_differences(imported_model: ImportedModel, arm: SerialArm) -> list[ImportDifference]:
    """Every difference of a moving body, joint by joint from the base."""
    found: list[ImportDifference] = []
    merged: list[str] = []
    written = written_arm(arm).bodies
    for i, held in enumerate(_held_by_joint(imported_model, arm)):
        group = [body for body in written if body.carried_by == i]
        for part in _parts(group, held):
            tolerance = parameter_rounding(arm, part.held, _total(part.written))
            found += _differences(part, arm.n, i, tolerance)
            heavy = [body.name for body in part.written if body.parameters[0] > 0.0]
            merged += heavy[1:]
    if merged:
        names = ", ".join(map(repr, merged))
        found.append(ImportDifference("body-merged", "", names, "one body a joint"))
    return found


def _held_by_joint(imported_model: ImportedModel, arm: SerialArm) -> list[dict[str, Array]]:
    """Per joint, the engine's bodies by name, in frame i.  What has no mass is no body."""
    frames = link_frames(arm, np.zeros(arm.n))
    groups: list[dict[str, Array]] = [{} for _ in range(arm.n)]
    for body in imported_model.bodies:
        i = body.carried_by
        if i is not None and (body.inertia.mass or body.inertia.tensor.any()):
            to_frame_i = Transform.from_matrix(frames[i]).inverse()
            parameters = body.inertia.expressed_in(to_frame_i).parameters()
            groups[i][body.name] = groups[i].get(body.name, 0.0) + parameters
    return groups


def _parts(group: Sequence[WrittenBody], held: dict[str, Array]) -> list[_Part]:
    """A part for every link that the engine has by name; all others count to the nearest above."""
    named = [body.name for body in group if body.name in held]
    if not named:
        return [_Part(tuple(group), _sum(list(held.values())))]
    links: dict[str, list[WrittenBody]] = {name: [] for name in named}
    for body in group:
        ways = (body.name, *body.above)
        links[next((name for name in ways if name in links), named[0])].append(body)
    nameless = _sum([value for name, value in held.items() if name not in links])
    return [
        _Part(
            tuple(sorted(links[name], key=lambda body: body.name != name)),
            held[name] + (nameless if name == named[0] else 0.0),
        )
        for name in named
    ]


def _differences(part: _Part, n: int, i: int, tolerance: Array) -> list[ImportDifference]:
    delta = part.held - _total(part.written)
    if (np.abs(delta) <= tolerance).all():
        return []
    for choice in _choices(part.written):
        if (np.abs(delta - _effect(choice)) <= tolerance).all():
            return [
                _named(misread.kind, body, misread.held, n, i, misread.parameters - body.parameters)
                for body, misread in choice
            ]
    shapes = [body for body in part.written if body.has_shape and not body.has_inertial]
    if shapes and delta[0] > tolerance[0]:
        held = f"{delta[0]:.4g} kg, from its shape"
        return [_named("shape-mass", shapes[0], held, n, i, delta)]
    return _number_by_number(part, n, i, tolerance)


def _choices(bodies: Sequence[WrittenBody]) -> Iterator[_Choice]:
    """What may have happened, the simplest first."""
    single = [(body, misread) for body in bodies for misread in body.misreadings]
    for one in single:
        yield (one,)
    kinds = dict.fromkeys(misread.kind for _, misread in single)
    for count in range(1, len(kinds) + 1):
        for chosen in combinations(kinds, count):
            yield tuple(one for one in single if one[1].kind in chosen)
    for two in combinations(single, 2):
        if two[0][0] is not two[1][0]:
            yield two


def _effect(choice: _Choice) -> Array:
    return _sum([misread.parameters - body.parameters for body, misread in choice])


def _named(
    kind: Kind, body: WrittenBody, held: str, n: int, i: int, delta: Array
) -> ImportDifference:
    written = f"{body.parameters[0]:.4g} kg" if body.has_inertial else "no <inertial>"
    if kind == "rotation-dropped":
        written = "its tensor along axes turned by rpy"
    return ImportDifference(kind, f"link {body.name!r}", written, held, i, _at_link(delta, n, i))


def _number_by_number(part: _Part, n: int, i: int, tolerance: Array) -> list[ImportDifference]:
    """Mass, centre of mass and tensor, each with its share of Δπ (`_comparison.shapley`)."""
    if part.held[0] <= 0.0 or _total(part.written)[0] <= 0.0:
        delta = part.held - _total(part.written)
        return [_named("mass-changed", part.written[0], f"{part.held[0]:.4g} kg", n, i, delta)]
    held, written = map(Inertia.from_parameters, (part.held, _total(part.written)))

    def parameters(choice: tuple[bool, ...]) -> Array:
        m, c, I_c = (held if engine else written for engine in choice)
        return Inertia(m.mass, c.com, I_c.tensor).parameters()

    said: list[tuple[Kind, str, str]] = [
        ("mass-changed", f"{written.mass:.6g} kg", f"{held.mass:.6g} kg"),
        ("com-moved", f"{_list(written.com)} m", f"{_list(held.com)} m"),
        ("tensor-changed", f"{_moments(written)} kg m²", f"{_moments(held)} kg m²"),
    ]
    where = f"link {part.written[0].name!r}"
    return [
        ImportDifference(kind, where, before, after, i, _at_link(delta, n, i))
        for (kind, before, after), delta in zip(said, shares(parameters, 3), strict=True)
        if (np.abs(delta) > tolerance).any()
    ]


def _total(bodies: Sequence[WrittenBody]) -> Array:
    return _sum([body.parameters for body in bodies])


def _sum(parameters: Sequence[Array]) -> Array:
    return np.sum(parameters, axis=0) if parameters else np.zeros(10)


def _at_link(delta: Array, n: int, i: int) -> Array:
    parameters = np.zeros(10 * n)
    parameters[10 * i : 10 * i + 10] = delta
    return parameters


def _list(vector: Array) -> str:
    return f"({', '.join(f'{value + 0.0:.4g}' for value in np.round(vector, 12))})"


def _moments(inertia: Inertia) -> str:
    return "moments " + _list(inertia.principal_moments())
