"""A validation in a few sentences, the verdict first."""

from __future__ import annotations

from .._validation.law import Outcome
from .._validation.validation import Validation
from . import difference_summary

__all__ = ["summarize"]


def summarize(validation: Validation) -> tuple[str, ...]:
    """One sentence each on the algorithm and the bodies, then the summary of every difference."""
    sentences = [_algorithm(validation), _bodies(validation)]
    for pair in validation.pairs:
        sentences += difference_summary.summarize(pair.difference)
        if not pair.explained:
            (residual,) = (o for o in pair.outcomes if o.id == "residual")
            sentences.append(
                f"NOT EXPLAINED: the attribution leaves a residual of {residual.value:.2g} N m "
                f"(rounding allows {residual.tolerance:.1g} N m)."
            )
    return tuple(sentences)


def _algorithm(validation: Validation) -> str:
    laws = [o for o in validation.outcomes if o.about == "algorithm"]
    broken = [o for o in laws if not o.passed]
    if broken:
        return f"The algorithm is WRONG: {len(broken)} of {len(laws)} laws fail, {_first(broken)}."
    models = len(validation.models)
    each = len(laws) // models
    reference = validation.models[0].reference
    return (
        f"The algorithm is right: all {each} laws hold on {'both' if models == 2 else models} "
        f"model{'s' if models > 1 else ''} at {validation.samples:,} states, "
        f"{reference} as reference."
    )


def _bodies(validation: Validation) -> str:
    impossible = [o for o in validation.outcomes if o.about == "body" and not o.passed]
    if impossible:
        return f"A link's inertia belongs to NO REAL BODY: {_first(impossible)}."
    arms = "arm" if len(validation.models) == 1 else "arms"
    return f"Every link of the computed {arms} could be a real body."


def _first(outcomes: list[Outcome]) -> str:
    worst = outcomes[0]
    return (
        f"first {worst.id} on {worst.subject} ({worst.value:.3g} {worst.unit}, "
        f"allowed {worst.tolerance:.1g})"
    )
