"""LOG: recordings.  The reader of recordings and their comparison with a model make them."""

from __future__ import annotations

from typing import Literal

from .rule import Rule

__all__ = ["RULES"]


def _log(
    number: int, name: str, severity: Literal["error", "warning", "note"], checks: str, why: str,
    consequence: str, bad: str, good: str, fix: str,
) -> Rule:  # fmt: skip
    return Rule(
        f"LOG{number}", name, severity, checks, why, consequence, bad, good, fix, example="words"
    )


RULES = (
    _log(
        101, "row-not-finite", "warning",
        "every row holds finite numbers of a size that a robot can have",
        "A logger that starts before its robot writes garbage, with plausible zeros between.",
        "the row is left out",
        "row 2 holds a position of 3.1e154 rad", "every position lies within the joint's limits",
        "start the logger after the robot's driver",
    ),
    _log(
        102, "time-not-increasing", "warning",
        "time increases from row to row",
        "Repeated samples and clocks that are set back have no velocity.",
        "the row is left out",
        "rows 5 and 6 both at 0.040 s", "0.040 s, 0.048 s",
        "record with a steady clock, and drop repeated samples",
    ),
    _log(
        103, "row-cut", "warning",
        "every row has as many cells as the first",
        "A logger that is stopped leaves its last line half-written.",
        "the row is left out",
        "the last row ends after 12 of 31 cells", "every row has 31 cells",
        "close the file before the logger ends",
    ),
    _log(
        104, "row-unreachable", "warning",
        "every position can be reached from the one before it",
        "Positions move continuously; a jump within one sample is none that a robot made.",
        "the row is left out",
        "rows 3 to 9 hold zeros between rows at 1.2 rad", "positions change by 0.01 rad a row",
        "find out what the logger wrote there",
    ),
    _log(
        105, "gap", "warning",
        "samples follow each other without gaps",
        "A filter over a gap invents what was not measured.",
        "the parts before and after are filtered by themselves, and their ends left out",
        "no sample between 3.2 s and 3.9 s", "a sample every 8 ms",
        "record to a faster disk, or with fewer topics",
    ),
    _log(
        106, "jitter", "note",
        "samples come at equal steps of time",
        "Indexing by a nominal rate stretches time where samples come late: every acceleration is "
        "wrong by the square, and no residual shows it.",
        "the file's own times are used, resampled",
        "steps of 2 to 14 ms under a nominal 10 ms", "steps of 10.0 ms",
        "none needed where the file has times; otherwise record them",
    ),
    _log(
        111, "joints-by-order", "note",
        "joints are matched by name",
        "A recording without names could have its joints in any order.",
        "a wrong order compares each joint with another",
        "31 columns without a header", "columns elbow_joint.position, elbow_joint.effort …",
        "record names, or make sure that the order is the model's",
    ),
    _log(
        121, "channel-constant", "warning",
        "every joint's position, velocity and torque change",
        "A channel that never changes is not connected, or belongs to a joint that stood still.",
        "nothing can be said about this joint",
        "the torque of joint 6 is 0 in every row", "every torque changes",
        "record a motion of every joint, and check the logger's channels",
    ),
    _log(
        122, "torque-saturated", "warning",
        "no torque stands at its largest value for more than 1 % of the time",
        "A limited drive gives less torque than the motion would need.",
        "the model seems too heavy where the drive was limited",
        "joint 2 stands at 150.0 N m in 4 % of the samples", "its largest torque is 98 N m, once",
        "record a slower motion",
    ),
    _log(
        123, "velocity-late", "warning",
        "velocities belong to the positions beside them",
        "A velocity that a driver filters comes late: it looks like rotor inertia that is none.",
        "velocity is taken from position instead",
        "velocities are 180 ms behind the positions", "velocity is the derivative of position",
        "none needed: positions are used",
    ),
    _log(
        124, "velocity-inconsistent", "warning",
        "velocity is the derivative of position",
        "Another sign or unit in one of the two channels.",
        "velocity is taken from position instead",
        "joint 3's velocity is −1 times the derivative of its position",
        "both have one sign and one unit",
        "correct the sign or unit of the channel: --degrees, or a negative gain",
    ),
    _log(
        131, "torque-is-a-model", "error",
        "torques are measured",
        "A controller's own model follows a model without friction, whatever the robot does.",
        "nothing can be said about the model: it would be compared with another model",
        "the column tau_J_d of a Franka, or a UR's target moment",
        "motor current times gain, or a torque sensor",
        "take the measured column, or the currents with --gains: --columns",
    ),
    _log(
        132, "gain-inconsistent", "warning",
        "given drive gains are those that the file's current and controller's torque show",
        "Published gains were 11 to 13 % too high and made a right model look 16 % too light.",
        "all torques, and every mass that is fitted, are wrong by the same factor",
        "--gains 13.26 where the file shows 11.8 N m/A", "--gains 11.8",
        "give the gains that the file shows, or measure them with a known load",
    ),
)  # fmt: skip
