"""`compare_recording`: how well a model explains what a robot measured, and what would help."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from .._arguments import instance, number
from .._errors import UsageError
from .._finding import Finding, Place
from .._result import Result
from .._robot.as_arm import ArmSource, as_arm
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .._rules.finding_log import FindingLog
from .cause import Cause
from .causes import causes_of, named_causes
from .channel_checks import check_channels, velocity_is_late
from .drive_gains import DriveGain, drive_gains
from .friction import FrictionModel
from .joint_residuals import Floor, JointResidual, floor_of, joint_residuals, model_torque
from .load_difference import load_difference
from .model_column import is_a_model
from .normal_equations import NormalEquations
from .options import RecordingOptions
from .parameters import BaseParameter, base_parameters
from .point_mass import PointMass
from .reading import read_recording
from .recording import Recording
from .rivals import Rival, rival_of
from .row_checks import kept_rows
from .signals import Signals, choose_cutoff, filtered
from .transition_speed import transition_speeds
from .validation import Validation, validated
from .weighted_problem import WeightedProblem

__all__ = ["AT_FLOOR", "GAIN_KNOWN", "RecordingComparison", "compare_recording"]

Files = str | Path | Sequence[str | Path]

#: A joint's residual is at the floor below this ratio to it.  On five recordings of three arms the
#: right model, with friction and rotor inertia, stood 3 to 15 % above; 25 % allows for the
#: friction that no formula has.
AT_FLOOR = 1.25

#: … and so it is where what stands above the floor is below this part of the model's torque: no
#: better are drive gains known, and a wrong gain leaves as much.
GAIN_KNOWN = 0.03

#: Gains that a recording shows and gains that were given may differ by this much.
_SAME_GAIN = 0.02


@dataclass(frozen=True, eq=False)
class RecordingComparison(Result):
    """A model against a recording.

    Attributes
    ----------
    arm : SerialArm
        The model.
    recording : Recording
        Its clean rows.
    signals : Signals
        The recording, filtered.
    friction : FrictionModel
        The terms of each drive.
    model : ndarray, shape (N, n)
        The model's torque at the signals, without motor inertia [N m or N].
    joints : tuple of JointResidual, length n
        What the model leaves, joint by joint.
    floor : Floor
        What the best parameters leave.
    causes : tuple of Cause
        Single causes, the likeliest first.
    parameters : tuple of BaseParameter
        What the recording says about each base parameter.
    normal : NormalEquations
        What the recording says about all parameters.
    gains : tuple of DriveGain
        From current and the controller's torque; () where the file has not both.
    findings : tuple of Finding
        What is wrong with the recording.
    rows : int
        Of the file, before any was left out.
    usable : bool
        Whether the torques are measured ones that can judge a model.
    load : PointMass or None
        Carried in this recording and not in the unloaded one; None without one.
    validation : Validation or None
        The fit tried on another recording; None without one.
    rivals : tuple of Rival
        The other models on the same samples.
    """

    arm: SerialArm
    recording: Recording
    signals: Signals
    friction: FrictionModel
    model: Array
    joints: tuple[JointResidual, ...]
    floor: Floor
    causes: tuple[Cause, ...]
    parameters: tuple[BaseParameter, ...]
    normal: NormalEquations
    gains: tuple[DriveGain, ...]
    findings: tuple[Finding, ...]
    rows: int
    usable: bool
    load: PointMass | None = None
    validation: Validation | None = None
    rivals: tuple[Rival, ...] = ()

    @property
    def judged(self) -> tuple[JointResidual, ...]:
        """Joints whose model torque stands out; no statement is made of the others."""
        return tuple(joint for joint in self.joints if joint.stands_out)

    @property
    def at_floor(self) -> bool:
        """Whether no judged joint stands clearly above the floor.

        Clearly: by more than `AT_FLOOR` allows, and by more than an error of the drive's gain of
        `GAIN_KNOWN`.
        """
        return all(
            joint.above_floor <= AT_FLOOR or joint.excess <= GAIN_KNOWN * joint.model
            for joint in self.judged
        )

    @property
    def named(self) -> tuple[Cause, ...]:
        """Causes of what stands above the floor: the likeliest, and those not ruled out by it.

        () at the floor, or where no cause has evidence enough.
        """
        return () if self.at_floor else named_causes(self.causes)

    @property
    def remarks(self) -> tuple[Cause, ...]:
        """At the floor: causes that are clear all the same, smaller than the floor's margin."""
        return named_causes(self.causes) if self.at_floor else ()

    @property
    def passed(self) -> bool:
        """Whether the recording can judge the model, and the model explains it."""
        return self.usable and bool(self.judged) and self.at_floor


