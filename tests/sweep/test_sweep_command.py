"""`ur5check sweep`: what it prints, writes and refuses."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
import time

import jsonschema
import numpy as np
import pytest
from pyarrow import parquet

from report_schema import VALIDATOR, read_report
from ur5check._cli.main import main
from ur5check._sweep.progress import duration
from ur5check._sweep.sweep import sweep

BASE = ("sweep", "paper", "appendix", "--states", "2e3", "--tolerance", "1")


@pytest.fixture
def say(capsys):
    """`say(*arguments)`: exit code, stdout, stderr."""

    def run(*arguments: object) -> tuple[int, str, str]:
        code = main([str(argument) for argument in arguments])
        return code, *capsys.readouterr()

    return run


def test_the_verdict_comes_first_and_progress_on_stderr(say):
    code, out, err = say(*BASE)
    assert code == 1
    assert out.splitlines()[2].startswith("DIFFER: paper and appendix need different torques")
    assert "2,000 random states" in out
    assert "States above the tolerance" in out
    assert re.search(r"2,000 states in .* s, [\d,]+ per second", err)
    assert say(*BASE, "--quiet")[2] == ""


def test_equal_models_agree(say):
    code, out, _ = say("sweep", "paper", "paper", "--states", "500", "--quiet")
    assert code == 0
    assert "AGREE: A and B need the same torques at 500 random states" in out
    assert "States above the tolerance" not in out


def test_markdown(say, tmp_path):
    assert say(*BASE, "-o", tmp_path / "s.md")[0] == 1
    text = (tmp_path / "s.md").read_text(encoding="utf-8")
    assert "| joint |" in text
    assert "Reach map" in text


@pytest.mark.parametrize("how", ["random", "sobol", "grid"])
def test_json_is_as_the_schema_says(say, how):
    value = read_report(say(*BASE, "--sample", how, "--format", "json", "--quiet")[1])
    assert value["schema"] == "ur5check.sweep/2"
    assert value["sample"]["kind"] == how
    assert value["states"] == (3**6 if how == "grid" else 2000)
    for joint in value["joints"]:
        assert sum(joint["histogram"]["count"]) == value["states"]
    visits, largest = (np.array(value["reach_map"][key]) for key in ("visits", "largest"))
    assert visits.sum() == value["states"]
    assert largest.shape == (6, *visits.shape)
    assert largest.max() == max(joint["max"] for joint in value["joints"])


def test_the_schema_refuses_a_wrong_read_report(say):
    value = read_report(say(*BASE, "--format", "json", "--quiet")[1])
    value["joints"][0]["rms"] = "small"
    with pytest.raises(jsonschema.ValidationError):
        VALIDATOR.validate(value)


def test_the_command_in_the_report_makes_it_again(say):
    first = read_report(
        say(*BASE, "--within-limits", "--threads", 2, "--format", "json", "--quiet")[1]
    )
    words = first["command"].split()
    assert words[:4] == ["ur5check", "sweep", "paper", "appendix"]
    assert "--threads" not in words
    again = read_report(say(*words[1:], "--format", "json", "--quiet")[1])
    assert again == first


def test_a_log_is_an_input(say, tmp_path):
    log = tmp_path / "run.csv"
    header = ",".join(f"{part}{i}" for part in ("q", "qd", "qdd") for i in range(1, 7))
    log.write_text("\n".join([header, ",".join(["0.1"] * 18), ",".join(["0.2"] * 18)]))
    code, out, _ = say("sweep", "paper", "appendix", "--sample", log, "--format", "json", "--quiet")
    value = read_report(out)
    assert (code, value["states"], value["sample"]["file"]) == (1, 2, "run.csv")
    assert value["inputs"][-1] == {"name": "run.csv", "sha256": value["sample"]["sha256"]}
    before = log.read_bytes()
    for option in ("-o", "--checkpoint"):
        code, _, err = say("sweep", "paper", "appendix", "--sample", log, option, log)
        assert code == 2
        assert "is one of the inputs" in err
    assert log.read_bytes() == before


def test_parquet_holds_histograms_and_map(say, tmp_path, paper, appendix):
    file = tmp_path / "found.parquet"
    assert say(*BASE, "--parquet", file, "--quiet")[0] == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["found.map.parquet", file.name]
    bins = parquet.read_table(file).to_pydict()
    cells = parquet.read_table(tmp_path / "found.map.parquet").to_pydict()
    found = sweep(paper, appendix, states=2000)
    assert set(bins["joint"]) == set(found.pair.a.joint_names)
    assert sum(bins["count"]) == 6 * 2000
    assert (np.array(bins["lower"]) < np.array(bins["upper"])).all()
    assert sum(cells["visits"]) == 2000
    assert (np.array(cells["radius_lower"]) < np.array(cells["radius_upper"])).all()
    for name, largest in zip(found.pair.a.joint_names, found.maximum, strict=True):
        assert max(cells[f"max_{name}"]) == largest


def test_a_checkpoint_goes_on(say, tmp_path):
    kept = tmp_path / "checkpoint.json"
    first = say(*BASE, "--checkpoint", kept, "--quiet")
    code, out, err = say(*BASE, "--checkpoint", kept)
    assert (code, out) == first[:2]
    assert "2,000 states are done" in err
    code, out, err = say(*BASE, "--seed", 1, "--checkpoint", kept, "--quiet")
    assert (code, out) == (2, "")
    assert "was written for another sweep (different: sample)" in err


@pytest.mark.parametrize("threads", ["1", "2"])
def test_ctrl_c_keeps_what_is_done(tmp_path, threads):
    kept = tmp_path / "checkpoint.json"
    words = ["sweep", "paper", "paper", "--states", "1e9", "--threads", threads, "--batch", "1"]
    words += ["--checkpoint", str(kept), "--checkpoint-every", "0"]
    running = subprocess.Popen(
        [sys.executable, "-m", "ur5check", *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    while not kept.exists() and running.poll() is None:
        time.sleep(0.02)
    running.send_signal(signal.SIGINT)
    out, err = running.communicate(timeout=20)
    assert (running.returncode, out) == (130, "")
    assert re.search(r"checkpoint\.json holds [\d,]+ states; repeat the command to resume", err)
    assert err.endswith("ur5check: error: interrupted\n")
    assert json.loads(kept.read_text())["blocks"] >= 1
    assert list(tmp_path.iterdir()) == [kept]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--states", "1.5"], "not a whole number"),
        (["--states", "many"], "not a whole number"),
        (["--states", "inf"], "not a whole number"),
        (["--states", "0"], "at least 1"),
        (["--sample", "halton"], "random, sobol, grid"),
        (["--sample", "no.csv"], "no such file"),
        (["--tolerance", "1", "2"], "one for each of 6 joints"),
        (["--threads", "2", "--scheduler", "tcp://127.0.0.1:1"], "does not apply"),
        (["--checkpoint-every", "-1"], "must not be negative"),
        (["--parquet", "found.csv"], "must end in .parquet"),
        (["-o", "x.json", "--checkpoint", "x.json"], "name the same file"),
        (["--checkpoint", "no/such/folder/x.json"], "there is no folder"),
    ],
)
def test_bad_options_are_one_line_and_exit_2(say, tmp_path, monkeypatch, options, said):
    monkeypatch.chdir(tmp_path)
    code, out, err = say("sweep", "paper", "appendix", "--quiet", *options)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert said in err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("text", ["2e3", "2000", "2_000"])
def test_counts_may_be_written_as_people_write_them(say, text):
    out = say("sweep", "paper", "paper", "--states", text, "--quiet")[1]
    assert "2,000 random states" in out


@pytest.mark.parametrize(
    ("seconds", "said"),
    [(0, "0 s"), (119, "119 s"), (121, "2 min"), (7300, "2.0 h"), (200_000, "2.3 days")],
)
def test_durations(seconds, said):
    assert duration(seconds) == said
