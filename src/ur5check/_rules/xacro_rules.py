"""XAC: expansion of a xacro.  The reader makes these findings; expansion ends at the first."""

from __future__ import annotations

from .rule import Rule

__all__ = ["RULES"]


def _xacro(*lines: str) -> str:
    body = "\n".join(lines)
    return (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
        f'{body}\n<link name="base"/>\n<link name="arm"><inertial><mass value="1"/>'
        '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>\n'
        '<joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint>\n'
        "</robot>\n"
    )


_GOOD = _xacro('<xacro:property name="colour" value="grey"/>', '<material name="${colour}"/>')
_NO_URDF = "there is no URDF to read"

RULES = (
    Rule(
        "XAC100",
        "not-expandable",
        "error",
        "xacro expands the file without an error",
        "xacro stops at unknown macros, wrong parameters and expressions that are not Python.",
        _NO_URDF,
        bad=_xacro('<xacro:rod length="1"/>'),
        good=_xacro('<xacro:macro name="rod" params="length"/>', '<xacro:rod length="1"/>'),
        fix="correct what the message names",
        example=".xacro",
    ),
    Rule(
        "XAC101",
        "file-not-found",
        "error",
        "every package and every included file is found",
        "Without ROS a package's folder is known only if it is given or lies around the file.",
        _NO_URDF,
        bad=_xacro('<xacro:include filename="$(find no_such_package)/arm.xacro"/>'),
        good=_GOOD,
        fix="pass --package NAME=DIR, or correct the name",
        example=".xacro",
    ),
    Rule(
        "XAC102",
        "undefined-name",
        "error",
        "every property and argument that an expression uses has a value",
        "A misspelt property has no value; an argument without default must be given.",
        _NO_URDF,
        bad=_xacro('<material name="${colour}"/>'),
        good=_GOOD,
        fix="define the property before it is used, or pass --arg NAME:=VALUE",
        example=".xacro",
    ),
    Rule(
        "XAC103",
        "unsafe-expression",
        "error",
        "expressions compute values and read nothing outside of the robot's files",
        "Expressions are Python code: one that reaches Python's internals or other files could "
        "read or change anything on the machine that expands it.",
        "with a plain xacro the code runs with the rights of its user; here expansion is ended",
        bad=_xacro('<material name="${().__class__}"/>'),
        good=_GOOD,
        fix="remove the expression, and ask the author of the file what it is for",
        example=".xacro",
    ),
    Rule(
        "XAC104",
        "endless-expansion",
        "error",
        "expansion ends within its limits of time, memory and size",
        "A macro or include that calls itself never ends.",
        _NO_URDF,
        bad=_xacro('<xacro:macro name="again"><xacro:again/></xacro:macro>', "<xacro:again/>"),
        good=_GOOD,
        fix="end the recursion with xacro:if or xacro:unless",
        example=".xacro",
    ),
)
