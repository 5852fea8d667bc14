"""Planted faults and sound robots, judged by ur5check and by two other validators.

    python benchmarks/bench_peers.py --python PYTHON [--seed N] [--robots NAME …] [--tools NAME …]

PYTHON is that of an environment with the peers: pip install simcheck==0.2.0 urdf-validator==1.6.0.
Faults and robots are those of `bench_rules.py`.  The files are given without meshes, and each tool
runs as its command does by default.

One rule for all: a tool detects a fault if it exits with an error or says something, at least as a
warning, that it does not do or say for the sound file.  Which warning is not asked.  A false error
is an error on a sound file; that meshes are missing is not counted.  A tool
that does not end within 30 s of processor time has said nothing.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as ET

from bench_rules import REPORTING, TUNING, findings_of
from planted_faults import KINDS, planted

from ur5check._io.ros_packages import example_robot_data

PEERS = ("simcheck", "urdf-validator")
WORKER = Path(__file__).with_name("peers_worker.py")


@dataclass(frozen=True)
class Case:
    """One file.  sound : the name of the file without the fault;  kind : None for a sound file"""

    file: str
    robot: str
    sound: str
    kind: str | None


@dataclass(frozen=True)
class Report:
    """said : (severity, check, message);  seconds : of processor time, imports not counted
    ended : whether the tool ended within the time that `peers_worker.py` allows
    """

    code: int
    seconds: float
    said: frozenset[tuple[str, str, str]]
    ended: bool = True


def write_cases(robots: dict[str, Path], seed: int, folder: Path) -> list[Case]:
    """Write each robot, sound and with each fault that it has a place for."""
    cases = []
    for name, path in robots.items():
        root = ET.fromstring(path.read_bytes())  # noqa: S314 - installed with this program
        sound = f"{name}.urdf"
        (folder / sound).write_text(ET.tostring(root, encoding="unicode"), encoding="utf-8")
        cases.append(Case(sound, name, sound, None))
        for k, kind in enumerate(KINDS):
            made = planted(root, kind, seed)
            if made is not None:
                file = f"{name}_{k:02d}.urdf"
                (folder / file).write_text(made[0], encoding="utf-8")
                cases.append(Case(file, name, sound, kind.name))
    return cases


def ours(cases: Iterable[Case], folder: Path) -> dict[str, Report]:
    """What ur5check's rules say of each file."""
    reports = {}
    with tempfile.TemporaryDirectory() as temporary:
        for case in cases:
            text = (folder / case.file).read_text(encoding="utf-8")
            began = time.process_time()
            found = findings_of(text, Path(temporary))
            seconds = time.process_time() - began
            said = [
                (str(f.severity), f.rule, f"{f.subject} {f.message}")
                for f in found
                if f.severity != "note"
            ]
            code = int(any(severity == "error" for severity, *_ in said))
            reports[case.file] = Report(code, seconds, frozenset(said))
    return reports


def theirs(tool: str, python: str, cases: Iterable[Case], folder: Path) -> dict[str, Report]:
    """What a peer says of each file."""
    command = [python, str(WORKER), tool, str(folder)]
    names = "".join(f"{case.file}\n" for case in cases)
    reports = {}
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdin is not None and process.stdout is not None  # noqa: S101
        process.stdin.write(names)
        process.stdin.close()
        for line in process.stdout:
            answer = json.loads(line)
            print(f"{tool}: {answer['file']}", file=sys.stderr)
            said = frozenset(tuple(one) for one in answer["said"])
            report = Report(answer["code"], answer["seconds"], said, answer["ended"])
            reports[answer["file"]] = report
    return reports


def detected(faulted: Report, sound: Report) -> bool:
    """Whether a tool does or says something of the faulted file that it does not of the sound."""
    return bool(faulted.code and not sound.code) or bool(faulted.said - sound.said)


def false_errors(report: Report) -> int:
    """Errors on a sound file, those about missing meshes left out."""
    return sum(severity == "error" and "mesh" not in check for severity, check, _ in report.said)


def rows(cases: list[Case], reports: dict[str, dict[str, Report]]) -> list[list[str]]:
    """A row a kind: its name, how many were planted, and how many each tool detected."""
    kinds: dict[str, list[Case]] = defaultdict(list)
    for case in cases:
        if case.kind is not None:
            kinds[case.kind].append(case)
    table = []
    for kind, planted_ones in kinds.items():
        hits = [
            sum(detected(said[case.file], said[case.sound]) for case in planted_ones)
            for said in reports.values()
        ]
        table.append([kind, str(len(planted_ones)), *map(str, hits)])
    return table


def summary(cases: list[Case], reports: dict[str, dict[str, Report]]) -> list[list[str]]:
    """Rows of the whole: detected, errors on sound files, time a file."""
    faults = [case for case in cases if case.kind is not None]
    sound = [case for case in cases if case.kind is None]
    tools = list(reports.values())
    hits = [sum(detected(t[c.file], t[c.sound]) for c in faults) for t in tools]
    errors = [sum(false_errors(t[c.file]) for c in sound) for t in tools]
    seconds = [sorted(t[c.file].seconds for c in cases)[len(cases) // 2] for t in tools]
    return [
        ["all faults", str(len(faults)), *map(str, hits)],
        ["errors on sound files", str(len(sound)), *map(str, errors)],
        [
            "not ended within 30 s",
            str(len(cases)),
            *(str(sum(not r.ended for r in t.values())) for t in tools),
        ],
        ["CPU time a file, median [s]", str(len(cases)), *(f"{s:.2g}" for s in seconds)],
    ]


def main() -> None:
    """Print one table."""
    files = {Path(file).stem: file for file in (*TUNING, *REPORTING)}
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--python", required=True, help="of the environment with the peers")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--robots", nargs="+", choices=files, default=list(files), metavar="NAME")
    parser.add_argument("--tools", nargs="+", choices=PEERS, default=list(PEERS))
    args = parser.parse_args()
    share = example_robot_data()
    assert share is not None  # noqa: S101 - a dependency of ur5check
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        robots = {name: share / "robots" / files[name] for name in args.robots}
        cases = write_cases(robots, args.seed, folder)
        reports = {"ur5check": ours(cases, folder)}
        for tool in args.tools:
            reports[tool] = theirs(tool, args.python, cases, folder)
    head = ["fault", "files", *reports]
    for row in (head, ["---"] * len(head), *rows(cases, reports), *summary(cases, reports)):
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main()
