"""docs/sweep.md: its commands run, its code prints what it says, its cluster starts."""

from __future__ import annotations

import contextlib
import io
import re
import runpy
import shlex
import shutil
import socket
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from repository import REPOSITORY
from ur5check._cli.main import main

ROOT = REPOSITORY
PAGE = (ROOT / "docs" / "sweep.md").read_text(encoding="utf-8")
COMMANDS = [
    line
    for block in re.findall(r"^```sh\n(.*?)^```", PAGE, re.M | re.S)
    for line in block.splitlines()
]
SWEEPS = [line for line in COMMANDS if line.startswith("ur5check ") and "--scheduler" not in line]


@pytest.fixture
def desk(tmp_path, monkeypatch):
    """A folder with the log that the page speaks of."""
    monkeypatch.chdir(tmp_path)
    header = ",".join(f"{part}{i}" for part in ("q", "qd", "qdd") for i in range(1, 7))
    states = np.random.default_rng(0).uniform(-1, 1, (50, 18))
    np.savetxt("run.csv", states, delimiter=",", header=header, comments="")
    return tmp_path


def fewer(command: str) -> list[str]:
    """The command, looking at few states."""
    return re.sub(r"--states 1e\d", "--states 2000", command).split()[1:] + ["--quiet"]


@pytest.mark.parametrize("command", SWEEPS)
def test_a_command_runs(command, desk, capsys):
    assert main(fewer(command)) == 1  # the two models differ
    written = re.findall(r"(?:-o|--checkpoint) (\S+)", command)
    assert all((desk / name).stat().st_size for name in written)
    assert bool(capsys.readouterr().out) is ("-o" not in command.split())


def test_every_way_is_shown():
    assert len(SWEEPS) >= 5
    shown = " ".join(COMMANDS)
    for option in ("--threads", "--sample", "--checkpoint", "--scheduler", "--tolerance"):
        assert option in shown


def test_the_code_prints_what_the_page_says():
    blocks = re.findall(r"^```python\n(.*?)^```\n+```text\n(.*?)^```", PAGE, re.M | re.S)
    assert len(blocks) == 1
    for code, promised in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, {})  # noqa: S102 - our own page
        assert printed.getvalue() == promised


def test_the_cluster_starts_as_the_page_says(desk, capfd):
    """The page's own three commands, on a port that is free."""
    scheduler, worker, client = (
        next(line for line in COMMANDS if part in line)
        for part in ("dask scheduler", "dask worker", "--scheduler")
    )
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = str(probe.getsockname()[1])
    extra = ["--dashboard-address", "127.0.0.1:0"]
    place = str(Path(sys.executable).parent)
    started = []
    try:
        for command in (scheduler, worker):
            words = [*shlex.split(command.replace("8786", port)), *extra]
            words[0] = shutil.which("dask", path=place) or "dask"
            started.append(
                subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            )
        code, until = 2, time.monotonic() + 60.0
        while code == 2 and time.monotonic() < until:
            code = main(fewer(client.replace("8786", port)))  # 2 while no worker has come yet
        assert code == 1
        assert "DIFFER: paper and appendix" in capfd.readouterr().out
    finally:
        for process in reversed(started):
            process.terminate()
            process.wait(10)


def test_the_benchmark_has_the_pages_rows(capsys):
    run = runpy.run_path(str(ROOT / "benchmarks" / "bench_sweep.py"))["main"]
    assert run(["--blocks", "1", "--repeats", "1"]) == 0

    def names(text: str) -> list[str]:
        return re.findall(r"^\| (.+?) \| [\d.e+]+ \| .*\|$", text, re.M)

    assert len(names(PAGE)) == 6
    assert names(capsys.readouterr().out) == names(PAGE)
