"""What `sweep` shows."""

from __future__ import annotations

from .._sweep.magnitude_histogram import RELATIVE_ERROR
from .._sweep.sweep_result import Sweep
from .document import Document, Section, Verdict
from .provenance import Provenance, inputs_of
from .sweep_summary import sample_in_words, summarize
from .sweep_tables import (
    decade_table,
    joint_table,
    limit_table,
    motion_table,
    reach_table,
    worst_table,
)
from .wording import titled

__all__ = ["sweep_document"]


def sweep_document(s: Sweep, *, command: str = "") -> Document:
    """The report of `ur5check sweep`."""
    verdict, *lines = summarize(s)
    return Document(
        f"{titled(s.pair.a)} against {titled(s.pair.given_b)}",
        Verdict("AGREE" if s.agrees else "DIFFER", verdict, s.agrees),
        tuple(lines),
        (_joints(s), _sizes(s), _reach(s)),
        _provenance(s, command),
    )


def _provenance(s: Sweep, command: str) -> Provenance:
    """A log is an input too; only drawn states have a seed."""
    inputs = (*inputs_of((s.pair.a, s.pair.given_b)), *s.log)
    seed = s.plan.sample.description().get("seed")
    return Provenance(inputs, seed, None if seed is None else s.count, command)


def _joints(s: Sweep) -> Section:
    exact = s.pair.alignment.exact
    said = (
        f"{sample_in_words(s).capitalize()}, in {s.pair.a.label}'s joint coordinates; "
        f"the axes are {'' if exact else 'NOT '}the same lines in space.",
        f"Relative error of quantiles: {RELATIVE_ERROR:.1%}. The maxima are those of these "
        "states; `ur5check diff` searches for larger ones.",
    )
    tolerance = () if s.plan.tolerance is None else (limit_table(s),)
    tables = (joint_table(s), *tolerance, worst_table(s), motion_table(s))
    return Section("Joint by joint", said, tables)


def _sizes(s: Sweep) -> Section:
    return Section("Distribution of the difference", (), (decade_table(s),))


def _reach(s: Sweep) -> Section:
    every, visits = s.plan.map_every, int(s.statistics.visits.sum())
    which = "Every state" if every == 1 else f"Every {every}th state ({visits:,})"
    said = (
        f"{which}, by the tool's distance from the z axis of {s.pair.a.label}'s base and its "
        "height above that base; per cell, the largest difference of any joint."
    )
    return Section("Reach map", (said,), (reach_table(s),))
