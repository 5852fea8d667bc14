"""The report of `bench_speed.py`."""

from __future__ import annotations

from collections.abc import Iterator

from ur5check._reports.document import Document, Section, Table
from ur5check._reports.provenance import Provenance, inputs_of

from .result import Benchmark, Chapter
from .summary import summarize
from .tables import comparison_table, operation_table, profile_table, series_table

__all__ = ["speed_document"]


def speed_document(b: Benchmark, *, command: str = "") -> Document:
    """The report of a benchmark, without a verdict."""
    return Document(
        f"How fast: {b.arm.name}",
        None,
        tuple(summarize(b)),
        tuple(_sections(b)),
        Provenance(inputs_of([b.arm]), b.seed, b.states, command, libraries=b.versions),
    )


def _sections(b: Benchmark) -> Iterator[Section]:
    machine = b.machine
    yield Section(
        "How it was measured",
        (
            f"{machine['processor']}, {machine['cores']} cores, {machine['system']}. "
            f"Medians of {b.rounds} rounds in which all entries of a table take turns, so "
            "that a slow second affects all alike. Compare ratios, not times.",
        ),
    )
    for chapter in b.chapters:
        yield Section(chapter.title, (chapter.method,), tuple(_tables(chapter)))
    if b.operations:
        method = "Multiplications (products) and additions at one state, without sines and cosines."
        yield Section("Operations", (method,), (operation_table(b.operations),))
    if b.profiles:
        method = (
            "Each command in its own process, its stack sampled every millisecond. "
            "The reference engine is Pinocchio, called state by state."
        )
        yield Section("Where commands spend their time", (method,), (profile_table(b.profiles),))


def _tables(chapter: Chapter) -> Iterator[Table]:
    if chapter.series:
        yield series_table(chapter)
    else:
        yield from (comparison_table(chapter, comparison) for comparison in chapter.comparisons)
