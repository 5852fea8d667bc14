"""What a project accepts: `ur5check.toml`, or `[tool.ur5check]` in `pyproject.toml`.

    fail-level = "error"                # or "warning", "note"
    ignore = ["GEO102"]                 # rules or families that are not asked
    select = ["INE", "JNT"]             # if given, only these are
    engines = ["mujoco", "drake"]       # whose imports are audited; ["all"]: all that are installed
    against = "vendor.urdf"             # compare each model's torques with this one's
    pytest = ["urdf/*.urdf.xacro"]      # files that `pytest` checks without being asked

    [per-file]
    "urdf/old_*.urdf" = ["JNT103"]      # more to ignore in files of these names

    [[files]]                           # how files of these names are read
    path = "urdf/arm.urdf.xacro"
    arguments = {prefix = "left_"}      # of a xacro
    arm = "left"                        # or base and tip
    expect-mass = 18.4                  # [kg]

    [[accepted]]                        # a known finding, with the reason why it stays
    rule = "INE109"
    subject = "link 'base_link'"
    file = "*.urdf"                     # optional
    reason = "the base stands; its tensor bears on no joint"
    until = 2027-06-30                  # optional: from then on it counts again

An accepted finding is shown, and counts for nothing.  One that no longer occurs is stale, and said
to be.
"""

from __future__ import annotations

import datetime
import hashlib
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path
from typing import Any, cast, get_args

from .._errors import UsageError
from .._finding import Finding, Severity

__all__ = [
    "Acceptance",
    "Configuration",
    "FileSettings",
    "Sorted",
    "find_configuration",
    "read_configuration",
]

_NAMES = ("ur5check.toml", "pyproject.toml")


@dataclass(frozen=True)
class Acceptance:
    """A finding that stays, and why.  file : a pattern;  until : its last day."""

    rule: str
    subject: str
    reason: str
    file: str = "*"
    until: datetime.date | None = None

    def covers(self, finding: Finding, file: str, today: datetime.date) -> bool:
        """Whether this is about that finding of that file, and still holds."""
        named = self.rule == finding.rule and self.subject in ("", finding.subject)
        return named and _matches(file, self.file) and (self.until is None or today <= self.until)


@dataclass(frozen=True)
class Sorted:
    """Findings of one file as a configuration sorts them.

    open : that count;  accepted : with their acceptances;  stale : acceptances that cover nothing
    known : that the baseline holds, and that count for nothing either
    """

    open: tuple[Finding, ...]
    accepted: tuple[tuple[Finding, Acceptance], ...]
    stale: tuple[Acceptance, ...]
    known: tuple[Finding, ...] = ()

    @property
    def all(self) -> tuple[Finding, ...]:
        """Those that count, the accepted and the known ones."""
        return (*self.open, *(finding for finding, _ in self.accepted), *self.known)


@dataclass(frozen=True)
class FileSettings:
    """How files are read.  path : a pattern;  the others as in `Request`"""

    path: str
    arguments: tuple[tuple[str, str], ...] = ()
    base: str | None = None
    tip: str | None = None
    arm: str | None = None
    expected_mass: float | None = None


@dataclass(frozen=True)
class Configuration:
    """See the top of this file.

    path : "" where there is none;  inputs : (path, SHA-256) of its file
    """

    path: str = ""
    inputs: tuple[tuple[str, str], ...] = ()
    fail_level: Severity = "error"
    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    engines: tuple[str, ...] = ()
    per_file: tuple[tuple[str, tuple[str, ...]], ...] = ()
    accepted: tuple[Acceptance, ...] = ()
    files: tuple[FileSettings, ...] = ()
    against: str | None = None

    def settings_of(self, file: str) -> FileSettings:
        """How a file is read: the last entry of `files` whose pattern fits."""
        fitting = [entry for entry in self.files if _matches(file, entry.path)]
        return fitting[-1] if fitting else FileSettings(file)

    def asks(self, rule: str, file: str) -> bool:
        """Whether a rule is asked of a file: selected, and not ignored."""
        ignored = [*self.ignore]
        for pattern, rules in self.per_file:
            if _matches(file, pattern):
                ignored += rules
        chosen = not self.select or rule.startswith(self.select)
        return chosen and not rule.startswith(tuple(ignored))

    def sort(
        self,
        findings: Sequence[Finding],
        file: str,
        *,
        pair: bool = False,
        engines: bool = False,
        today: datetime.date | None = None,
    ) -> Sorted:
        """Which findings count, which are accepted, and which acceptances are stale.

        file : that they are about;  pair : whether they are about two models (family CMP)
        engines : whether engines were asked (family ENG)
        """
        day = today or datetime.date.today()
        kept, accepted = [], []
        used: set[Acceptance] = set()
        for finding in findings:
            if not self.asks(finding.rule, file):
                continue
            covering = [a for a in self.accepted if a.covers(finding, file, day)]
            used.update(covering)
            if covering:
                accepted.append((finding, covering[0]))
            else:
                kept.append(finding)
        stale = [
            a
            for a in self.accepted
            if a not in used
            and _matches(file, a.file)
            and a.rule.startswith("CMP") == pair
            and (engines or not a.rule.startswith("ENG"))
            and (not pair or a.subject in ("", file))  # a call may compare other pairs
        ]
        return Sorted(tuple(kept), tuple(accepted), tuple(stale))


