"""Verdicts in one sentence, and the files that they rest on."""

from __future__ import annotations

from .._validation.configuration import Configuration
from .._validation.verdict import VerdictSet

__all__ = ["failed_laws", "inputs_of_verdicts", "summarize_verdicts"]


def summarize_verdicts(verdicts: VerdictSet) -> str:
    """How many models pass, and which pairs agree."""
    passed = sum(v.passed for v in verdicts.models)
    text = f"{passed} of {len(verdicts.models)} models pass."
    for pair in verdicts.pairs:
        text += f" {pair.label}: {'agree or accepted' if pair.passed else 'DIFFER'}."
    return text


def failed_laws(verdicts: VerdictSet) -> list[tuple[str, str]]:
    """(file, sentence) of every file with a law that failed: a defect of the computation."""
    return [
        (v.judgement.file, f"the computation is WRONG: {', '.join(failed)}; please report this")
        for v in verdicts.models
        if (failed := v.judgement.failed_laws)
    ]


def inputs_of_verdicts(
    verdicts: VerdictSet, configuration: Configuration
) -> tuple[tuple[str, str], ...]:
    """(name, SHA-256) of every file that was read, each once: models, meshes, configuration."""
    models = (one for judgement in verdicts.read for one in judgement.inputs)
    return tuple(dict.fromkeys((*models, *configuration.inputs)))