def compare_recording(
    model: ArmSource,
    files: Files,
    *,
    options: RecordingOptions | None = None,
    cutoff: float | None = None,
    friction: FrictionModel | None = None,
    unloaded: Files | None = None,
    validate: Files | None = None,
    others: Sequence[ArmSource] = (),
) -> RecordingComparison:
    """Compare a model with a recording of the robot.

    Parameters
    ----------
    model : name, path, pin.Model or SerialArm
        See `load`.
    files : path, or sequence of paths
        A ROS bag with joint states, or tables (CSV, Parquet); see `RecordingOptions`.
    options : RecordingOptions, optional
        What the files do not say: columns, units, gains.
    cutoff : float, optional
        Of the low-pass [Hz]; chosen from the motion's spectrum when None.
    friction : FrictionModel, optional
        Terms of each drive; viscous and Coulomb friction, an offset and rotor inertia when None.

    unloaded : path, or sequence of paths, optional
        A recording of the same robot without its load: `load` is then what it carried.
    validate : path, or sequence of paths, optional
        Another recording of the robot, on which the fit is tried.
    others : sequence of models, optional
        Compared with the first on the same samples.

    Returns
    -------
    comparison : RecordingComparison

    Raises
    ------
    UsageError
        For files that cannot be read or hold no torque, and options that do not fit.

    Examples
    --------
    A robot that moves as the model says, with friction and noise:

    >>> import tempfile
    >>> from pathlib import Path
    >>> import numpy as np
    >>> import ur5check
    >>> t = np.arange(0.0, 20.0, 0.01)[:, None]
    >>> w = np.array([0.9, 1.1, 1.3, 1.6, 1.9, 2.3])  # [rad/s], one a joint
    >>> q, qd, qdd = np.sin(w * t), w * np.cos(w * t), -(w**2) * np.sin(w * t)
    >>> noise = np.random.default_rng(0).normal(0.0, 0.1, q.shape)
    >>> tau = ur5check.rnea("erd-ur5", q, qd, qdd) + 2.0 * qd + 3.0 * np.tanh(qd / 0.02) + noise
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder) / "motion.csv"
    ...     np.savetxt(file, np.hstack([t, q, qd, tau]), delimiter=",")
    ...     options = ur5check.RecordingOptions(columns="t,q,qd,tau")
    ...     found = ur5check.compare_recording("erd-ur5", file, options=options)
    >>> found.passed
    True
    """
    arm = as_arm(model)
    friction = FrictionModel() if friction is None else friction
    options = RecordingOptions() if options is None else options
    instance("friction", friction, FrictionModel, "see ur5check.FrictionModel")
    instance("options", options, RecordingOptions, "see ur5check.RecordingOptions")
    log = FindingLog()
    raw, clean, late = _clean(files, arm, options, log)
    if clean.tau is None:
        raise UsageError(_no_torque(clean, friction, late))
    chosen = choose_cutoff(clean) if cutoff is None else number("cutoff", cutoff, positive=True)
    v0 = transition_speeds(arm, clean, chosen, friction, velocity_from_position=late)
    signals = filtered(clean, chosen, friction, v0=v0, velocity_from_position=late)

    def signals_of(more: Files) -> Signals:
        _, other, other_late = _clean(more, arm, options, log)
        if other.tau is None:
            raise UsageError(_no_torque(other, friction, other_late))
        return filtered(other, chosen, friction, v0=v0, velocity_from_position=other_late)

    torque = model_torque(arm, signals)
    floor = floor_of(arm, signals)
    joints = joint_residuals(arm, signals, torque, friction, floor)
    usable = not is_a_model(joints)
    if not usable:
        log.add(
            "LOG131",
            "torques",
            "follow a rigid model and show no friction: they are computed, not measured",
            Place(clean.file),
            value=max(joint.floor / joint.measured for joint in joints if joint.stands_out),
            bound=0.01,
        )
    problem = WeightedProblem.of(arm, signals, floor.sizes)
    causes = causes_of(problem, [k for k, joint in enumerate(joints) if joint.stands_out])
    gains = _gains(clean, chosen, late, friction)
    _check_gains(gains, options.gains, clean.file, log)
    return RecordingComparison(
        arm, clean, signals, friction, torque, joints, floor,
        causes, base_parameters(problem), problem.normal, gains, tuple(log.findings), raw.count,
        usable,
        None
        if unloaded is None
        else load_difference(arm, signals, signals_of(unloaded), floor.sizes),
        None
        if validate is None
        else validated(arm, _name(validate), signals_of(validate), joints, floor),
        tuple(_rival(other, signals, friction, joints) for other in others),
    )  # fmt: skip


