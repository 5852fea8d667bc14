"""What `bench` shows."""

from __future__ import annotations

from collections.abc import Iterator

from .._benchmarking.result import Benchmark, Chapter
from .._benchmarking.summary import summarize
from .benchmark_tables import comparison_table, operation_table, profile_table, series_table
from .document import Document, Section, Table
from .provenance import Provenance, inputs_of

__all__ = ["benchmark_document"]


def benchmark_document(b: Benchmark, *, command: str = "") -> Document:
    """The report of `ur5check bench`.  It has no verdict: a slow machine is no fault."""
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
            f"Medians of {b.rounds} rounds in which all of a table take turns, so that a slow "
            "second hits all alike. Look at the ratios.",
        ),
    )
    for chapter in b.chapters:
        yield Section(chapter.title, (chapter.said,), tuple(_tables(chapter)))
    if b.operations:
        said = (
            "Multiplications (products) and additions at one state; sines and cosines come on top."
        )
        yield Section("Operations", (said,), (operation_table(b.operations),))
    if b.profiles:
        said = (
            "Whole commands in processes of their own, a sampler looking on every millisecond. "
            "The reference engines are Pinocchio, asked state by state."
        )
        yield Section("Where commands spend their time", (said,), (profile_table(b.profiles),))


def _tables(chapter: Chapter) -> Iterator[Table]:
    if chapter.series:
        yield series_table(chapter)
    else:
        yield from (comparison_table(chapter, comparison) for comparison in chapter.comparisons)
