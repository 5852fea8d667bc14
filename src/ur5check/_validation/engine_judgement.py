"""What physics engines make of a file: the audit of their imports, as findings of its judgement."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from .._arguments import names
from .._engines.audit.engine_comparison import compare_engines, engine_keys
from .._engines.registry import REFERENCE
from .._errors import ModelError
from .._finding import Finding
from .._robot.robot import Robot
from .._robot.robot_tree import RobotTree
from .._rules.finding_log import finding_of

__all__ = ["ALL_ENGINES", "DEEPEST", "engines_asked", "import_findings"]

#: urdfdom, which most engines read with, calls itself for every link: 20,000 end the process.
DEEPEST = 1000

#: The word for all engines that are installed.
ALL_ENGINES = "all"

#: Families of rules about a file's text and tree: on a file with such an error (a loop of links)
#: an engine's parser may never end.
_STRUCTURE = ("XML", "XAC", "TRE")

#: A difference of any parameter shows at almost every state: a few of them do.
_SAMPLES = 20


def engines_asked(named: Sequence[str]) -> tuple[str, ...]:
    """Keys of the engines that are meant, without the hand-written recursion.

    Raises UsageError for a name that is no engine's, EngineError for one that is not installed.
    """
    everyone = ALL_ENGINES in names("engines", named)
    keys = engine_keys(None if everyone else named)
    return tuple(key for key in keys if named and key != REFERENCE)


def import_findings(
    robot: Robot, engines: Sequence[str], found: Sequence[Finding], seed: int
) -> list[Finding]:
    """What these engines refuse of the whole robot, or read otherwise than it is written.

    found : by the rules.  An engine that alters or refuses a model is a warning, and an error where
        the file has an error in the same place
    """
    if not engines:
        return []
    try:
        reason = _unfit(robot, found)
        tree = None if reason else RobotTree.of(robot)
    except ModelError as error:
        tree, reason = None, f"{error.element or 'the robot'}: {error.problem}"
    if tree is None:
        return [finding_of("ENG103", f"robot {robot.name!r}", reason)]
    report = compare_engines(tree, engines=engines, samples=_SAMPLES, seed=seed, repairs=False)
    errors = {finding.subject for finding in found if finding.severity == "error"}
    return [_weighed(finding, errors) for finding in report.findings]


def _unfit(robot: Robot, found: Sequence[Finding]) -> str:
    """Why a file is not given to engines; "" where nothing speaks against it."""
    for finding in found:
        if finding.severity == "error" and finding.rule.startswith(_STRUCTURE):
            return f"the file has {finding.rule}: {finding.subject}: {finding.message}"
    if robot.depth > DEEPEST:
        return f"the tree is deeper than {DEEPEST:,} links, which engines' parsers are not for"
    return ""


def _weighed(finding: Finding, errors: set[str]) -> Finding:
    """An error only where the file has one: at the subject, or at what the engine's words name."""
    named = finding.subject in errors or any(
        subject.partition(" ")[2] in finding.message for subject in errors if "'" in subject
    )
    if finding.severity != "error" or named:
        return finding
    return replace(finding, severity="warning")
