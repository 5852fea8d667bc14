"""XML: the file's format.  The reader makes these findings while it reads."""

from __future__ import annotations

from .examples import joint, link, robot
from .rule import Rule

__all__ = ["RULES"]

_GOOD = robot()

RULES = (
    Rule(
        "XML100",
        "unreadable",
        "error",
        "the file can be read by the reader of its format",
        "What two readers could take differently is refused.",
        "the file cannot be read as it stands",
        bad="a DH table without the column alpha",
        good="a DH table with all columns",
        fix="correct what the message names",
        example="words",
    ),
    Rule(
        "XML101",
        "not-xml",
        "error",
        "the file is well-formed XML in UTF-8, without a document type",
        "Readers repair broken XML differently, and entities of a document type differently too.",
        "strict readers refuse the file; lenient ones read a part of it",
        bad='<robot name="r"><link name="a"></robot>',
        good=_GOOD,
        fix="correct the XML; fetch a cut-off file again; save it as UTF-8",
    ),
    Rule(
        "XML102",
        "not-a-robot",
        "error",
        "the root element is one of a robot description",
        "The name's suffix says how a file is to be read, and the root element must agree.",
        "no reader of this format takes the file",
        bad='<sdf version="1.9"/>',
        good=_GOOD,
        fix="give a URDF (<robot>), an MJCF (<mujoco>, .xml) or an SDF (<sdf>, .sdf)",
    ),
    Rule(
        "XML103",
        "not-a-number",
        "error",
        "every number is finite and in plain decimal notation",
        "nan, inf, a decimal comma or a no-break space are read differently by every library: "
        "urdfdom drops the whole <inertial>, others read 0 or a part of the text.",
        "readers drop the element or read another number, mostly without a message",
        bad=robot(joint(), link(mass="2,5")),
        good=_GOOD,
        fix="write a finite decimal number such as -0.0018 or 1.2e-3",
    ),
    Rule(
        "XML104",
        "missing",
        "error",
        "every name, element and attribute that the format demands is there",
        "yourdfpy turns a missing ixx into 1.0, Pinocchio drops the <inertial>, others refuse.",
        "readers invent a value, drop the element or refuse the file",
        bad=robot(joint(), link(inertial='<inertial><mass value="1"/></inertial>')),
        good=_GOOD,
        fix="write it",
    ),
    Rule(
        "XML105",
        "duplicate-element",
        "error",
        "an element that may stand once stands once",
        "Of two <inertial> or <limit> elements one reader takes the first, another the last.",
        "readers disagree on the values",
        bad=robot(joint(limit=2 * '<limit lower="-1" upper="1" effort="1" velocity="1"/>'), link()),
        good=_GOOD,
        fix="keep one of them",
    ),
    Rule(
        "XML106",
        "ignored",
        "note",
        "nothing stands in the file that the format ignores",
        "An rpy on an <axis> or a misspelt attribute looks as if it did something.",
        "readers ignore it",
        bad=robot(joint(axis='<axis xyz="0 1 0" rpy="0 0 0"/>'), link()),
        good=_GOOD,
        fix="remove it, or write it where the format has a place for it",
    ),
    Rule(
        "XML107",
        "unexpanded-xacro",
        "error",
        "no xacro expression is left in a URDF",
        "A xacro that is read without expansion has text where numbers belong.",
        "readers refuse the file or read 0",
        bad=robot(joint(), link(mass="${m}")),
        good=_GOOD,
        fix="name the file .xacro, or expand it first: ur5check expand FILE",
    ),
)
