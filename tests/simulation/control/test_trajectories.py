"""Trajectories are what they say: their velocities and accelerations are derivatives."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from ur5check._errors import StateError, UsageError
from ur5check._robot.states import MAX_ACCELERATION
from ur5check._simulation.control.fourier import FourierSeries, excitation
from ur5check._simulation.control.sampled_trajectory import read_trajectory
from ur5check._simulation.control.trajectory import Quintic

APPENDIX = ur5check.load("appendix")
QUINTIC = Quintic(np.array([0.0, 1.0, -1.0]), np.array([1.0, -1.0, -1.0]), 2.0)


def assert_consistent(trajectory, *, margin=1e-3, slope=1e-5):
    """Central differences of q are q̇, of q̇ are q̈."""
    h, t = 1e-5, np.linspace(margin, trajectory.duration - margin, 57)
    ahead, here, behind = (trajectory.at(t + step) for step in (h, 0.0, -h))
    np.testing.assert_allclose((ahead.q - behind.q) / (2 * h), here.qd, atol=slope)
    np.testing.assert_allclose((ahead.qd - behind.qd) / (2 * h), here.qdd, atol=slope)


# --- quintic -------------------------------------------------------------------------------------


def test_a_quintic_goes_from_rest_to_rest():
    ends = QUINTIC.at([0.0, 2.0])
    np.testing.assert_allclose(ends.q, [QUINTIC.start, QUINTIC.goal])
    assert not np.any(ends.qd)
    assert not np.any(ends.qdd)
    assert_consistent(QUINTIC)


def test_a_quintic_rests_before_and_after():
    for t, q in ((-1.0, QUINTIC.start), (5.0, QUINTIC.goal)):
        np.testing.assert_array_equal(QUINTIC.at(t).q, q)
        assert not np.any(QUINTIC.at(t).qdd)


@pytest.mark.parametrize(
    ("ends", "said"),
    [
        ((np.zeros(2), np.zeros(3), 1.0), r"shape \(2,\) and goal \(3,\)"),
        ((np.zeros(2), np.array([0.0, np.inf]), 1.0), "finite"),
        ((np.zeros(2), np.zeros(2), 0.0), "positive time, not 0 s"),
    ],
)
def test_quintics_without_meaning_are_refused(ends, said):
    with pytest.raises(UsageError, match=said):
        Quintic(*ends)


# --- Fourier series ------------------------------------------------------------------------------


def test_an_excitation_starts_and_ends_at_rest_and_is_periodic():
    series = excitation(APPENDIX, seed=3)
    ends = series.at([0.0, series.duration])
    np.testing.assert_allclose(ends.q[0], ends.q[1], atol=1e-12)
    np.testing.assert_allclose(ends.qd, 0.0, atol=1e-12)
    np.testing.assert_allclose(ends.qdd, 0.0, atol=1e-12)
    assert_consistent(series)


@pytest.mark.parametrize("seed", range(4))
def test_an_excitation_stays_within_the_limits_and_uses_them(seed):
    way = excitation(APPENDIX, seed=seed).at(np.linspace(0.0, 10.0, 4001))
    limits = [joint.limits for joint in APPENDIX.joints]
    lower, upper = (np.array([getattr(x, end) for x in limits]) for end in ("lower", "upper"))
    speed = np.array([x.velocity for x in limits])
    assert (way.q >= lower).all()
    assert (way.q <= upper).all()
    used = np.array(
        [
            np.ptp(way.q, axis=0) / (upper - lower),
            np.abs(way.qd).max(axis=0) / speed,
            np.abs(way.qdd).max(axis=0) / MAX_ACCELERATION,
        ]
    )
    assert used.max() <= 1.0
    assert (used.max(axis=0) > 0.95).all()


def test_an_excitation_comes_from_its_seed():
    a, b, c = (excitation(APPENDIX, seed=seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(a.a, b.a)
    assert np.abs(a.a - c.a).max() > 0.1


def test_an_excitation_shows_every_parameter_that_torque_can_show():
    way = excitation(APPENDIX, seed=0).at(np.linspace(0.0, 10.0, 200))
    Y = ur5check.torque_regressor(APPENDIX, way.q, way.qd, way.qdd).reshape(-1, 60)
    assert np.linalg.matrix_rank(Y, tol=1e-6) == 36


def test_series_without_meaning_are_refused():
    with pytest.raises(UsageError, match="at least 2 harmonics"):
        excitation(APPENDIX, harmonics=1)
    with pytest.raises(UsageError, match="seed must not be negative"):
        excitation(APPENDIX, seed=-1)
    with pytest.raises(UsageError, match="one row a joint"):
        FourierSeries(np.zeros(2), np.zeros((3, 4)), np.zeros((3, 4)), 1.0)


# --- from a file ---------------------------------------------------------------------------------


def table(rows=21, *, rates=True, named=False):
    """The quintic's six-joint sister, as columns."""
    quintic = Quintic(np.zeros(6), np.linspace(-1.0, 1.0, 6), 2.0)
    t = np.linspace(0.0, 2.0, rows)
    way = quintic.at(t)
    columns = {"t": t}
    for part in ("q", "qd", "qdd") if rates else ("q",):
        for i, joint in enumerate(APPENDIX.joint_names):
            columns[f"{part}_{joint}" if named else f"{part}{i + 1}"] = getattr(way, part)[:, i]
    return quintic, columns


