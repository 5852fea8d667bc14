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
    """Engine agreement for several arms.

    An arm that an engine refuses counts as refused, never as agreement.

    Attributes
    ----------
    reports : tuple of EngineReport
        One per arm.
    samples, seed : int
        Of each of them.
    """

    reports: tuple[EngineReport, ...]
    samples: int
    seed: int

    def worst(self, *, as_read: bool) -> float:
        """The largest |Δτ| of any two engines on any arm.

        Parameters
        ----------
        as_read : bool
            Whether with the files as they are, or repaired where there are repairs.

        Returns
        -------
        float
            [N m]
        """
        return max(stage.matrix.worst for stage in self.stages(as_read=as_read))

    def stages(self, *, as_read: bool) -> tuple[Stage, ...]:
        """One stage per arm.

        Parameters
        ----------
        as_read : bool
            Whether with the files as they are, or repaired where there are repairs.

        Returns
        -------
        tuple of Stage
        """
        return tuple(report.as_read if as_read else report.final for report in self.reports)

    def agreeing(self, limit: float, *, as_read: bool) -> int:
        """Number of arms that every engine reads and on which all agree.

        Parameters
        ----------
        limit : float
            [N m]
        as_read : bool
            Whether with the files as they are, or repaired where there are repairs.

        Returns
        -------
        int
        """
        return sum(stage.agrees(limit) for stage in self.stages(as_read=as_read))

    def differing(self, limit: float, *, as_read: bool) -> int:
        """Number of arms on which two engines differ.

        Parameters
        ----------
        limit : float
            [N m]
        as_read : bool
            Whether with the files as they are, or repaired where there are repairs.

        Returns
        -------
        int
        """
        return sum(stage.matrix.worst > limit for stage in self.stages(as_read=as_read))

    def refused(self, *, as_read: bool) -> int:
        """Number of arms that at least one engine refuses.

        Parameters
        ----------
        as_read : bool
            Whether with the files as they are, or repaired where there are repairs.

        Returns
        -------
        int
        """
        return sum(bool(stage.refusals) for stage in self.stages(as_read=as_read))

    def agrees(self, limit: float, *, as_read: bool) -> bool:
        """Whether every engine reads every arm and all agree.

        Parameters
        ----------
        limit : float
            [N m]
        as_read : bool
            Whether with the files as they are, or repaired where there are repairs.

        Returns
        -------
        bool
        """
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
    """Engine agreement for every arm of a fleet: `compare_engines`, arm by arm.

    Parameters
    ----------
    engines : sequence of str, optional
        Keys; all that are installed when None.
    samples : int
        Number of random states for each arm, at least 1.
    seed : int
        Of the states, not negative.
    repairs : bool
        Whether engines that imported another arm read it again with their repairs.
    arms : sequence of FleetArm, optional
        `EXAMPLE_ROBOTS` when None.
    progress : callable, optional
        Called with a line before each arm.

    Returns
    -------
    FleetReport

    Raises
    ------
    InputError
        For an invalid argument, or an arm that cannot be read.
    EngineError
        For an engine that was named and is not installed.

    Examples
    --------
    >>> import ur5check
    >>> ur5 = [arm for arm in ur5check.EXAMPLE_ROBOTS if arm.name == "ur5"]
    >>> fleet = ur5check.compare_fleet(engines=["pinocchio"], arms=ur5, samples=5)
    >>> fleet.refused(as_read=True)
    0
    """
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
