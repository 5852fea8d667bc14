"""Engine agreement for every serial arm of example-robot-data."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from ..._arguments import callback, instance
from ..._errors import UsageError
from ..._io.example_robots import FLEET, FleetArm
from ..._result import Result
from .engine_comparison import EngineReport, Stage, compare_engines

__all__ = ["FLEET_SAMPLES", "FleetReport", "compare_fleet"]

#: A difference of any parameter shows at almost every state: a few of them do.
FLEET_SAMPLES = 20


@dataclass(frozen=True, eq=False, repr=False)
class FleetReport(Result):
    """One report per arm; samples, seed : of each of them.

    An arm that an engine refuses counts as refused, never as agreement.
    """

    reports: tuple[EngineReport, ...]
    samples: int
    seed: int

    def worst(self, *, as_read: bool) -> float:
        """The largest |Δτ| of any two engines on any arm [N m]."""
        return max(stage.matrix.worst for stage in self.stages(as_read=as_read))

    def stages(self, *, as_read: bool) -> tuple[Stage, ...]:
        """One stage per arm: as read, or repaired where there are repairs."""
        return tuple(report.as_read if as_read else report.final for report in self.reports)

    def agreeing(self, limit: float, *, as_read: bool) -> int:
        """Number of arms that every engine reads and on which all agree within `limit` [N m]."""
        return sum(stage.agrees(limit) for stage in self.stages(as_read=as_read))

    def differing(self, limit: float, *, as_read: bool) -> int:
        """Number of arms on which two engines differ by more than `limit` [N m]."""
        return sum(stage.matrix.worst > limit for stage in self.stages(as_read=as_read))

    def refused(self, *, as_read: bool) -> int:
        """Number of arms that at least one engine refuses."""
        return sum(bool(stage.refusals) for stage in self.stages(as_read=as_read))

    def agrees(self, limit: float, *, as_read: bool) -> bool:
        """Whether every engine reads every arm and all agree within `limit` [N m]."""
        return self.agreeing(limit, as_read=as_read) == len(self.reports)


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
    say = callback("progress", progress)
    arms = FLEET if arms is None else _entries(arms)
    reports = []
    for number, entry in enumerate(arms, 1):
        say(f"{entry.name} ({number} of {len(arms)})")
        reports.append(
            compare_engines(
                entry.load(), engines=engines, samples=samples, seed=seed, repairs=repairs
            )
        )
    return FleetReport(tuple(reports), samples, seed)


def _entries(arms: Sequence[FleetArm]) -> tuple[FleetArm, ...]:
    """Raises UsageError for anything but a sequence of at least one robot."""
    if not isinstance(arms, tuple | list) or not arms:
        raise UsageError(f"arms must be some of ur5check.EXAMPLE_ROBOTS, not {arms!r:.80}")
    return tuple(instance("arms", arm, FleetArm, "see ur5check.EXAMPLE_ROBOTS") for arm in arms)
