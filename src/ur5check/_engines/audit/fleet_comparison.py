"""The same question for every serial arm of example-robot-data."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from ..._io.example_robots import FLEET, FleetArm
from .engine_comparison import EngineReport, compare_engines

__all__ = ["FLEET_SAMPLES", "FleetReport", "compare_fleet"]

#: A difference of any parameter shows at almost every state: a few of them do.
FLEET_SAMPLES = 20


@dataclass(frozen=True, eq=False)
class FleetReport:
    """One report an arm; samples, seed : of each of them."""

    reports: tuple[EngineReport, ...]
    samples: int
    seed: int

    def worst(self, *, as_read: bool) -> float:
        """The largest |Δτ| of any two engines on any arm [N m]."""
        stages = [report.as_read if as_read else report.final for report in self.reports]
        return max(stage.matrix.worst for stage in stages)


def compare_fleet(
    *,
    engines: Sequence[str] | None = None,
    samples: int = FLEET_SAMPLES,
    seed: int = 0,
    repairs: bool = True,
    arms: Sequence[FleetArm] | None = None,
    progress: Callable[[str], None] | None = None,
) -> FleetReport:
    """`compare_engines` on every arm of a fleet, `FLEET` when None.  Raises as that does."""
    say = progress or (lambda line: None)
    arms = FLEET if arms is None else arms
    reports = []
    for number, entry in enumerate(arms, 1):
        say(f"{entry.name} ({number} of {len(arms)})")
        reports.append(
            compare_engines(
                entry.load(), engines=engines, samples=samples, seed=seed, repairs=repairs
            )
        )
    return FleetReport(tuple(reports), samples, seed)
