"""A benchmark as plain values for JSON.  Every field is documented in docs/json.md."""

from __future__ import annotations

from dataclasses import asdict

from .._benchmarking.result import Benchmark, Chapter, OperationCount, Profile
from .._benchmarking.summary import summarize
from .._dynamics.symbolic.program import Operations
from .json_head import json_head
from .json_values import Report, model_value, strict

__all__ = ["benchmark_json"]


def benchmark_json(b: Benchmark, *, command: str = "") -> Report:
    """`bench` as ur5check.benchmark/1."""
    return strict(
        {
            **json_head("benchmark", [b.arm], command, b.seed, b.states),
            "model": model_value(b.arm),
            "machine": b.machine,
            "measured": b.versions,
            "rounds": b.rounds,
            "threads": b.threads,
            "summary": summarize(b),
            "chapters": [_chapter(chapter) for chapter in b.chapters],
            "counts": [_count(count) for count in b.operations],
            "profiles": [_profile(profile) for profile in b.profiles],
        }
    )


def _chapter(chapter: Chapter) -> Report:
    return {
        "key": chapter.key,
        "unit": chapter.unit,
        "said": chapter.said,
        "comparisons": [
            {
                "subject": comparison.subject,
                "timings": [asdict(timing) for timing in comparison.timings],
            }
            for comparison in chapter.comparisons
        ],
    }


def _count(count: OperationCount) -> Report:
    return {
        "what": count.what,
        "as_written": _operations(count.as_written),
        "generated": _operations(count.generated),
    }


def _operations(operations: Operations) -> Report:
    return {
        "multiplications": operations.multiplications,
        "additions": operations.additions,
        "total": operations.total,
    }


def _profile(profile: Profile) -> Report:
    return {
        "command": profile.command,
        "seconds": profile.whole,
        "parts": [{"part": part, "seconds": seconds} for part, seconds in profile.parts],
    }
