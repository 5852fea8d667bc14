"""Findings of family ENG: what is wrong between a model's file and the engines that read it."""

from __future__ import annotations

from collections.abc import Iterable

from ..._finding import Finding, Place, worst_first
from ..._robot.serial_arm import SerialArm
from ..._rules.engine_rules import RULES
from ..engine_urdf import parsed
from .engine_reading import Reading
from .import_difference import ImportDifference

__all__ = ["engine_findings"]

_RULES = {rule.name: rule for rule in RULES}


def engine_findings(arm: SerialArm, readings: Iterable[Reading]) -> tuple[Finding, ...]:
    """One finding for every import difference that is wrong, refusal, and unexplained torque.

    Other representations of the same arm (merged links, two coordinates) are no findings.
    """
    places = _places(arm)
    found: list[Finding] = []
    for reading in readings:
        found += _of_engine(reading, places)
        if reading.imported is not None:
            found += [
                _of_difference(one, reading.title, places)
                for one in reading.imported.differences
                if one.bears_on != "nothing"
            ]
    return tuple(worst_first(found))


def _of_engine(reading: Reading, places: dict[str, Place]) -> list[Finding]:
    if reading.refused is not None:
        name, effect, message = "model-refused", None, reading.refused
    elif reading.explanation is not None and not reading.explanation.explained:
        name, effect = "torque-unexplained", reading.explanation.gap
        message = f"{effect:.4g} N m away from the torques of the imported arm"
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


def _of_difference(one: ImportDifference, title: str, places: dict[str, Place]) -> Finding:
    rule, issue = _RULES[one.kind], one.known_issue
    numeric = one.value is not None or one.bound is not None
    return Finding(
        rule.id,
        rule.severity,
        one.where or "the whole arm",
        f"{title} imports {one.imported}, the file has {one.written}",
        (places.get(one.where, places[""]),),
        value=one.value if numeric else one.imported,
        bound=one.bound if numeric else one.written,
        unit=one.unit,
        consequence=rule.consequence if issue is None else issue.explanation,
        fix=rule.fix if issue is None else issue.fix,
        effect=one.torque_effect,
    )


def _places(arm: SerialArm) -> dict[str, Place]:
    """Place of every link and joint in the file by its name; the file itself under ""."""
    file = arm.source.inputs[0][0] if arm.source.inputs else ""
    places = {"": Place(file)}
    if arm.source.urdf is not None:
        written = arm.source.kind == "urdf"  # the text of an expanded xacro has other lines
        for node in parsed(arm).iterchildren("link", "joint"):
            name = f"{node.tag} {node.get('name')!r}"
            places[name] = Place(file, node.sourceline if written else 0, 0, name)
    return places
