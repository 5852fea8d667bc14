"""CMP: two models of one robot.  These findings come from comparing, not from a check of one."""

from __future__ import annotations

from .rule import Rule

__all__ = ["RULES"]

RULES = (
    Rule(
        "CMP001",
        "torques-differ",
        "error",
        "two models of one robot need the same torques",
        "A controller tuned on one model runs on the other.",
        "the robot follows less exactly, or not at all",
        bad="two files of a robot, one with a mass in pounds",
        good="the same robot as URDF and as DH table",
        fix="ur5check diff A B says which numbers differ and what they cost",
        example="words",
    ),
    Rule(
        "CMP002",
        "not-comparable",
        "error",
        "two models of one robot have the same number of joints",
        "Arms of other joints have no torques in common.",
        "nothing can be compared",
        bad="an arm of six joints and one of seven",
        good="two arms of six joints",
        fix="choose the arms with --tip-a and --tip-b",
        example="words",
    ),
    Rule(
        "CMP003",
        "other-numbers-differ",
        "error",
        "two models of one robot have the same damping, friction, motors, limits and gravity",
        "Simulators and controllers use these numbers beside the torques of the rigid bodies.",
        "the same commands move the two differently, or stop one of them at another limit",
        bad="two files of a robot, one with an effort limit of 15 N m in place of 150",
        good="the same robot as URDF and as xacro",
        fix="ur5check diff A B says which numbers differ, and where they are written",
        example="words",
    ),
)
