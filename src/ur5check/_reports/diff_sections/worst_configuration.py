"""Worst case: the states within the limits at which the arms disagree most."""

from __future__ import annotations

from ..._comparison.explanation import Explanation
from ..._comparison.worst_case.worst_case import WorstCase
from ..._robot.serial_arm import Joint
from ..document import Column, Row, Section, Table
from ..wording import MISSING, figures, percent, posture

__all__ = ["worst_section"]


def worst_section(e: Explanation) -> Section:
    """Joint by joint and all together: in motion, then at rest."""
    joints = e.difference.pair.a.joints
    moving = [case for case in e.worst if not case.static]
    resting = [case for case in e.worst if case.static]
    if not any(case.starts for case in e.worst):
        said = "The torques of the two arms differ by rounding alone at all random states."
        return Section("Worst case", (said,))
    searched = next(case for case in e.worst if case.starts)
    said = (
        "Searched within the limits of position, velocity and acceleration; each value is at "
        f"least this much. A higher one that is reached from more than "
        f"{percent(searched.undetected_share)} % of all starts would have been found with a "
        "probability of 95 %."
    )
    unit = "N m or N" if any(joint.kind == "prismatic" for joint in joints) else "N m"
    return Section(
        "Worst case",
        (said,),
        (
            _table(moving, joints, unit, "In motion", _RANDOM),
            _motion_table(moving, joints),
            _table(resting, joints, unit, "At rest: gravity alone"),
        ),
    )


_RANDOM = (
    "Reached: ascents that ended at this value, of those made from independent random states. "
    "All together: root of the sum of squares"
)


def _table(
    cases: list[WorstCase], joints: tuple[Joint, ...], unit: str, title: str, note: str = ""
) -> Table:
    shares = [case for case in cases if case.joint is None and case.effort_share is not None]
    bounded = any(case.bound is not None for case in cases)
    of = ", each torque as a share of its limit." if shares else " of torques."
    return Table(
        (
            Column("joint"),
            Column(f"at least [{unit}]", number=True),
            *([Column("at most", number=True)] if bounded else []),
            Column("of limit [%]", number=True),
            Column("reached", number=True),
            Column("posture [°]"),
        ),
        tuple(
            Row(
                (
                    _joint(case, joints),
                    MISSING if case.unit.startswith("of ") else figures(case.value),
                    *([_bound(case)] if bounded else []),
                    percent(case.effort_share),
                    f"{case.reached}/{case.starts}" if case.starts else MISSING,
                    posture(case.state["q"], joints) if case.starts else MISSING,
                )
            )
            for case in cases
        ),
        title=title,
        note=f"{note}{of}" if note else "",
    )


def _motion_table(cases: list[WorstCase], joints: tuple[Joint, ...]) -> Table:
    return Table(
        (Column("joint"), Column("velocities [°/s]"), Column("accelerations [°/s²]")),
        tuple(
            Row(
                (
                    _joint(case, joints),
                    posture(case.state["qd"], joints),
                    posture(case.state["qdd"], joints),
                )
            )
            for case in cases
            if case.starts
        ),
        title="Velocities and accelerations of these states",
    )


def _bound(case: WorstCase) -> str:
    return MISSING if case.unit.startswith("of ") else figures(case.bound)


def _joint(case: WorstCase, joints: tuple[Joint, ...]) -> str:
    return "all together" if case.joint is None else joints[case.joint - 1].name