def find_configuration(start: Path) -> Configuration:
    """The nearest configuration at or above a folder; an empty one where there is none.

    Raises UsageError for one that is not as described above.
    """
    for folder in (start.resolve(), *start.resolve().parents):
        for name in _NAMES:
            file = folder / name
            if file.is_file() and (
                name != "pyproject.toml" or b"[tool.ur5check" in file.read_bytes()
            ):
                return read_configuration(file)
    return Configuration()


def read_configuration(file: Path, label: str | None = None) -> Configuration:
    """A configuration from a file.  Raises UsageError for one that is not as described above.

    label : what reports call the file (default: its path)
    """
    try:
        data = file.read_bytes()
        table: dict[str, Any] = tomllib.loads(data.decode("utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise UsageError(f"{file}: {error}") from None
    if file.name == "pyproject.toml":
        table = table.get("tool", {}).get("ur5check", {})
    known = {
        "fail-level", "select", "ignore", "engines", "per-file", "accepted", "files", "against",
        "pytest",
    }  # fmt: skip
    for key in table.keys() - known:
        raise UsageError(f"{file}: {key!r} is no setting; use {', '.join(sorted(known))}")
    level = table.get("fail-level", "error")
    if level not in get_args(Severity):
        raise UsageError(f"{file}: fail-level is {level!r}; use error, warning or note")
    per_file = table.get("per-file", {})
    if not isinstance(per_file, Mapping):
        raise UsageError(f"{file}: per-file takes patterns and lists of rules")
    return Configuration(
        label or str(file),
        ((label or str(file), hashlib.sha256(data).hexdigest()),),
        cast("Severity", level),
        _words(file, "select", table.get("select", [])),
        _words(file, "ignore", table.get("ignore", [])),
        _engines(file, table.get("engines", [])),
        tuple(
            (name, _words(file, f"per-file {name!r}", rules)) for name, rules in per_file.items()
        ),
        tuple(_acceptance(file, entry) for entry in table.get("accepted", [])),
        tuple(_file_settings(file, entry) for entry in table.get("files", [])),
        _against(file, table),
    )


def _against(file: Path, table: Mapping[str, Any]) -> str | None:
    """A path is seen from the configuration's folder."""
    against = table.get("against")
    if against is not None and not isinstance(against, str):
        raise UsageError(f"{file}: against takes a model")
    patterns = table.get("pytest", [])
    if not isinstance(patterns, list) or not all(isinstance(text, str) for text in patterns):
        raise UsageError(f"{file}: pytest takes a list of patterns of files")
    if against is None or not (file.parent / against).is_file():
        return against
    return str(file.parent / against)


def _file_settings(file: Path, entry: object) -> FileSettings:
    texts = ("path", "base", "tip", "arm")
    known = (*texts, "arguments", "expect-mass")
    given = dict(entry) if isinstance(entry, Mapping) else {}
    arguments, mass = given.get("arguments", {}), given.get("expect-mass")
    right = (
        "path" in given
        and not given.keys() - set(known)
        and all(isinstance(given.get(key, ""), str) for key in texts)
        and isinstance(arguments, Mapping)
        and all(isinstance(value, str | int | float) for value in arguments.values())
        and (mass is None or (isinstance(mass, int | float) and mass > 0))
    )
    if not right:
        raise UsageError(f"{file}: an entry of files takes {', '.join(known)}, not {entry!r:.80}")
    return FileSettings(
        given["path"],
        tuple((name, _xacro_text(value)) for name, value in arguments.items()),
        given.get("base"),
        given.get("tip"),
        given.get("arm"),
        mass,
    )


def _xacro_text(value: str | int | float) -> str:
    """A TOML value as xacro reads it: true and false, not Python's True and False."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def _words(file: Path, key: str, value: object) -> tuple[str, ...]:
    from .._rules.registry import all_rules

    if not isinstance(value, list) or not all(isinstance(word, str) for word in value):
        raise UsageError(f"{file}: {key} takes a list of rules or families")
    for word in value:
        if not any(rule.startswith(word) for rule in all_rules()):
            raise UsageError(f"{file}: {key} names {word!r}, which is no rule (ur5check rules)")
    return tuple(value)


def _engines(file: Path, value: object) -> tuple[str, ...]:
    from .._engines.registry import REGISTRY
    from .engine_judgement import ALL_ENGINES

    known = (ALL_ENGINES, *REGISTRY)
    if not isinstance(value, list) or not all(name in known for name in value):
        raise UsageError(f"{file}: engines takes a list of {', '.join(known)}")
    return tuple(value)


def _acceptance(file: Path, entry: object) -> Acceptance:
    if not isinstance(entry, Mapping):
        raise UsageError(f"{file}: an entry of accepted takes rule, subject and reason")
    unknown = entry.keys() - {"rule", "subject", "reason", "file", "until"}
    texts = {
        key: entry.get(key, "*" if key == "file" else "")
        for key in ("rule", "subject", "reason", "file")
    }
    until = entry.get("until")
    if unknown or not all(isinstance(text, str) for text in texts.values()) or not texts["rule"]:
        raise UsageError(
            f"{file}: an entry of accepted takes rule, subject, reason, file and until"
        )
    if not texts["reason"].strip():
        raise UsageError(f"{file}: {texts['rule']} is accepted without a reason; give one")
    if until is not None and type(until) is not datetime.date:
        raise UsageError(f"{file}: until = {until} is no date; write 2027-06-30")
    _words(file, "accepted", [texts["rule"]])
    return Acceptance(until=until, **texts)


def _matches(file: str, pattern: str) -> bool:
    return (
        fnmatch(file, pattern) or fnmatch(Path(file).name, pattern) or fnmatch(file, f"*/{pattern}")
    )
