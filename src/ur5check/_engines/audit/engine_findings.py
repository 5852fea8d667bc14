"""Findings of family ENG: what is wrong between a model's file and the engines that read it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ..._finding import Finding, Place, worst_first
from ..._robot.robot_tree import ArmOrTree
from ..._rules.engine_rules import RULES
from ..._rules.finding_log import finding_of
from ..engine_urdf import parsed
from .engine_reading import Reading
from .import_audit import ImportAudit
from .import_difference import ImportDifference

__all__ = ["engine_findings"]

_RULES = {rule.name: rule for rule in RULES}


def engine_findings(arm: ArmOrTree, readings: Iterable[Reading]) -> tuple[Finding, ...]:
    """One finding for every import difference that is wrong, refusal, and unexplained torque.

    Other representations of the same arm (merged links, two coordinates) are no findings.  What
    affects use only, such as a kind of limit, is one finding for all joints that lose it.
    """
    places = _places(arm)
    found: list[Finding] = []
    for reading in readings:
        found += _of_engine(reading, places)
        if reading.imported is not None:
            found += [_of_alike(alike, reading, places) for alike in _groups(reading.imported)]
    return tuple(worst_first(found))


def _of_engine(reading: Reading, places: dict[str, Place]) -> list[Finding]:
    if reading.refused is not None:
        name, effect = "model-refused", None
        message = f"{reading.refused} ({reading.title} {reading.version})"
    elif reading.explanation is not None and not reading.explanation.explained:
        name, effect = "torque-unexplained", reading.explanation.gap
        message = f"{effect:.4g} N m away from the torques of the imported model"
    else:
        return []
    rule = _RULES[name]
    return [
        Finding(
            rule.id, rule.severity, f"engine {reading.title!r}", message, (places[""],),
            value=effect, unit="" if effect is None else "N m",
            consequence=rule.consequence, fix=rule.fix, effect=effect,
        )
    ]  # fmt: skip


def _groups(imported: ImportAudit) -> list[list[ImportDifference]]:
    """Differences that affect torques one by one, those of use by their kind."""
    groups: dict[object, list[ImportDifference]] = {}
    for one in imported.differences:
        if one.bears_on != "nothing":
            groups.setdefault(one.kind if one.bears_on == "use" else one, []).append(one)
    return list(groups.values())


def _of_alike(
    alike: Sequence[ImportDifference], reading: Reading, places: dict[str, Place]
) -> Finding:
    one = alike[0]
    rule, issue = _RULES[one.kind], one.known_issue
    numeric = one.value is not None or one.bound is not None
    what = one.kind.replace("-", " ")
    at = f" at {one.where}" if len(alike) > 1 else ""
    found = finding_of(
        rule.id,
        f"{len(alike)} joints" if len(alike) > 1 else one.where or "the whole model",
        f"{what}: {reading.title} {reading.version} imports {one.imported}, the file has "
        f"{one.written}{at}",
        *(places.get(each.where, places[""]) for each in alike),
        value=one.value if numeric else one.imported,
        bound=one.bound if numeric else one.written,
        unit=one.unit,
        fix="" if issue is None else issue.fix,
        effect=one.torque_effect,
    )
    return found if issue is None else replace(found, consequence=issue.explanation)


def _places(arm: ArmOrTree) -> dict[str, Place]:
    """Place of every link and joint in the file by its name; the file itself under ""."""
    file = arm.source.inputs[0][0] if arm.source.inputs else ""
    places = {"": Place(file)}
    if arm.source.urdf is not None:
        written = arm.source.kind == "urdf"  # the text of an expanded xacro has other lines
        for node in parsed(arm).iterchildren("link", "joint"):
            name = f"{node.tag} {node.get('name')!r}"
            places[name] = Place(file, node.sourceline if written else 0, 0, name)
    return places
