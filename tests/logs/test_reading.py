"""Tables are read as what they are: headers of several tools, none at all, one file or several."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pyarrow
import pyarrow.parquet
import pytest

from logs.recorded import Motion, write
from ur5check import Ur5checkError
from ur5check._logs.options import RecordingOptions, options_from_toml
from ur5check._logs.reading import read_recording
from ur5check._logs.recording import Recording

JOINTS = ("pan", "lift", "roll")


def header(time: str, *patterns: str, start: int = 0, names: bool = False) -> str:
    keys = JOINTS if names else range(start, start + 3)
    return ",".join([time, *(pattern.format(key) for pattern in patterns for key in keys)])


def same(recording: Recording, motion: Motion) -> None:
    assert np.abs(recording.t - motion.t).max() < 1e-6
    for name in ("q", "qd", "tau"):
        found, truth = getattr(recording, name), getattr(motion, name)
        assert np.abs(found - truth).max() < 1e-6


@pytest.mark.parametrize(
    "line",
    [
        header("timestamp", "actual_q_{}", "actual_qd_{}", "actual_current_{}").replace(
            "current", "torque"
        ),  # RTDE
        header("time", "q[{}]", "dq[{}]", "tau_J[{}]"),  # libfranka
        header(
            "__time", "/joint_states/{}/position", "/joint_states/{}/velocity",
            "/joint_states/{}/effort", names=True,
        ),  # PlotJuggler
        header("t", "position_{}", "velocity_{}", "effort_{}", names=True),  # JointState
        header("t", "{}.position", "{}.velocity", "{}.effort", names=True),
        header("t", "q{}", "qd{}", "tau{}", start=1),
    ],
)  # fmt: skip
def test_headers_of_known_tools_are_understood(motion: Motion, file: Path, line: str) -> None:
    recording, _ = read_recording(write(motion, file, line), JOINTS)
    same(recording, motion)


def test_joints_match_by_name_in_any_order_and_by_suffix(motion: Motion, file: Path) -> None:
    line = header("t", "{}.position", "{}.velocity", "{}.effort", names=True)
    for old, new in (("pan", "arm_lift"), ("lift", "arm_pan")):
        line = ",".join(
            new + cell.removeprefix(old) if cell.startswith(f"{old}.") else cell
            for cell in line.split(",")
        )
    recording, findings = read_recording(write(motion, file, line), JOINTS)
    assert np.abs(recording.q[:, 0] - motion.q[:, 1]).max() < 1e-6
    assert np.abs(recording.q[:, 1] - motion.q[:, 0]).max() < 1e-6
    assert findings == ()


def test_joints_of_another_robot_are_refused(motion: Motion, file: Path) -> None:
    line = header("t", "{}.position", "{}.velocity", "{}.effort", names=True)
    write(motion, file, line.replace("lift", "elbow"))
    with pytest.raises(Ur5checkError, match="lift"):
        read_recording(file, JOINTS)
    recording, findings = read_recording(file, JOINTS, RecordingOptions(by_order=True))
    same(recording, motion)
    assert [finding.rule for finding in findings] == ["LOG111"]


def test_without_a_header_blocks_are_taken_in_order_and_said(motion: Motion, file: Path) -> None:
    recording, findings = read_recording(write(motion, file), JOINTS)
    same(recording, motion)
    assert [finding.rule for finding in findings] == ["LOG111"]


@pytest.mark.parametrize(("width", "blocks"), [(31, 5), (19, 3)])
def test_columns_of_six_joints_without_a_header(tmp_path: Path, width: int, blocks: int) -> None:
    rng = np.random.default_rng(2)
    table = rng.normal(size=(100, width))
    table[:, 0] = 0.01 * np.arange(100)
    file = tmp_path / "run.txt"
    np.savetxt(file, table)
    recording, _ = read_recording(file, tuple("abcdef"))
    assert np.array_equal(recording.q, table[:, 1:7])
    assert np.array_equal(recording.qd, table[:, 7:13])
    if blocks == 5:
        assert recording.tau is None
        assert np.array_equal(recording.current, table[:, 13:19])
        assert np.array_equal(recording.model_tau, table[:, 25:31])
    else:
        assert np.array_equal(recording.tau, table[:, 13:19])


def test_a_width_that_fits_no_joints_is_refused(tmp_path: Path) -> None:
    np.savetxt(tmp_path / "run.csv", np.ones((50, 12)), delimiter=",")
    with pytest.raises(Ur5checkError, match="12 columns"):
        read_recording(tmp_path / "run.csv", JOINTS)


def test_three_files_of_the_same_rows(motion: Motion, tmp_path: Path) -> None:
    files = []
    for word, values in (("position", motion.q), ("velocity", motion.qd), ("effort", motion.tau)):
        file = tmp_path / f"run_{word}.csv"
        np.savetxt(file, np.column_stack([motion.t, values]), delimiter=",", fmt="%.9g",
                   header="time,pan,lift,roll", comments="")  # fmt: skip
        files.append(file)
    recording, _ = read_recording(files, JOINTS)
    same(recording, motion)
    assert len(recording.inputs) == 3
    files[1].write_text("".join(files[1].read_text().splitlines(keepends=True)[:-5]))
    with pytest.raises(Ur5checkError, match="same rows"):
        read_recording(files, JOINTS)


def test_parquet(motion: Motion, tmp_path: Path) -> None:
    file = tmp_path / "run.parquet"
    names = header("t", "{}.position", "{}.velocity", "{}.effort", names=True).split(",")
    columns = dict(zip(names, motion.table().T, strict=True))
    pyarrow.parquet.write_table(pyarrow.table(columns), file)
    recording, findings = read_recording(file, JOINTS)
    same(recording, motion)
    assert findings == ()


def test_a_cut_line_is_left_out_and_said(motion: Motion, file: Path) -> None:
    write(motion, file, header("t", "q{}", "qd{}", "tau{}"))
    lines = file.read_text().splitlines()
    lines[-1] = ",".join(lines[-1].split(",")[:4])
    file.write_text("\n".join(lines))
    recording, findings = read_recording(file, JOINTS)
    assert recording.count == len(motion.t) - 1
    found = next(finding for finding in findings if finding.rule == "LOG103")
    assert found.places[0].line == len(lines)


def test_columns_by_pattern(motion: Motion, file: Path) -> None:
    write(motion, file, header("clock", "a{}", "b{}", "c{}", start=1))
    with pytest.raises(Ur5checkError, match="positions"):
        read_recording(file, JOINTS)
    known = RecordingOptions(columns="t=clock q=a{i} qd=b{i} tau=c{i}")
    same(read_recording(file, JOINTS, known)[0], motion)
    for wrong, said in (("t=clock q=d{i}", "d1"), ("t=clock torque=c{i}", "torque")):
        with pytest.raises(Ur5checkError, match=said):
            read_recording(file, JOINTS, RecordingOptions(columns=wrong))


def test_units_gains_offsets_and_gears(motion: Motion, file: Path) -> None:
    gains, offsets = (2.0, -0.5, 4.0), (0.1, 0.0, -0.2)
    G = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.5, 1.0))
    inverse = np.linalg.inv(G)
    # In the order of reading: degrees, gains, offsets, gears.
    q = np.degrees(motion.q @ inverse.T + np.array(offsets))
    qd = np.degrees(motion.qd @ inverse.T)
    tau = motion.tau @ np.array(G) / np.array(gains)
    write(Motion(motion.t, q, qd, tau), file)
    options = RecordingOptions(degrees=True, gains=gains, offsets=offsets, coupling=G)
    recording, _ = read_recording(file, JOINTS, options)
    same(recording, motion)
    # Power is the same on both sides of the gears.
    assert np.allclose(
        (recording.qd * recording.tau).sum(axis=1),
        (np.radians(qd) * tau * np.array(gains)).sum(axis=1),
        atol=1e-6,
    )


@pytest.mark.parametrize(
    "options",
    [
        RecordingOptions(gains=(1.0, 2.0)),
        RecordingOptions(offsets=(1.0,)),
        RecordingOptions(coupling=((1.0, 0.0), (0.0, 1.0))),
        RecordingOptions(coupling=((1.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))),
        RecordingOptions(columns="t,q,qd"),
        RecordingOptions(columns="t,q,qd,torque"),
    ],
)
def test_options_that_do_not_fit_are_refused(
    motion: Motion, file: Path, options: RecordingOptions
) -> None:
    with pytest.raises(Ur5checkError):
        read_recording(write(motion, file), JOINTS, options)


def test_without_a_clock_the_rate_is_asked_for(motion: Motion, file: Path) -> None:
    np.savetxt(file, motion.table()[:, 1:], delimiter=",", fmt="%.9g",
               header=header("t", "q{}", "qd{}", "tau{}")[2:], comments="")  # fmt: skip
    with pytest.raises(Ur5checkError, match="--rate"):
        read_recording(file, JOINTS)
    same(read_recording(file, JOINTS, RecordingOptions(rate=100.0))[0], motion)


def test_options_from_toml(tmp_path: Path) -> None:
    file = tmp_path / "run.toml"
    file.write_text(
        'columns = "t,q,qd,tau"\ndegrees = true\ngains = [1, 2.5, -1]\nrate = 125\n'
        "coupling = [[1, 0], [0.5, 1]]\n"
    )
    assert options_from_toml(file) == RecordingOptions(
        columns="t,q,qd,tau", degrees=True, gains=(1.0, 2.5, -1.0), rate=125.0,
        coupling=((1.0, 0.0), (0.5, 1.0)),
    )  # fmt: skip


@pytest.mark.parametrize("line", ["gain = 1", 'gains = "1"', "degrees = 1", "rate = true", "="])
def test_a_wrong_key_or_type_is_refused(tmp_path: Path, line: str) -> None:
    file = tmp_path / "run.toml"
    file.write_text(line)
    with pytest.raises(Ur5checkError, match=r"run\.toml"):
        options_from_toml(file)


def test_files_that_are_no_recording_are_refused(tmp_path: Path) -> None:
    picture = tmp_path / "run.csv"
    picture.write_bytes(b"\x89PNG\r\n\xff\xfe")
    empty = tmp_path / "empty.csv"
    empty.write_text("")
    other = tmp_path / "run.png"
    other.write_text("1,2")
    for file in (picture, empty, other, tmp_path / "none.csv"):
        with pytest.raises(Ur5checkError, match=file.name):
            read_recording(file, JOINTS)
