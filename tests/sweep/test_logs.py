"""States from a log: read exactly, by any block, and refused by file, line, column and value."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet

from ur5check._errors import StateError, UsageError
from ur5check._robot.states import States, random_states
from ur5check._sweep.checkpoint import statistics_value
from ur5check._sweep.csv_log import open_csv
from ur5check._sweep.state_log import log_sample
from ur5check._sweep.state_sample import BLOCK, blocks_of
from ur5check._sweep.sweep import sweep

ROWS = BLOCK + 77
NUMBERED = [f"{part}{i}" for part in ("q", "qd", "qdd") for i in range(1, 7)]


@pytest.fixture(scope="module")
def states() -> States:
    return random_states(6, ROWS, 4)


@pytest.fixture(scope="module")
def folder(tmp_path_factory, states, paper) -> Path:
    """The same states four times: CSV and Parquet, by number and by name, with other columns."""
    place = tmp_path_factory.mktemp("logs")
    table = np.hstack([np.arange(ROWS)[:, None] / 125, states.q, states.qd, states.qdd])
    header = ",".join(["time", *NUMBERED])
    np.savetxt(place / "run.csv", table, "%.17g", ",", header=header, comments="")
    named = [f"{part}_{name}" for part in ("q", "qd", "qdd") for name in paper.joint_names]
    order = [18, *range(18)]
    columns = {"time": table[:, 0], **dict(zip(named, table[:, 1:].T, strict=True))}
    shuffled = pa.table({list(columns)[k]: list(columns.values())[k] for k in order})
    parquet.write_table(shuffled, place / "run.parquet", row_group_size=5000)
    return place


def read(log) -> States:
    blocks = [log.block(k) for k in reversed(range(blocks_of(log)))][::-1]
    return States(*(np.concatenate([getattr(b, p) for b in blocks]) for p in ("q", "qd", "qdd")))


@pytest.mark.parametrize("name", ["run.csv", "run.parquet"])
def test_every_state_comes_back_to_its_last_bit(folder, states, paper, name):
    log = log_sample(folder / name, paper)
    assert log.count == ROWS
    back = read(log)
    for part in ("q", "qd", "qdd"):
        assert (getattr(back, part) == getattr(states, part)).all()


def test_both_formats_and_any_threads_give_the_same_digits(folder, paper, appendix):
    kinds = [sweep(paper, appendix, sample=folder / name) for name in ("run.csv", "run.parquet")]
    kinds.append(sweep(paper, appendix, sample=folder / "run.parquet", threads=2, batch=1))
    values = [statistics_value(found.statistics) for found in kinds]
    assert values[0] == values[1] == values[2]
    assert values[0]["count"] == ROWS


def test_line_ends_do_not_matter(folder, paper, states):
    text = (folder / "run.csv").read_bytes()
    file = folder / "windows.csv"
    file.write_bytes(b"\xef\xbb\xbf" + text.rstrip(b"\n").replace(b"\n", b"\r\n"))
    assert (read(log_sample(file, paper)).qdd == states.qdd).all()


@pytest.mark.parametrize("chunk", [1, 7, 64, 10_000])
def test_blocks_begin_where_they_should_whatever_is_read_at_once(
    tmp_path, paper, monkeypatch, chunk
):
    """Small blocks and small reads: every way that a line can fall on an edge."""
    monkeypatch.setattr("ur5check._sweep.csv_log._CHUNK", chunk)
    monkeypatch.setattr("ur5check._sweep.csv_log.BLOCK", 3)
    for rows in (1, 2, 3, 4, 6, 7):
        for end in ("", "\n"):
            file = tmp_path / "few.csv"
            lines = [",".join([str(row)] * 18) for row in range(rows)]
            file.write_text("\n".join([",".join(NUMBERED), *lines]) + end)
            log = open_csv(file, paper)
            assert log.count == rows
            got = [log.block(k).q[:, 0] for k in range(-(-rows // 3))]
            assert np.concatenate(got).tolist() == list(range(rows))


def csv(tmp_path: Path, *lines: str, header: str = ",".join(NUMBERED)) -> Path:
    file = tmp_path / "run.csv"
    file.write_text("\n".join([header, *lines]) + "\n")
    return file


GOOD = ",".join(["0.5"] * 18)


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ((GOOD, GOOD.replace("0.5", "fast", 1)), r"run\.csv:3: column 'q1' .*got 'fast'"),
        ((GOOD[:-3] + "nan",), r"run\.csv:2: column 'qdd6' .*got 'nan'"),
        ((GOOD[:-3] + "inf",), r"run\.csv:2: column 'qdd6' .*got 'inf'"),
        ((GOOD, "", GOOD), r"run\.csv:3: has 1 columns where the header has 18"),
        ((GOOD, GOOD + ",1"), r"run\.csv:3: has 19 columns"),
        ((GOOD, GOOD[4:], GOOD + ",1"), r"run\.csv:3: has 17 columns"),
        ((GOOD.replace(",", ";"),), r"run\.csv:2: has 1 columns"),
        ((GOOD[:-3],), r"run\.csv:2: column 'qdd6' .*got ''"),
        ((GOOD[:-3] + "1_0",), r"run\.csv:2: column 'qdd6' .*got '1_0'"),
        ((GOOD[:-3] + '"1"',), r"run\.csv:2: column 'qdd6'"),
        ((), r"run\.csv: contains no state"),
    ],
)
def test_a_bad_line_is_named(tmp_path, paper, appendix, lines, said):
    with pytest.raises(StateError, match=said):
        sweep(paper, appendix, sample=csv(tmp_path, *lines))


def test_the_line_is_counted_from_the_top_of_the_file(tmp_path, paper, appendix):
    lines = [GOOD] * (BLOCK + 10)
    lines[BLOCK + 5] = GOOD.replace("0.5", "0,5", 1)
    with pytest.raises(StateError, match=rf"run\.csv:{BLOCK + 7}: has 19 columns"):
        sweep(paper, appendix, sample=csv(tmp_path, *lines))


@pytest.mark.parametrize(
    ("header", "said"),
    [
        (",".join(NUMBERED).replace("qd3", "dq3"), "no column 'qd3'.*did you mean"),
        (",".join(NUMBERED).replace("q2,", "q1,", 1), "columns 'q1', 'q1' hold the same quantity"),
        ("", "no column 'q1'"),
        (GOOD, "no column 'q1'"),
    ],
)
def test_a_bad_header_is_named(tmp_path, paper, appendix, header, said):
    with pytest.raises(StateError, match=said):
        sweep(paper, appendix, sample=csv(tmp_path, GOOD, header=header))


def test_a_log_that_changes_meanwhile_is_refused(tmp_path, paper):
    file = csv(tmp_path, GOOD)
    log = log_sample(file, paper)
    with file.open("a") as more:
        more.write(GOOD + "\n")
    with pytest.raises(StateError, match="changed during the sweep"):
        log.block(0)


def written(tmp_path: Path, **changed) -> Path:
    columns = {name: pa.array([0.5, 0.25]) for name in NUMBERED}
    file = tmp_path / "run.parquet"
    parquet.write_table(pa.table({**columns, **changed}), file)
    return file


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"qd2": pa.array([1.0, None])}, r"row 2: column 'qd2' .*got None"),
        ({"qd2": pa.array([np.nan, 1.0])}, r"row 1: column 'qd2' .*got nan"),
        ({"q6": pa.array(["0.1", "0.2"])}, r"column 'q6' holds string; it must hold numbers"),
    ],
)
def test_a_bad_row_is_named(tmp_path, paper, appendix, changed, said):
    with pytest.raises(StateError, match=said):
        sweep(paper, appendix, sample=written(tmp_path, **changed))


def test_whole_numbers_and_single_precision_are_numbers(tmp_path, paper):
    file = written(tmp_path, q1=pa.array([1, 2]), q2=pa.array([0.5, 0.25], pa.float32()))
    assert log_sample(file, paper).block(0).q[:, :2].tolist() == [[1.0, 0.5], [2.0, 0.25]]


def test_what_is_no_log_is_refused(tmp_path, paper, appendix):
    for name, said in (("no.csv", "there is no such file"), ("no.parquet", "no such file")):
        with pytest.raises(StateError, match=said):
            sweep(paper, appendix, sample=tmp_path / name)
    (tmp_path / "text.parquet").write_text("q1,q2")
    with pytest.raises(StateError, match="is not a Parquet file"):
        sweep(paper, appendix, sample=tmp_path / "text.parquet")
    (tmp_path / "bytes.csv").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(StateError, match="is not text"):
        sweep(paper, appendix, sample=tmp_path / "bytes.csv")
    empty = written(tmp_path)
    parquet.write_table(parquet.read_table(empty).slice(0, 0), empty)
    with pytest.raises(StateError, match="contains no state"):
        sweep(paper, appendix, sample=empty)


def test_a_log_is_taken_as_it_is(tmp_path, paper, appendix):
    for option in ({"states": 10}, {"within_limits": True}):
        with pytest.raises(UsageError, match="do not apply to a log"):
            sweep(paper, appendix, sample=csv(tmp_path, GOOD), **option)


def test_the_checkpoint_of_another_log_is_refused(tmp_path, paper, appendix):
    kept = tmp_path / "checkpoint.json"
    sweep(paper, appendix, sample=csv(tmp_path, GOOD), checkpoint=kept)
    with pytest.raises(UsageError, match=r"different: sample\)"):
        sweep(paper, appendix, sample=csv(tmp_path, GOOD.replace("5", "6", 1)), checkpoint=kept)


def test_without_pyarrow_it_says_what_to_install(tmp_path):
    program = (
        "import sys; sys.modules['pyarrow'] = None; from ur5check import sweep; "
        f"sweep('paper', 'paper', sample={str(written(tmp_path))!r})"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=False
    )
    assert "pip install 'ur5check[parquet]'" in done.stderr