def write_csv(path, columns):
    rows = zip(*columns.values(), strict=True)
    lines = [",".join(columns), *(",".join(map(repr, map(float, row))) for row in rows)]
    path.write_text("\n".join(lines) + "\n")
    return path


def write_parquet(path, columns):
    import pyarrow
    from pyarrow import parquet

    parquet.write_table(pyarrow.table(columns), path)
    return path


WRITERS = {"csv": write_csv, "parquet": write_parquet}


@pytest.mark.parametrize("suffix", WRITERS)
@pytest.mark.parametrize("named", [False, True], ids=["numbered", "named"])
def test_a_file_with_rates_is_followed_between_its_rows(tmp_path, suffix, named):
    quintic, columns = table(named=named)
    read = read_trajectory(WRITERS[suffix](tmp_path / f"way.{suffix}", columns), APPENDIX)
    assert (read.n, read.duration) == (6, 2.0)
    assert len(read.sha256) == 64
    t = np.linspace(0.0, 2.0, 173)
    # Quintic pieces meet a quintic exactly.
    np.testing.assert_allclose(read.at(t).q, quintic.at(t).q, atol=1e-12)
    np.testing.assert_allclose(read.at(t).qdd, quintic.at(t).qdd, atol=1e-9)
    assert_consistent(read)


def test_positions_alone_are_joined_by_a_smooth_spline(tmp_path):
    quintic, columns = table(rates=False)
    read = read_trajectory(write_csv(tmp_path / "way.csv", columns), APPENDIX)
    t = np.linspace(0.0, 2.0, 173)
    np.testing.assert_allclose(read.at(t).q, quintic.at(t).q, atol=1e-12)
    assert_consistent(read)
    assert not np.any(read.at(3.0).qd)


def test_time_may_begin_anywhere(tmp_path):
    _, columns = table()
    columns["t"] = columns["t"] + 1.7e9
    read = read_trajectory(write_csv(tmp_path / "way.csv", columns), APPENDIX)
    np.testing.assert_allclose(read.at(0.0).q, columns["q1"][0], atol=1e-12)


def spoilt(change):
    _, columns = table()
    change(columns)
    return columns


def set_value(column, row, value):
    def change(columns):
        columns[column] = columns[column].copy()
        columns[column][row] = value

    return change


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (set_value("q3", 4, np.nan), r"column 'q3' is no finite number \(got (nan|'nan')\)"),
        (set_value("t", 4, 0.0), "row 5: column 't' is 0 after 0.3; times must increase"),
        (lambda c: c.pop("t"), "no column 't'"),
        (lambda c: c.pop("q6"), "no column 'q6'"),
        (lambda c: [c.pop(f"qdd{i}") for i in range(1, 7)], "columns of qd alone"),
        (lambda c: c.update(q_elbow_joint=c["q3"]), "'q3' and 'q_elbow_joint' are the same"),
        (lambda c: c.update({k: v[:1] for k, v in c.items()}), "has 1 rows"),
    ],
)
@pytest.mark.parametrize("suffix", WRITERS)
def test_a_wrong_file_is_refused(tmp_path, suffix, change, said):
    file = WRITERS[suffix](tmp_path / f"way.{suffix}", spoilt(change))
    with pytest.raises(StateError, match=said) as caught:
        read_trajectory(file, APPENDIX)
    assert str(file) in str(caught.value)


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("way.csv", "t,q1\n0,1\n1,abc\n", r"way.csv:3: column 'q1' is no finite.*\(got 'abc'\)"),
        ("way.csv", "t,q1\n0,1,2\n", "way.csv:2: has 3 columns where the header has 2"),
        ("way.csv", "t,t\n0,1\n", "two columns are called 't'"),
        ("way.csv", "t,q1\n", "holds no row"),
        ("way.csv", "", "holds no row"),
        ("way.csv", b"t,q1\n\xff\xfe", "is no text"),
        ("way.parquet", "t,q1\n0,1\n", "is no Parquet file"),
        ("way.txt", "t,q1\n0,1\n", "give a .csv or a .parquet"),
    ],
)
def test_what_is_no_table_is_refused(tmp_path, name, text, said):
    file = tmp_path / name
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(StateError, match=said):
        read_trajectory(file, APPENDIX)


def test_a_missing_file_is_said(tmp_path):
    with pytest.raises(StateError, match="there is no such file"):
        read_trajectory(tmp_path / "way.csv", APPENDIX)


def test_a_column_of_words_is_refused(tmp_path):
    _, columns = table()
    file = write_parquet(tmp_path / "way.parquet", {**columns, "q2": ["up"] * 21})
    with pytest.raises(StateError, match="column 'q2' holds string; it must hold numbers"):
        read_trajectory(file, APPENDIX)
