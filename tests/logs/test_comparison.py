"""`compare_recording`: the right model passes, and a planted cause is found with its value."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from logs.recorded import DRIVES, Motion, heavier, loaded, motion_of, write
from ur5check import SerialArm, Ur5checkError, compare_recording
from ur5check._comparison.diagnosis.link_numbers import body_of, with_body
from ur5check._logs.comparison import RecordingComparison
from ur5check._logs.friction import FrictionModel
from ur5check._logs.options import RecordingOptions


def compare(arm: SerialArm, motion: Motion, file: Path, **options: object) -> RecordingComparison:
    return compare_recording(arm, write(motion, file), **options)


def test_the_right_model_passes_with_no_cause(arm: SerialArm, motion: Motion, file: Path) -> None:
    found = compare(arm, motion, file)
    assert found.passed
    assert found.named == ()
    assert [finding.rule for finding in found.findings] == ["LOG111"]
    for joint, truth in zip(found.joints, DRIVES, strict=True):
        # Viscous and Coulomb friction, offset, rotor inertia; noise and the form of the transition
        # leave a few per cent.
        assert np.abs(joint.drive.value[[0, 1, 2, 4]] - truth).max() < 0.05 * truth.max()


@pytest.mark.parametrize(
    ("planted", "cause", "joint", "value", "tolerance"),
    [
        ("payload", "payload", 0, [1.0, 0.02, 0.05, 0.1], [0.02, 0.005, 0.005, 0.005]),
        ("missing", "payload", 0, [-0.5, 0.0, 0.03, 0.05], [0.02, 0.01, 0.01, 0.01]),
        ("gain", "gain-of-joint", 2, [1.12], [0.01]),
        ("gains", "gain-of-all", 0, [0.88], [0.01]),
        ("tilt", "gravity-direction", 0, [np.nan, np.nan, np.nan, 6.0], [1, 1, 1, 0.3]),
        ("zero", "joint-zero", 2, [np.radians(5.0)], [np.radians(0.2)]),
        ("quarter", "joint-zero", 2, [np.pi / 2], [np.radians(0.2)]),
        ("sign", "joint-sign", 2, [-1.0], [0.0]),
    ],
)
def test_a_planted_cause_is_named(
    arm: SerialArm,
    file: Path,
    planted: str,
    cause: str,
    joint: int,
    value: list[float],
    tolerance: list[float],
) -> None:
    robot, model = arm, arm
    options: dict[str, Any] = {}
    zero, sign = np.zeros(3), np.ones(3)
    match planted:
        case "payload":
            robot = loaded(arm, 1.0, (0.02, 0.05, 0.1))
        case "missing":
            model = loaded(arm, 0.5, (0.0, 0.03, 0.05))
        case "gain":
            options = {"gains": np.array([1.0, 1.12, 1.0])}
        case "gains":
            options = {"gains": 0.88}
        case "tilt":
            angle = np.radians(6.0)
            options = {"gravity": 9.81 * np.array([np.sin(angle), 0.0, -np.cos(angle)])}
        case "zero":
            zero[1] = np.radians(5.0)
        case "quarter":
            zero[1] = np.pi / 2
        case "sign":
            sign[1] = -1.0
    motion = motion_of(robot, **options)
    motion = Motion(motion.t, (motion.q - zero) * sign, motion.qd * sign, motion.tau * sign)
    found = compare(model, motion, file)
    assert not found.passed
    first = found.named[0]
    assert (first.id, first.joint) == (cause, joint)
    known = ~np.isnan(value)
    assert (np.abs(first.value - value)[known] <= np.array(tolerance)[known]).all()


@pytest.mark.parametrize("rotor", [0.0, 0.3])
def test_a_model_column_is_never_called_measured(arm: SerialArm, file: Path, rotor: float) -> None:
    drives = np.zeros((3, 4))
    drives[:, 3] = rotor
    found = compare(arm, motion_of(arm, drives=drives, noise=1e-5), file)
    assert not found.usable
    assert not found.passed
    assert "LOG131" in {finding.rule for finding in found.findings}


def test_joints_whose_torque_does_not_stand_out_are_not_judged(arm: SerialArm, file: Path) -> None:
    drives = DRIVES.copy()
    motion = motion_of(arm, drives=drives)
    motion.tau[:, 2] += 3.0 * np.sin(7.0 * motion.t)
    found = compare(arm, motion, file)
    assert not found.joints[2].stands_out
    assert [joint.name for joint in found.judged] == ["pan", "lift"]
    assert all(cause.joint != 3 for cause in found.named)


def test_gains_from_current_and_the_controllers_torque(arm: SerialArm, tmp_path: Path) -> None:
    gains = np.array([10.0, 12.0, 8.0])
    measured = motion_of(arm)
    computed = motion_of(arm, drives=np.zeros((3, 4)), noise=0.0)
    table = np.column_stack(
        [measured.t, measured.q, measured.qd, measured.tau / gains, 0.0 * measured.q, computed.tau]
    )
    np.savetxt(tmp_path / "run.csv", table, delimiter=",")
    with pytest.raises(Ur5checkError, match="--gains"):
        compare_recording(arm, tmp_path / "run.csv")
    found = compare_recording(
        arm, tmp_path / "run.csv", options=RecordingOptions(gains=tuple(gains.tolist()))
    )
    assert found.passed
    values = np.array([gain.value for gain in found.gains])
    assert np.abs(values / gains - 1.0).max() < 0.02
    wrong = RecordingOptions(gains=tuple((1.12 * gains).tolist()))
    assert "LOG132" in {
        finding.rule
        for finding in compare_recording(arm, tmp_path / "run.csv", options=wrong).findings
    }
    assert "LOG132" not in {finding.rule for finding in found.findings}


def test_friction_terms_that_are_asked_for(arm: SerialArm, motion: Motion, file: Path) -> None:
    friction = FrictionModel(stribeck=True, asymmetric=True)
    found = compare(arm, motion, file, friction=friction)
    names = ("viscous", "coulomb+", "coulomb-", "stribeck", "offset", "transition", "rotor")
    assert friction.names == names
    assert all(len(joint.drive.value) == len(names) for joint in found.joints)
    assert found.passed


def test_a_late_velocity_is_not_used(arm: SerialArm, motion: Motion, file: Path) -> None:
    late = motion.qd.copy()
    late[18:] = motion.qd[:-18]
    found = compare(arm, Motion(motion.t, motion.q, late, motion.tau), file)
    assert "LOG123" in {finding.rule for finding in found.findings}
    assert found.signals.velocity_from_position
    assert found.passed


def test_a_wrong_link_fails(arm: SerialArm, motion: Motion, file: Path) -> None:
    assert not compare(heavier(arm, 1, 1.3), motion, file).passed


def test_a_recording_without_torque_is_refused(
    arm: SerialArm, motion: Motion, tmp_path: Path
) -> None:
    np.savetxt(tmp_path / "run.csv", motion.table()[:, :7], delimiter=",")
    with pytest.raises(Ur5checkError, match="torque"):
        compare_recording(arm, tmp_path / "run.csv", options=RecordingOptions(columns="t,q,qd"))


@pytest.mark.parametrize("link", [1, 2])
def test_a_wrong_mass_is_named_as_its_links_not_as_a_gain(
    arm: SerialArm, motion: Motion, file: Path, link: int
) -> None:
    wrong = heavier(arm, link, 1.4)
    found = compare(wrong, motion, file)
    first = found.named[0]
    assert (first.id, first.joint) == ("link-mass", link + 1)
    truth = arm.links[link].inertia.mass
    assert abs(first.value[0] - truth) < 0.05 * truth
    assert "gain-of-all" not in {cause.id for cause in found.named}


@pytest.mark.parametrize(
    ("mistake", "link"), [("centre-sign", 1), ("tensor-about-origin", 1), ("length-sign", 1)]
)
def test_a_planted_mistake_is_named(
    arm: SerialArm, motion: Motion, file: Path, mistake: str, link: int
) -> None:
    body = body_of(arm, link)
    match mistake:
        case "centre-sign":
            value = replace(body, com=body.com * np.array([1.0, -1.0, 1.0]))
        case "tensor-about-origin":
            value = replace(body, tensor=body.tensor + 4.0 * body.steiner)
        case "length-sign":
            value = replace(body, offset=-body.offset)
    found = compare(with_body(arm, link, value), motion, file)
    assert not found.passed
    if mistake == "tensor-about-origin":  # four times too much is no known mistake
        assert found.named[0].id == "link-tensor"
        value = replace(body, tensor=body.tensor + body.steiner)
        found = compare(with_body(arm, link, value), motion, file)
        first = next(cause for cause in found.causes if cause.id == "mistake")
    else:
        first = found.named[0]
    assert (first.id, first.mistake, first.joint) == ("mistake", mistake, link + 1)


def test_at_the_floor_a_clear_cause_is_a_remark(arm: SerialArm, motion: Motion, file: Path) -> None:
    found = compare(heavier(arm, 1, 1.005), motion, file)
    assert found.passed
    assert found.named == ()
    assert found.remarks
    assert not compare(arm, motion, file).remarks
