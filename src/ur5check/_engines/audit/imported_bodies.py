"""The inertias that an engine imported against those of the file: which link, and what of it.

Engines keep links apart or merge those that are fixed to each other.  A *part* is the smallest
unit of comparison: bodies of the engine, and the links of the file that they stand for.  Where a
part's ten parameters differ, known misreadings of its links are tried, alone, all of one kind, and
in pairs; the fewest that account for the difference to rounding name it.  A difference that no
known misreading accounts for is split into mass, centre of mass and tensor.  Δπ is attributed
without residual.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from ..._comparison.shapley import shares
from ..._robot.inertia import Inertia
from ..._robot.robot_tree import ArmOrTree, tree_links
from ..._robot.transforms import Array
from ..imported_model import ImportedModel, frames_at_zero
from .audit_tolerances import parameter_rounding
from .import_difference import ImportDifference, Kind
from .written_bodies import Misreading, WrittenBody, written_arm

__all__ = ["body_differences"]

_Choice = tuple[tuple[WrittenBody, Misreading], ...]


@dataclass(frozen=True, eq=False)
class _Part:
    """Links of the file (the first names the part) and the engine's parameters for them."""

    written: tuple[WrittenBody, ...]
    imported: Array  # (10,) in frame i


def body_differences(imported_model: ImportedModel, arm: ArmOrTree) -> list[ImportDifference]:
    """Every difference of a moving body, joint by joint from the base."""
    found: list[ImportDifference] = []
    merged: list[str] = []
    written = written_arm(arm).bodies
    for i, bodies in enumerate(_bodies_by_joint(imported_model, arm)):
        group = [body for body in written if body.carried_by == i]
        for part in _parts(group, bodies):
            tolerance = parameter_rounding(arm, part.imported, _total(part.written))
            found += _differences(part, len(tree_links(arm)), i, tolerance)
            heavy = [body.name for body in part.written if body.parameters[0] > 0.0]
            merged += heavy[1:]
    if merged:
        names = ", ".join(map(repr, merged))
        found.append(ImportDifference("body-merged", "", names, "one body a joint"))
    return found


def _bodies_by_joint(imported_model: ImportedModel, arm: ArmOrTree) -> list[dict[str, Array]]:
    """Per joint, the engine's bodies by name, in frame i, without the massless ones."""
    frames = frames_at_zero(arm)
    groups: list[dict[str, Array]] = [{} for _ in frames]
    for body in imported_model.bodies:
        i = body.carried_by
        if i is not None and (body.inertia.mass or body.inertia.tensor.any()):
            parameters = body.inertia.expressed_in(frames[i].inverse()).parameters()
            groups[i][body.name] = groups[i].get(body.name, 0.0) + parameters
    return groups


def _parts(group: Sequence[WrittenBody], bodies: dict[str, Array]) -> list[_Part]:
    """A part per link that the engine has by name; all others belong to the nearest above."""
    named = [body.name for body in group if body.name in bodies]
    if not named:
        return [_Part(tuple(group), _sum(list(bodies.values())))]
    links: dict[str, list[WrittenBody]] = {name: [] for name in named}
    for body in group:
        ways = (body.name, *body.above)
        links[next((name for name in ways if name in links), named[0])].append(body)
    nameless = _sum([value for name, value in bodies.items() if name not in links])
    return [
        _Part(
            tuple(sorted(links[name], key=lambda body: body.name != name)),
            bodies[name] + (nameless if name == named[0] else 0.0),
        )
        for name in named
    ]


def _differences(part: _Part, n: int, i: int, tolerance: Array) -> list[ImportDifference]:
    delta = part.imported - _total(part.written)
    if (np.abs(delta) <= tolerance).all():
        return []
    for choice in _choices(part.written):
        if (np.abs(delta - _effect(choice)) <= tolerance).all():
            return [
                _named(
                    misread.kind, body, misread.imported, n, i, misread.parameters - body.parameters
                )
                for body, misread in choice
            ]
    shapes = [body for body in part.written if body.has_shape and not body.has_inertial]
    if shapes and delta[0] > tolerance[0]:
        imported = f"{delta[0]:.4g} kg, from its shape"
        return [_named("shape-mass", shapes[0], imported, n, i, delta)]
    return _number_by_number(part, n, i, tolerance)


def _choices(bodies: Sequence[WrittenBody]) -> Iterator[_Choice]:
    """The misreadings that may have happened, the simplest first."""
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
    kind: Kind, body: WrittenBody, imported: str, n: int, i: int, delta: Array
) -> ImportDifference:
    written = f"{body.parameters[0]:.4g} kg" if body.has_inertial else "no <inertial>"
    if kind == "rotation-dropped":
        written = "its tensor along axes rotated by rpy"
    difference = ImportDifference(
        kind, f"link {body.name!r}", written, imported, i, _at_link(delta, n, i)
    )
    if kind == "rotation-dropped":
        return difference
    mass = float(body.parameters[0])
    return replace(difference, value=mass + float(delta[0]), bound=mass, unit="kg")


def _number_by_number(part: _Part, n: int, i: int, tolerance: Array) -> list[ImportDifference]:
    """Mass, centre of mass and tensor, each with its share of Δπ (`_comparison.shapley`)."""
    where = f"link {part.written[0].name!r}"
    if part.imported[0] <= 0.0 or _total(part.written)[0] <= 0.0:
        delta = part.imported - _total(part.written)
        if abs(delta[0]) <= tolerance[0]:  # a negative mass has no centre: its first moment
            before, after = part.imported[1:4] - delta[1:4], part.imported[1:4]
            words = (f"first moment {_list(before)} kg m", f"first moment {_list(after)} kg m")
            return [ImportDifference("com-moved", where, *words, i, _at_link(delta, n, i))]
        return [_named("mass-changed", part.written[0], f"{part.imported[0]:.4g} kg", n, i, delta)]
    imported, written = map(Inertia.from_parameters, (part.imported, _total(part.written)))

    def parameters(choice: tuple[bool, ...]) -> Array:
        m, c, I_c = (imported if engine else written for engine in choice)
        return Inertia(m.mass, c.com, I_c.tensor).parameters()

    texts: list[tuple[Kind, str, str]] = [
        ("mass-changed", f"{written.mass:.6g} kg", f"{imported.mass:.6g} kg"),
        ("com-moved", f"{_list(written.com)} m", f"{_list(imported.com)} m"),
        ("tensor-changed", f"{_moments(written)} kg m²", f"{_moments(imported)} kg m²"),
    ]
    found = [
        ImportDifference(kind, where, before, after, i, _at_link(delta, n, i))
        for (kind, before, after), delta in zip(texts, shares(parameters, 3), strict=True)
        if (np.abs(delta) > tolerance).any()
    ]
    return [
        replace(one, value=imported.mass, bound=written.mass, unit="kg")
        if one.kind == "mass-changed"
        else one
        for one in found
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
