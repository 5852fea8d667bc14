"""The tables of a benchmark's report."""

from __future__ import annotations

import math
from collections.abc import Sequence

from ur5check._reports.document import Column, Row, Table
from ur5check._reports.wording import MISSING

from .result import Chapter, Comparison, OperationCount, Profile, Timing

__all__ = ["comparison_table", "operation_table", "profile_table", "series_table"]

#: Unit of a chapter to name and size [s] of the unit of time of its tables.
_UNITS = {"state": ("ns", 1e-9), "process": ("ms", 1e-3)}


def comparison_table(chapter: Chapter, comparison: Comparison) -> Table:
    """One row per contestant."""
    timings = comparison.timings
    compared = any(t.deviation is not None for t in timings)
    columns = (
        Column(""),
        Column(f"time per {chapter.unit} [{_UNITS[chapter.unit][0]}]", number=True),
        Column("spread [%]", number=True),
        Column(_ratio_title(chapter), number=True),
        *([Column("difference [N m]", number=True)] if compared else []),
    )
    rows = (
        Row(
            (
                t.name,
                _time(chapter, t.seconds),
                f"{100.0 * t.spread:.0f}",
                _ratio(chapter, t),
                *([_deviation(t)] if compared else []),
            )
        )
        for t in timings
    )
    return Table(columns, tuple(rows), title=comparison.subject)


def series_table(chapter: Chapter) -> Table:
    """One row per contestant, one column per size."""
    sizes = chapter.comparisons
    names = [t.name for t in sizes[0].timings] if sizes else []
    rows = (
        Row((name, *(_time(chapter, size.timings[i].seconds) for size in sizes)))
        for i, name in enumerate(names)
    )
    return Table(
        (Column(""), *(Column(size.subject, number=True) for size in sizes)),
        tuple(rows),
        title=f"Time per {chapter.unit} [{_UNITS[chapter.unit][0]}]",
    )


def operation_table(counts: Sequence[OperationCount]) -> Table:
    """One row per quantity."""
    return Table(
        (
            Column("at one state"),
            Column("as written", number=True),
            Column("generated", number=True),
            Column("products", number=True),
        ),
        tuple(
            Row(
                (
                    count.what,
                    f"{count.as_written.total:,}",
                    f"{count.generated.total:,}",
                    f"{count.generated.multiplications:,}",
                )
            )
            for count in counts
        ),
    )


def profile_table(profiles: Sequence[Profile]) -> Table:
    """One row per part, one column per command."""
    parts = list(dict.fromkeys(part for profile in profiles for part, _ in profile.parts))
    spent = [dict(profile.parts) for profile in profiles]
    rows = [Row(("whole", *(f"{profile.whole:.2f}" for profile in profiles)))]
    rows += [
        Row((part, *(f"{own[part]:.2f}" if part in own else MISSING for own in spent)))
        for part in parts
    ]
    columns = (
        Column("part"),
        *(Column(f"{profile.command} [s]", number=True) for profile in profiles),
    )
    return Table(columns, tuple(rows))


def _time(chapter: Chapter, seconds: float) -> str:
    """Three digits in the chapter's unit: 4.12, 41.2, 41,200."""
    value = seconds / _UNITS[chapter.unit][1]
    digits = 2 - math.floor(math.log10(value))
    return f"{round(value, digits):,.{max(digits, 0)}f}"


def _ratio_title(chapter: Chapter) -> str:
    return "times as fast" if chapter.unit == "state" else "times as long"


def _ratio(chapter: Chapter, timing: Timing) -> str:
    """To the first row."""
    ratio = timing.speed if chapter.unit == "state" else 1.0 / timing.speed
    return f"{ratio:.2f}"


def _deviation(timing: Timing) -> str:
    return MISSING if timing.deviation is None else f"{timing.deviation:.1e}"
