"""Findings as SARIF 2.1.0 (OASIS), which code hosts show beside the lines.

One run, one result a finding: open ones, accepted ones as suppressed with their reason, those of
the baseline as unchanged.  A law that fails is no finding of a model but a notification of the run.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import Path, PurePath
from typing import Any
from urllib.parse import quote

from .._finding import Finding, Place
from .._rules.registry import rule_of
from .._rules.rule import FAMILIES, Rule
from .._validation.fingerprints import fingerprints
from .._validation.verdict import VerdictSet
from .._version import __version__
from .file_places import first_place, other_places
from .verdict_summary import failed_laws

__all__ = ["render_sarif"]

_SCHEMA = (
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
)

Json = dict[str, Any]


def render_sarif(verdicts: VerdictSet, *, command: str = "") -> str:
    """The findings of one call of `validate` as a SARIF log."""
    results = list(_results(verdicts))
    ids = sorted({result["ruleId"] for result in results})
    for result in results:
        result["ruleIndex"] = ids.index(result["ruleId"])
    driver = {
        "name": "ur5check",
        "version": __version__,
        "semanticVersion": __version__,
        "rules": [_descriptor(rule_of(rule)) for rule in ids],
    }
    run = {
        "tool": {"driver": driver},
        "invocations": [_invocation(verdicts, command)],
        "columnKind": "unicodeCodePoints",
        "results": results,
    }
    log = {"$schema": _SCHEMA, "version": "2.1.0", "runs": [run]}
    return json.dumps(log, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _descriptor(rule: Rule) -> Json:
    parts = {"Why": rule.why, "Effect": rule.consequence, "Fix": rule.fix, "Report": rule.report}
    said = {title: text for title, text in parts.items() if text}
    examples = {"Refused": rule.bad.strip(), "Accepted": rule.good.strip()}
    markdown = [f"**{title}.** {text}" for title, text in said.items()]
    markdown += [f"{title}:\n\n```\n{text}\n```" for title, text in examples.items()]
    return {
        "id": rule.id,
        "name": rule.name,
        "shortDescription": {"text": rule.name.replace("-", " ")},
        "fullDescription": {"text": rule.checks},
        "help": {
            "text": "\n".join(f"{title}: {text}" for title, text in said.items()),
            "markdown": "\n\n".join(markdown),
        },
        "defaultConfiguration": {"level": rule.severity},
        "properties": {"tags": [rule.family, FAMILIES[rule.family]]},
    }


def _invocation(verdicts: VerdictSet, command: str) -> Json:
    notes = [
        {
            "level": "error",
            "message": {"text": text},
            "locations": [{"physicalLocation": _physical(Place(file))}],
        }
        for file, text in failed_laws(verdicts)
    ]
    invocation: Json = {"executionSuccessful": not notes}
    if command:
        invocation["commandLine"] = command
    if notes:
        invocation["toolExecutionNotifications"] = notes
    return invocation


def _results(verdicts: VerdictSet) -> Iterator[Json]:
    judged = [
        *((v.judgement.file, v.judgement.findings, v.findings) for v in verdicts.models),
        *((pair.file, pair.findings.all, pair.findings) for pair in verdicts.pairs),
    ]
    for file, found, by_kind in judged:
        reasons = {finding: acceptance.reason for finding, acceptance in by_kind.accepted}
        asked = set(by_kind.all)
        for finding, print_ in zip(found, fingerprints(found, file), strict=True):
            if finding not in asked:
                continue
            result = _result(finding, file, print_)
            if finding in reasons:
                suppression = {"kind": "external", "justification": reasons[finding]}
                result["suppressions"] = [suppression]
            if verdicts.against_baseline:
                result["baselineState"] = "unchanged" if finding in by_kind.known else "new"
            yield result


def _result(f: Finding, file: str, fingerprint: str) -> Json:
    place = first_place(f, file)
    location: Json = {"physicalLocation": _physical(place)}
    logical = [name for name in dict.fromkeys((f.subject, place.element)) if name]
    if logical:
        location["logicalLocations"] = [{"fullyQualifiedName": name} for name in logical]
    fix = f"; {f.fix}" if f.fix else ""
    result: Json = {
        "ruleId": f.rule,
        "level": f.severity,
        "message": {"text": f"{f.subject}: {f.message}{fix}"},
        "locations": [location],
        # GitHub knows an alert again by the second; the first is for every other reader.
        "partialFingerprints": {
            "ur5check/v1": fingerprint,
            "primaryLocationLineHash": fingerprint,
        },
    }
    others = other_places(f, file)
    if others:
        result["relatedLocations"] = [
            {"physicalLocation": _physical(p), "message": {"text": p.element or f.subject}}
            for p in others
        ]
    numbers = {"value": f.value, "bound": f.bound, "unit": f.unit, "effect [N m]": f.effect}
    result["properties"] = {key: _plain(x) for key, x in numbers.items() if x not in (None, "")}
    return result


def _plain(value: float | str | None) -> float | str | None:
    """JSON has no nan and no infinity."""
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


def _physical(place: Place) -> Json:
    absolute = PurePath(place.file).is_absolute()
    uri = Path(place.file).as_uri() if absolute else quote(place.file, safe="/:@$()+,")
    physical: Json = {"artifactLocation": {"uri": uri}}
    if place.line:
        physical["region"] = {"startLine": place.line}
        if place.column:
            physical["region"]["startColumn"] = place.column
    return physical
