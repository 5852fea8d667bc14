"""Verdicts in one sentence, and the files that they rest on."""

from __future__ import annotations

from collections.abc import Sequence

from .._validation.configuration import Configuration
from .._validation.verdict import PairVerdict, Verdict

__all__ = ["inputs_of_verdicts", "summarize_verdicts"]


def summarize_verdicts(results: Sequence[Verdict], pair: PairVerdict | None) -> str:
    """How many models pass, and whether two of them agree."""
    passed = sum(v.passed for v in results)
    text = f"{passed} of {len(results)} models pass."
    if pair is not None:
        text += f" {pair.label}: {'agree or accepted' if pair.passed else 'DIFFER'}."
    return text


def inputs_of_verdicts(
    results: Sequence[Verdict], configuration: Configuration
) -> tuple[tuple[str, str], ...]:
    """(name, SHA-256) of every file that was read, each once: models, meshes, configuration."""
    models = (one for v in results for one in v.judgement.inputs)
    return tuple(dict.fromkeys((*models, *configuration.inputs)))
