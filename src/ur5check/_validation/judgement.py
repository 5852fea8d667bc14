"""The verdict on one model: what the rules find, and whether the computation of its arm is right.

Two questions that are kept apart.  Rules judge the model's numbers.  Laws hold for any numbers:
they test the computation (ours and the reference engine's), never the model.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from .._arguments import integer, number, text_map
from .._errors import EngineError, ModelError, Ur5checkError, UsageError
from .._finding import SEVERITIES, Finding, Severity
from .._io.meshes.mesh_reader import MeshReader
from .._io.robot_arm import arm_of_robot
from .._io.robot_loading import RobotReading, read_robot
from .._robot.robot import Robot
from .._robot.serial_arm import SerialArm
from .._robot.states import random_states
from .._rules.check import check_rules
from .._rules.rule_subject import RuleSubject
from .validation import ModelValidation, validate_arm

__all__ = ["Judgement", "Level", "judge"]

#: The least severity that fails a model.
Level = Literal["error", "warning", "note"]

#: urdfdom, which Pinocchio reads with, calls itself for every link: 20,000 end the process.
_DEEPEST = 1000

#: Findings about bodies that leave the mass matrix without an inverse, or worse: the laws that need
#: one say nothing then.
_NO_DYNAMICS = {"INE101", "INE102", "INE104", "INE105", "INE106", "JNT101", "JNT111"}


@dataclass(frozen=True, eq=False)
class Judgement:
    """What is known of one model.

    model : as it was given;  file : what reports call it
    inputs : (name, SHA-256) of the files that were read, meshes too
    robot : None where the file describes none;  arm : None where there is none, `arm_note` says why
    laws : of the computation on `arm`; None where it was not checked, `laws_note` says why
    """

    model: str
    file: str
    inputs: tuple[tuple[str, str], ...]
    robot: Robot | None
    findings: tuple[Finding, ...]
    arm: SerialArm | None
    arm_note: str
    laws: ModelValidation | None
    laws_note: str
    samples: int
    seed: int

    def at_least(self, level: Level) -> tuple[Finding, ...]:
        """Findings of this severity and worse."""
        return tuple(
            f for f in self.findings if SEVERITIES.index(f.severity) <= SEVERITIES.index(level)
        )

    @property
    def laws_hold(self) -> bool:
        """Whether no law was seen to fail."""
        outcomes = () if self.laws is None else self.laws.outcomes
        return all(outcome.passed for outcome in outcomes if outcome.about == "algorithm")

    def passed(self, level: Level = "error") -> bool:
        """Whether there is no finding at or above the level, and no law failed."""
        return self.laws_hold and not self.at_least(level)

    def count(self, severity: Severity) -> int:
        """How many findings have this severity."""
        return sum(finding.severity == severity for finding in self.findings)


def judge(
    model: str | Path,
    *,
    base: str | None = None,
    tip: str | None = None,
    hold: Mapping[str, float] | None = None,
    packages: Mapping[str, str | Path] | None = None,
    arguments: Mapping[str, str] | None = None,
    samples: int = 1000,
    seed: int = 0,
    payload: float = 0.0,
    expected_mass: float | None = None,
    meshes: bool = True,
) -> Judgement:
    """Read a model's file whole, apply every rule, and check the computation of its arm.

    Parameters
    ----------
    model : a shipped model's name or a path
    base, tip, hold : which chain is the arm (default: a shipped model's own, else as `load`
        chooses), and where joints beside it are held
    packages, arguments : of ROS and of a xacro
    samples, seed : states at which the computation is checked
    payload : mass at the tip [kg];  expected_mass : of the whole robot [kg]
    meshes : whether links are compared with their meshes

    Returns
    -------
    Judgement : `findings` worst first, `passed()`, the `robot`, its `arm`, and the `laws`

    Raises
    ------
    UsageError : a name that means nothing, a file that is not there, arguments of a wrong type.

    Examples
    --------
    >>> import ur5check
    >>> judgement = ur5check.judge("erd-ur5", samples=10, meshes=False)
    >>> judgement.passed(), judgement.laws_hold
    (True, True)
    """
    if not isinstance(model, str | Path):
        raise UsageError(f"model must be a shipped model's name or a path, not {model!r:.80}")
    for name, mapping in (("hold", hold), ("packages", packages), ("arguments", arguments)):
        text_map(name, mapping)
    integer("samples", samples, least=1)
    integer("seed", seed, least=0)
    if number("payload", payload) < 0.0:
        raise UsageError(f"payload must be zero or more, not {payload}")
    if expected_mass is not None:
        number("expected_mass", expected_mass, positive=True)
    reading = read_robot(model, packages=packages, arguments=arguments, base=base, tip=tip)
    if reading.robot is None:
        none = "the file describes no robot"
        return Judgement(
            str(model),
            reading.file,
            reading.inputs,
            None,
            reading.findings,
            None,
            none,
            None,
            none,
            samples,
            seed,
        )
    arm, arm_note = _arm(reading, hold)
    reader = MeshReader(reading.folder, reading.packages) if meshes else None
    subject = RuleSubject(
        reading.robot, reader, arm=arm, payload=payload, expected_mass=expected_mass
    )
    findings = tuple(check_rules(subject, reading.findings))
    laws, laws_note = _laws(reading.robot, arm, findings, samples, seed)
    return Judgement(
        str(model),
        reading.file,
        (*reading.inputs, *(() if reader is None else reader.inputs.items())),
        reading.robot,
        findings,
        arm,
        arm_note,
        laws,
        laws_note or arm_note,
        samples,
        seed,
    )


def _arm(reading: RobotReading, hold: Mapping[str, float] | None) -> tuple[SerialArm | None, str]:
    if reading.arm is not None or reading.robot is None:
        if hold:
            raise UsageError(f"{reading.file} has no joint beside its arm that could be held")
        return reading.arm, ""
    try:
        arm = arm_of_robot(
            reading.robot, base=reading.base, tip=reading.tip, hold=hold, urdf=reading.text
        )
    except ModelError as error:
        return None, f"{error.element or 'the robot'} {error.problem}; {error.fix}"
    return arm, ""


def _depth(robot: Robot) -> int:
    """The most joints between a root and a link."""
    depth: dict[str, int] = {}
    for root in robot.roots:
        for name in robot.down(root):
            above = robot.above.get(name)
            depth[name] = 0 if above is None else depth[above.parent] + 1
    return max(depth.values(), default=0)


def _laws(
    robot: Robot, arm: SerialArm | None, findings: tuple[Finding, ...], samples: int, seed: int
) -> tuple[ModelValidation | None, str]:
    if arm is None:
        return None, ""
    if arm.unknown_tensors:
        return None, "tensors are unknown, so that only gravity torques can be had"
    if _depth(robot) > _DEEPEST:
        return (
            None,
            f"the tree is deeper than {_DEEPEST:,} links, which Pinocchio's parser is not for",
        )
    links = {f"link {link.name!r}" for link in arm.links}
    joints = {f"joint {joint.name!r}" for joint in arm.joints}
    for finding in findings:
        if finding.rule in _NO_DYNAMICS and finding.subject in links | joints:
            return None, f"{finding.subject} leaves the arm without dynamics ({finding.rule})"
    from .._engines.adapters.pinocchio import PinocchioEngine

    try:
        reference = PinocchioEngine(arm)
        return validate_arm(arm, reference, random_states(arm.n, samples, seed)), ""
    except (EngineError, Ur5checkError) as error:
        return None, f"Pinocchio does not take the file: {error}"
