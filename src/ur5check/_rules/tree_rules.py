"""TRE: the tree of links and joints."""

from __future__ import annotations

from collections.abc import Iterator

from .._finding import Finding
from .examples import joint, link, robot
from .finding_log import finding_of
from .rule import Rule
from .rule_subject import RuleSubject

__all__ = ["RULES"]

_GOOD = robot()


def _unmodelled(s: RuleSubject) -> Iterator[Finding]:
    for one in s.robot.unmodelled:
        yield finding_of("TRE106", one.what, one.problem, one.place)


RULES = (
    Rule(
        "TRE101",
        "duplicate-name",
        "error",
        "every link and every joint has a name of its own",
        "Names are the only references in a description.",
        "readers refuse the file or take one of the two",
        bad=robot(joint(), link(), link()),
        good=_GOOD,
        fix="give each its own name",
    ),
    Rule(
        "TRE102",
        "unknown-name",
        "error",
        "every parent, child and followed joint exists",
        "A reference to nothing cuts the robot in two.",
        "readers refuse the file",
        bad=robot(joint(child="amr"), link()),
        good=_GOOD,
        fix="correct the name",
    ),
    Rule(
        "TRE103",
        "several-roots",
        "error",
        "one link is the root of all others",
        "A description with two roots is two robots, or a joint is missing.",
        "readers refuse the file or drop one part",
        bad=robot(joint(), link(), link("other")),
        good=_GOOD,
        fix="join the parts by a joint, or remove the unused link",
    ),
    Rule(
        "TRE104",
        "loop",
        "error",
        "every link has one parent, and no link carries itself",
        "URDF describes trees: a loop of links needs another format (SDF, MJCF).",
        "Pinocchio reads an empty model, other readers refuse the file",
        bad=robot(
            joint(),
            link(),
            joint("k", parent="arm", child="tip"),
            link("tip"),
            joint("l", child="tip"),
        ),
        good=_GOOD,
        fix="remove one of the joints",
    ),
    Rule(
        "TRE105",
        "no-link",
        "error",
        "a robot has links",
        "A file without links describes nothing.",
        "readers make an empty model",
        bad='<robot name="r"/>',
        good=_GOOD,
        fix="write links, and joints between them",
    ),
    Rule(
        "TRE106",
        "unmodelled",
        "note",
        "joints, weight and drives are all that acts on the robot",
        "Constraints, tendons, springs, gravity compensation and fluids act in the simulator.",
        "torques computed here are without it; an arm on which it acts is not computed",
        bad="an MJCF whose finger is tied to another by an equality",
        good="an MJCF of bodies and joints",
        fix="remove it, or choose --base and --tip so that it lies outside the arm",
        check=_unmodelled,
        example="words",
    ),
)
