"""A baseline: the findings that a project has today, so that only new ones fail.

A JSON file beside the models.  An entry is a fingerprint with the rule, subject and file that it
stands for; it holds no line and no number, so that moving a line leaves it valid.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from .._errors import UsageError
from .._finding import Finding
from .fingerprints import Fingerprint, fingerprints, path_from
from .verdict import PairVerdict, Verdict, VerdictSet

__all__ = ["Baseline", "BaselineEntry", "baseline_of", "read_baseline", "with_baseline"]

_SCHEMA = "ur5check.baseline/1"
_KEYS = ("file", "rule", "subject", "fingerprint")


@dataclass(frozen=True, order=True)
class BaselineEntry:
    """One finding.  file : that was judged, as seen from the baseline's folder"""

    file: str
    rule: str
    subject: str
    fingerprint: Fingerprint


@dataclass(frozen=True)
class Baseline:
    """Entries, and the folder from which their files are seen."""

    folder: Path
    entries: tuple[BaselineEntry, ...] = ()

    def text(self) -> str:
        """As a file, one entry a line, in an order that does not depend on the run."""
        lines = [
            json.dumps({key: getattr(entry, key) for key in _KEYS}, ensure_ascii=False)
            for entry in sorted(self.entries)
        ]
        body = "".join(f"\n    {line}," for line in lines).removesuffix(",")
        end = "\n  ]" if lines else "]"
        return f'{{\n  "schema": "{_SCHEMA}",\n  "findings": [{body}{end}\n}}\n'

    def gone(self, verdicts: VerdictSet) -> tuple[BaselineEntry, ...]:
        """Entries of files that were judged which no longer occur."""
        now = baseline_of(verdicts, self)
        return tuple(sorted(set(self.entries) - set(now.entries)))


def read_baseline(file: Path) -> Baseline:
    """Raises UsageError for a file that is not there, or is no baseline."""
    try:
        data: Any = json.loads(file.read_bytes())
    except OSError as error:
        raise UsageError(
            f"--baseline {file}: {error.strerror}; --update-baseline writes it"
        ) from None
    except ValueError as error:
        raise UsageError(f"--baseline {file}: is no JSON: {error}") from None
    entries = data.get("findings") if isinstance(data, dict) else None
    if not isinstance(entries, list) or data.get("schema") != _SCHEMA:
        raise UsageError(f"--baseline {file}: is no {_SCHEMA}; --update-baseline writes one")
    for entry in entries:
        texts = isinstance(entry, dict) and [entry.get(key) for key in _KEYS]
        if not texts or not all(isinstance(text, str) for text in texts):
            raise UsageError(f"--baseline {file}: an entry has {', '.join(_KEYS)}, not {entry!r}")
    made = (BaselineEntry(*(entry[key] for key in _KEYS)) for entry in entries)
    return Baseline(file.resolve().parent, tuple(made))


def baseline_of(verdicts: VerdictSet, before: Baseline) -> Baseline:
    """The baseline after a run: its open and known findings, and entries of files not judged."""
    made, judged = [], set()
    for verdict, file, found in _judged(verdicts):
        judged.add(path_from(before.folder, file))
        counting = {*verdict.findings.open, *verdict.findings.known}
        made += [entry for finding, entry in _entries(found, file, before) if finding in counting]
    kept = [entry for entry in before.entries if entry.file not in judged]
    return Baseline(before.folder, tuple(sorted({*made, *kept})))


def with_baseline(verdicts: VerdictSet, baseline: Baseline) -> VerdictSet:
    """The verdicts with the findings that the baseline holds as known: they count for nothing."""
    prints = {entry.fingerprint for entry in baseline.entries}
    sorted_again = []
    for verdict, file, found in _judged(verdicts):
        entries = dict(_entries(found, file, baseline))
        known = tuple(f for f in verdict.findings.open if entries[f].fingerprint in prints)
        left = tuple(f for f in verdict.findings.open if f not in known)
        sorted_again.append(replace(verdict.findings, open=left, known=known))
    models = len(verdicts.models)
    return replace(
        verdicts,
        against_baseline=True,
        models=tuple(
            replace(v, findings=s)
            for v, s in zip(verdicts.models, sorted_again[:models], strict=True)
        ),
        pairs=tuple(
            replace(pair, findings=s)
            for pair, s in zip(verdicts.pairs, sorted_again[models:], strict=True)
        ),
    )


def _judged(
    verdicts: VerdictSet,
) -> Iterator[tuple[Verdict | PairVerdict, str, tuple[Finding, ...]]]:
    """Each verdict with its file and all its findings, in the order in which they were found."""
    for verdict in verdicts.models:
        yield verdict, verdict.judgement.file, verdict.judgement.findings
    for pair in verdicts.pairs:
        yield pair, pair.file, pair.findings.all


def _entries(
    found: tuple[Finding, ...], file: str, baseline: Baseline
) -> Iterator[tuple[Finding, BaselineEntry]]:
    name = path_from(baseline.folder, file)
    for finding, print_ in zip(found, fingerprints(found, file, baseline.folder), strict=True):
        yield finding, BaselineEntry(name, finding.rule, finding.subject, print_)
