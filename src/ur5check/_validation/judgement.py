"""The verdict on one model: what the rules find, and whether the computation of its arm is right.

Two questions that are kept apart.  Rules judge the model's numbers.  Laws hold for any numbers:
they test the computation (ours and the reference engine's), never the model.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from .._arguments import integer, number, text_map
from .._errors import EngineError, ModelError, Ur5checkError, UsageError
from .._finding import SEVERITIES, Finding, Severity, worst_first
from .._io.meshes.mesh_reader import MeshReader
from .._io.robot_arm import arm_of_robot
from .._io.robot_loading import RobotReading, read_robot
from .._robot.robot import Robot
from .._robot.serial_arm import SerialArm
from .._robot.states import random_states
from .._rules.check import check_rules
from .._rules.rule_subject import RuleSubject
from .engine_judgement import DEEPEST, engines_asked, import_findings
from .validation import ModelValidation, validate_arm

__all__ = ["Judgement", "Level", "judge"]

#: The least severity that fails a model.
Level = Literal["error", "warning", "note"]

#: Findings about bodies that leave the mass matrix without an inverse, or worse: the laws that need
#: one say nothing then.
_NO_DYNAMICS = {"INE101", "INE102", "INE104", "INE105", "INE106", "JNT101", "JNT111"}


@dataclass(frozen=True, eq=False)
class Judgement:
    """What is known of one model.

    Attributes
    ----------
    model : str
        As it was given.
    file : str
        What reports call it.
    inputs : tuple of (str, str)
        Name and SHA-256 of the files that were read, meshes too.
    robot : Robot or None
        None where the file describes none.
    findings : tuple of Finding
        The worst first.
    arm : SerialArm or None
        None where there is none, and `arm_note` says why.
    arm_note : str
    laws : ModelValidation or None
        Of the computation on `arm`; None where it was not checked, and `laws_note` says why.
    laws_note : str
    samples, seed : int
        Of the states at which the laws were checked.
    engines : tuple of str
        Keys of those whose import of the file was audited.
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
    engines: tuple[str, ...] = ()

    def at_least(self, level: Level) -> tuple[Finding, ...]:
        """Findings of this severity and worse.

        Parameters
        ----------
        level : {"error", "warning", "note"}

        Returns
        -------
        tuple of Finding
        """
        return tuple(
            f for f in self.findings if SEVERITIES.index(f.severity) <= SEVERITIES.index(level)
        )

    @property
    def failed_laws(self) -> tuple[str, ...]:
        """Ids of the laws that were seen to fail."""
        outcomes = () if self.laws is None else self.laws.outcomes
        return tuple(o.id for o in outcomes if o.about == "algorithm" and not o.passed)

    @property
    def laws_hold(self) -> bool:
        """Whether no law was seen to fail."""
        return not self.failed_laws

    def passed(self, level: Level = "error") -> bool:
        """Whether there is no finding at or above the level, and no law failed.

        Parameters
        ----------
        level : {"error", "warning", "note"}

        Returns
        -------
        bool
        """
        return self.laws_hold and not self.at_least(level)

    def count(self, severity: Severity) -> int:
        """Number of findings of one severity.

        Parameters
        ----------
        severity : {"error", "warning", "note"}

        Returns
        -------
        int
        """
        return sum(finding.severity == severity for finding in self.findings)


def judge(
    model: str | Path,
    *,
    base: str | None = None,
    tip: str | None = None,
    arm: str | None = None,
    hold: Mapping[str, float] | None = None,
    packages: Mapping[str, str | Path] | None = None,
    arguments: Mapping[str, str] | None = None,
    samples: int = 1000,
    seed: int = 0,
    payload: float = 0.0,
    expected_mass: float | None = None,
    meshes: bool = True,
    engines: Sequence[str] = (),
) -> Judgement:
    """Read a model's file whole, apply every rule, and check the computation of its arm.

    Parameters
    ----------
    model : str or path
        A shipped model's name or a path.
    base, tip : str, optional
        Links between which the arm is taken; when None a shipped model's own, else as `load` does.
    arm : str, optional
        A name of the chain in place of `tip`, as `load` takes it.
    hold : mapping of str to float, optional
        Positions [rad] or [m] at which joints beside the arm are held.
    packages : mapping of str to path, optional
        Folders of ROS packages.
    arguments : mapping of str to str, optional
        Values for the arguments of a xacro.
    samples : int
        Number of random states at which the computation is checked, at least 1.
    seed : int
        Of the states, not negative.
    payload : float
        Mass at the tip [kg].
    expected_mass : float, optional
        Of the whole robot [kg].
    meshes : bool
        Whether links are compared with their meshes.
    engines : sequence of str or "all"
        Engines whose import of the whole robot is audited (family ENG).

    Returns
    -------
    Judgement
        `findings` worst first, `passed()`, the `robot`, its `arm`, and the `laws`.

    Raises
    ------
    UsageError
        For a name that means nothing, a file that is not there, or an invalid argument.
    EngineError
        For an engine that was named and is not installed.

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
    asked = engines_asked(engines)
    reading = read_robot(model, packages=packages, arguments=arguments, base=base, tip=tip, arm=arm)
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
            asked,
        )
    chain, arm_note = _arm(reading, hold)
    reader = MeshReader(reading.folder, reading.packages) if meshes else None
    subject = RuleSubject(
        reading.robot, reader, arm=chain, payload=payload, expected_mass=expected_mass
    )
    findings = tuple(check_rules(subject, reading.findings))
    imports = import_findings(reading.robot, asked, findings, seed)
    findings = tuple(worst_first([*findings, *imports]))
    laws, laws_note = _laws(reading.robot, chain, findings, samples, seed)
    return Judgement(
        str(model),
        reading.file,
        (*reading.inputs, *(() if reader is None else reader.inputs.items())),
        reading.robot,
        findings,
        chain,
        arm_note,
        laws,
        laws_note or arm_note,
        samples,
        seed,
        asked,
    )


def _arm(reading: RobotReading, hold: Mapping[str, float] | None) -> tuple[SerialArm | None, str]:
    if reading.arm is not None or reading.robot is None:
        if hold:
            raise UsageError(f"{reading.file} has no joint beside its arm that could be held")
        return reading.arm, ""
    try:
        arm = arm_of_robot(reading.robot, base=reading.base, tip=reading.tip, hold=hold)
    except ModelError as error:
        return None, f"{error.element or 'the robot'} {error.problem}; {error.fix}"
    return arm, ""


def _laws(
    robot: Robot, arm: SerialArm | None, findings: tuple[Finding, ...], samples: int, seed: int
) -> tuple[ModelValidation | None, str]:
    if arm is None:
        return None, ""
    if arm.unknown_tensors:
        return None, "tensors are unknown, so that only gravity torques can be had"
    if robot.depth > DEEPEST:
        return (
            None,
            f"the tree is deeper than {DEEPEST:,} links, which Pinocchio's parser is not for",
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
