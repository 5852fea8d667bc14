"""What a commit changes beside the torques: the robot's mass, and its findings."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from .._finding import Finding
from .fingerprints import fingerprints
from .judgement import Judgement

__all__ = ["RevisionChange", "revision_change"]


@dataclass(frozen=True)
class RevisionChange:
    """The earlier and the later state of one file.

    revision : of the earlier one;  masses : of the whole robot [kg], None where there is none
    new, gone : findings of the later, of the earlier state only
    """

    revision: str
    masses: tuple[float | None, float | None]
    new: tuple[Finding, ...]
    gone: tuple[Finding, ...]


def revision_change(
    revision: str, before: tuple[Judgement, Path], after: tuple[Judgement, Path]
) -> RevisionChange:
    """Compare by fingerprints.  before, after : a judgement, and the top folder of its files"""
    prints = [fingerprints(j.findings, j.file, folder) for j, folder in (before, after)]
    (earlier, _), (later, _) = before, after
    masses = [None if j.robot is None else j.robot.mass for j in (earlier, later)]
    return RevisionChange(
        revision,
        (masses[0], masses[1]),
        tuple(f for f, p in zip(later.findings, prints[1], strict=True) if p not in prints[0]),
        tuple(f for f, p in zip(earlier.findings, prints[0], strict=True) if p not in prints[1]),
    )
