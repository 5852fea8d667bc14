"""A finding: one thing that is wrong with a model, where it is written, and what to do about it.

The one type for "something is wrong", from every source: a reader, a rule about bodies or joints,
the audit of what an engine imported, the comparison of two models, a recording.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

__all__ = ["SEVERITIES", "Finding", "Place", "Severity", "worst_first"]

#: error: this cannot be a real robot, or an engine refuses or alters it;  warning: probably a
#: mistake;  note: worth knowing.
Severity = Literal["error", "warning", "note"]

#: The worst first.
SEVERITIES: tuple[Severity, ...] = ("error", "warning", "note")


@dataclass(frozen=True, order=True)
class Place:
    """Where a number or an element is written.

    Attributes
    ----------
    file : str
        As the user gave it, or as an include names it.
    line, column : int
        From 1; 0 where unknown.
    element : str
        The element, key or body, "link 'forearm' inertial/mass".
    via : tuple of Place
        Of text that xacro expanded: the macro calls that brought it there, the innermost first,
        and its place in the expanded text.

    Examples
    --------
    >>> from ur5check import Place
    >>> str(Place("arm.urdf", 12, 5))
    'arm.urdf:12:5'
    """

    file: str = ""
    line: int = 0
    column: int = 0
    element: str = ""
    via: tuple[Place, ...] = ()

    def __str__(self) -> str:
        parts = [str(part) for part in (self.file, self.line, self.column) if part]
        return ":".join(parts)


@dataclass(frozen=True, eq=False)
class Finding:
    """One thing that is wrong.

    Attributes
    ----------
    rule : str
        Id of the rule that was broken, "INE102".
    severity : {"error", "warning", "note"}
        As the rule has it, or lower where the rule says so.
    subject : str
        What it is about: "link 'forearm'", "joint 'elbow'", "robot 'ur5'".
    message : str
        What is wrong, as a clause, with its numbers.
    places : tuple of Place
        Where it is written, the number at fault first; each followed by its `via`.
    value, bound : float, str or None
        What was found and what it was compared with, in `unit`; None where there is no number.
    unit : str
    consequence : str
        What it does to a user of the model.
    fix : str
        What to do about it, as an imperative.
    effect : float or None
        The joint torque that it accounts for [N m], None where it is unknown.

    Examples
    --------
    >>> from ur5check import Finding, Place
    >>> place = Place("arm.urdf", 12, 5)
    >>> str(Finding("INE101", "error", "link 'hand'", "its mass is negative", (place,)))
    "arm.urdf:12:5: error INE101: link 'hand': its mass is negative"
    """

    rule: str
    severity: Severity
    subject: str
    message: str
    places: tuple[Place, ...] = ()
    value: float | str | None = None
    bound: float | str | None = None
    unit: str = ""
    consequence: str = ""
    fix: str = ""
    effect: float | None = None

    @property
    def place(self) -> Place:
        """The first place, or an empty one."""
        return self.places[0] if self.places else Place()

    def __str__(self) -> str:
        where = f"{self.place}: " if str(self.place) else ""
        fix = f"; {self.fix}" if self.fix else ""
        return f"{where}{self.severity} {self.rule}: {self.subject}: {self.message}{fix}"


def worst_first(findings: tuple[Finding, ...] | list[Finding]) -> list[Finding]:
    """Errors, then warnings, then notes; what is about the whole robot after what is about a part.

    Within these by place: what stands first in the file is mostly the cause of what stands later.
    """
    return sorted(
        findings,
        key=lambda f: (SEVERITIES.index(f.severity), f.rule.startswith("ROB"), f.place, f.rule),
    )