def _clean(
    files: Files, arm: SerialArm, options: RecordingOptions, log: FindingLog
) -> tuple[Recording, Recording, bool]:
    """A recording as it is and with its good rows, and whether its velocity must not be used."""
    raw, findings = read_recording(files, arm.joint_names, options)
    log.findings.extend(findings)
    clean = kept_rows(raw, log)
    check_channels(clean, log)
    return raw, clean, velocity_is_late(clean, log)


def _name(files: Files) -> str:
    return str(files) if isinstance(files, str | Path) else ", ".join(map(str, files))


def _rival(
    other: ArmSource, signals: Signals, friction: FrictionModel, first: tuple[JointResidual, ...]
) -> Rival:
    """Raises UsageError for a model with another number of joints."""
    arm = as_arm(other)
    if arm.n != len(first):
        raise UsageError(f"{arm.label} has {arm.n} joints, the first model {len(first)}")
    floor = floor_of(arm, signals)
    joints = joint_residuals(arm, signals, model_torque(arm, signals), friction, floor)
    return rival_of(arm.label, signals, first, joints)


def _gains(
    recording: Recording, cutoff: float, late: bool, friction: FrictionModel
) -> tuple[DriveGain, ...]:
    if recording.current is None or recording.model_tau is None:
        return ()
    torque = filtered(recording, cutoff, friction, velocity_from_position=late)
    current = filtered(
        replace(recording, tau=recording.current), cutoff, friction, velocity_from_position=late
    )
    return drive_gains(recording, torque, current.tau)


def _check_gains(
    gains: tuple[DriveGain, ...], given: tuple[float, ...], file: str, log: FindingLog
) -> None:
    """Gains that were given, against those that the file itself shows."""
    for k, gain in enumerate(gains):
        own = given[k % len(given)] if given else float("nan")
        # nan, where there is no statement, compares as false.
        if abs(own / gain.value - 1.0) > max(_SAME_GAIN, gain.half_width / abs(gain.value)):
            log.add(
                "LOG132",
                f"joint {gain.joint!r}",
                f"its gain {own:.4g} N m/A is {own / gain.value:.3g} times what current and the "
                f"controller's torque show: {gain.value:.4g} ± {gain.half_width:.2g}",
                Place(file),
                value=own,
                bound=gain.value,
                unit="N m/A",
            )


def _no_torque(recording: Recording, friction: FrictionModel, late: bool) -> str:
    """Why there is no torque to compare with, and the gains that the file itself shows."""
    if recording.current is None:
        return f"{recording.file}: no column of measured torques; say which: --columns"
    as_torque = replace(recording, tau=recording.current)
    gains = _gains(as_torque, choose_cutoff(recording), late, friction)
    hint = ""
    if gains:
        known = ",".join(f"{gain.value:.4g}" for gain in gains)
        hint = f"; against the controller's torque they are {known}"
    return (
        f"{recording.file}: has currents and no measured torque: give the drives' gains [N m/A] "
        f"as --gains{hint}"
    )
