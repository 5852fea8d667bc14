"""How well recordings are judged: of robots simulated by MuJoCo, half of them honest.

    python benchmarks/bench_recordings.py [--runs 60] [--minutes 60] [--tuning] [--jobs 2]
        [--page FILE]

Every run has its own arm, motion, drives and noise (1 % of each torque).  An honest run's model is
the robot's; in the others one cause is planted.  Seeds of "tuning" were looked at while thresholds
were set, those reported were not.
"""

from __future__ import annotations

import argparse
import resource
import sys
import tempfile
import time
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from arms_to_spoil import arm_called
from numpy.typing import NDArray
from simulated_recordings import Drives, Logger, drives_of, recorded, simulated

from ur5check._comparison.diagnosis.link_numbers import body_of, with_body
from ur5check._logs.comparison import RecordingComparison, compare_recording
from ur5check._robot import Inertia, SerialArm

Array = NDArray[np.float64]

ARMS = ("paper", "ur10", "xarm7")
DURATION = 30.0
TUNING, REPORTING = 100_000, 0  # first seeds

#: Ways in which honest recordings differ, and causes that are planted.
HONEST = ("plain", "jitter", "coarse-encoder", "lag")
PLANTED = (
    "payload", "missing-payload", "gain-of-joint", "gain-of-all", "gravity-direction", "joint-zero",
    "link-mass", "centre-sign", "model-column",
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Run:
    """One recording: kind, the robot and the model that it is compared with, and the truth.

    joint : of the planted cause, from 1;  value : planted mass and centre of a payload
    """

    seed: int
    kind: str
    arm: str
    robot: SerialArm
    model: SerialArm
    drives: Drives
    logger: Logger
    joint: int = 0
    value: tuple[float, ...] = ()
    zero: Array | None = None


def run_of(seed: int) -> Run:
    """The run of a seed: odd ones are honest."""
    rng = np.random.default_rng([seed, 1])
    arm_name = ARMS[seed // 2 % len(ARMS)]
    arm = arm_called(arm_name, 0)
    arm = arm.with_armature(np.zeros(arm.n))
    kinds = HONEST if seed % 2 else PLANTED
    kind = kinds[seed // 2 // len(ARMS) % len(kinds)]
    run = Run(seed, kind, arm_name, arm, arm, drives_of(arm, rng), Logger())
    joint = int(rng.integers(1, 3))  # from 0: shoulder and elbow, which carry most
    match kind:
        case "jitter":
            return replace(run, logger=Logger(jitter=3.5e-3))
        case "coarse-encoder":
            return replace(run, logger=Logger(encoder=1e-4))
        case "lag":
            return replace(run, logger=Logger(lag=0.18))
        case "payload" | "missing-payload":
            mass = float(rng.uniform(0.5, 3.0))
            centre = rng.uniform(-0.08, 0.08, 3)
            heavy = _loaded(arm, mass, centre)
            if kind == "payload":
                return replace(run, robot=heavy, value=(mass, *centre))
            return replace(run, model=heavy, value=(-mass, *centre))
        case "gain-of-joint":
            gains = np.ones(arm.n)
            gains[joint] = rng.choice([0.88, 0.92, 1.1, 1.13])
            return replace(run, logger=Logger(gains=gains), joint=joint + 1)
        case "gain-of-all":
            return replace(run, logger=Logger(gains=float(rng.choice([0.88, 1.12]))))
        case "gravity-direction":
            angle, way = np.radians(rng.uniform(2.0, 6.0)), rng.uniform(0.0, 2.0 * np.pi)
            g = 9.81 * np.array(
                [np.sin(angle) * np.cos(way), np.sin(angle) * np.sin(way), -np.cos(angle)]
            )
            return replace(run, robot=arm.with_gravity(g))
        case "joint-zero":
            zero = np.zeros(arm.n)
            zero[joint] = np.radians(rng.uniform(2.0, 5.0)) * rng.choice([-1.0, 1.0])
            return replace(run, zero=zero, joint=joint + 1)
        case "link-mass":
            body = body_of(arm, joint)
            wrong = replace(body, mass=body.mass * float(rng.choice([0.7, 1.25, 1.4])))
            return replace(run, model=with_body(arm, joint, wrong), joint=joint + 1)
        case "centre-sign":
            body = body_of(arm, joint)
            flip = np.ones(3)
            flip[int(np.abs(body.com).argmax())] = -1.0
            wrong = replace(body, com=body.com * flip)
            return replace(run, model=with_body(arm, joint, wrong), joint=joint + 1)
        case "model-column":
            none = Drives(np.zeros(arm.n), np.zeros(arm.n), run.drives.rotor)
            return replace(run, drives=none, logger=Logger(noise=1e-4))
    return run


def _loaded(arm: SerialArm, mass: float, centre: Array) -> SerialArm:
    ball = Inertia(mass, centre, 1e-5 * mass * np.eye(3))
    inertias = [link.inertia for link in arm.links]
    inertias[-1] = inertias[-1] + ball
    return arm.with_inertias(inertias)


@dataclass(frozen=True)
class Outcome:
    """What was said of one run.

    right : whether what was planted is the first cause, or an honest run passes
    named, remarks : ids of causes
    error : of a payload's mass, relative, and of its centre [m]
    covered, intervals : how many 95 % intervals hold the truth, by kind
    """

    seed: int
    kind: str
    arm: str
    word: str
    right: bool
    named: tuple[str, ...]
    remarks: tuple[str, ...]
    rules: tuple[str, ...]
    error: tuple[float, float] | None
    covered: dict[str, tuple[int, int]]


def outcome_of(seed: int) -> Outcome:
    """Simulate, record, compare."""
    run = run_of(seed)
    rng = np.random.default_rng([seed, 2])
    motion = simulated(run.robot, run.drives, rng, DURATION)
    if run.zero is not None:
        t, q, qd, tau = motion
        motion = t, q - run.zero, qd, tau
    with tempfile.TemporaryDirectory() as folder:
        file = recorded(motion, run.logger, rng, Path(folder) / "run.csv")
        c = compare_recording(run.model, file)
    rules = tuple(finding.rule for finding in c.findings)
    word = "PASS" if c.passed else "FAIL" if c.usable and c.judged else "UNUSABLE"
    return Outcome(
        seed, run.kind, run.arm, word, _right(run, c, rules),
        tuple(f"{cause.id}:{cause.joint}:{cause.mistake}" for cause in c.named[:3]),
        tuple(f"{cause.id}:{cause.joint}:{cause.mistake}" for cause in c.remarks[:3]),
        rules, _payload_error(run, c), _coverage(run, c),
    )  # fmt: skip


def _right(run: Run, c: RecordingComparison, rules: tuple[str, ...]) -> bool:
    if run.kind == "model-column":
        return not c.usable
    if run.kind == "lag":
        return c.passed and "LOG123" in rules
    if run.kind in HONEST:
        return c.passed
    first = next(iter(c.named or c.remarks), None)
    if first is None:
        return False
    if run.kind == "centre-sign":
        return (first.mistake, first.joint) == ("centre-sign", run.joint)
    cause = run.kind.removeprefix("missing-")
    return (first.id, first.joint) == (cause, run.joint)


def _payload_error(run: Run, c: RecordingComparison) -> tuple[float, float] | None:
    if not run.value:
        return None
    found = next(cause.value for cause in c.causes if cause.id == "payload")
    truth = np.array(run.value)
    return float(abs(found[0] / truth[0] - 1.0)), float(np.linalg.norm(found[1:] - truth[1:]))


def _coverage(run: Run, c: RecordingComparison) -> dict[str, tuple[int, int]]:
    """Intervals that hold the truth, of those that were made."""
    held: dict[str, list[bool]] = defaultdict(list)
    if run.value:
        payload = next(cause for cause in c.causes if cause.id == "payload")
        held["payload"] += list(np.abs(payload.value - run.value) <= payload.half_width)
    if run.kind in HONEST:
        held["base parameters"] += [abs(p.change) <= p.half_width for p in c.parameters]
        for j, joint in enumerate(c.joints):
            truth = {
                "viscous": run.drives.viscous[j],
                "coulomb": run.drives.coulomb[j],
                "rotor": run.drives.rotor[j],
            }
            drive = zip(c.friction.names, joint.drive.value, joint.drive.half_width, strict=True)
            if joint.stands_out:
                for name, value, width in drive:
                    if name in truth:
                        held[name].append(bool(abs(value - truth[name]) <= width))
    return {name: (sum(map(bool, values)), len(values)) for name, values in held.items()}


def write_large(count: int, file: Path) -> None:
    """A recording of many samples at 1 kHz, as Parquet."""
    import pyarrow
    import pyarrow.parquet

    run = run_of(REPORTING + 1)
    rng = np.random.default_rng(3)
    motion = simulated(run.robot, run.drives, rng, 60.0)
    # The trajectory is periodic: 60 s are six periods.
    repeats = -(-count // len(motion[0]))
    names = ("q", "qd", "tau")
    columns = {"t": 1e-3 * np.arange(count)}
    for name, values in zip(names, motion[1:], strict=True):
        for j, column in enumerate(np.tile(values, (repeats, 1))[:count].T):
            noise = 0.01 * column.std() * rng.normal(size=count) if name == "tau" else 0.0
            columns[f"{name}{j}"] = column + noise
    pyarrow.parquet.write_table(pyarrow.table(columns), file)


def compare_large(file: Path) -> tuple[float, float, float]:
    """Time on the clock and of the processor [s], and largest memory [GB] of this process."""
    begin, busy = time.perf_counter(), time.process_time()
    compare_recording(run_of(REPORTING + 1).model, file)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    return time.perf_counter() - begin, time.process_time() - busy, memory


_INTERVALS = """
Intervals are too narrow: they should hold the truth in 92 to 98 %. MuJoCo's dry friction sticks
while a joint reverses and is then no function of velocity; what a fit cannot follow there is alike
in every block of time, so that the scatter between blocks does not show it. In a run without
Coulomb friction 32 of 34 base parameters lay in their intervals.
"""


def page_of(outcomes: list[Outcome], size: tuple[int, float, float, float] | None) -> str:
    """The page docs/recordings-benchmark.md."""
    honest = [o for o in outcomes if o.kind in HONEST]
    planted = [o for o in outcomes if o.kind not in HONEST]
    false = [o for o in honest if o.named or o.remarks]
    lines = [
        "# Recordings: how reliable",
        "",
        "Written by `python benchmarks/bench_recordings.py --page docs/recordings-benchmark.md`.",
        f"{len(outcomes)} recordings of robots simulated by MuJoCo ({', '.join(ARMS)}), "
        f"{len(honest)} of them honest;",
        f"{DURATION:g} s at 125 Hz, friction, rotor inertia and 1 % noise of every torque. Each",
        "has a seed of its own; only seed 1 was looked at while thresholds were set.",
        "",
        "| what | runs | result |",
        "|---|---|---|",
    ]
    lines.append(
        f"| honest runs: the model passes | {len(honest)} | {sum(o.right for o in honest)} |"
    )
    lines.append(f"| honest runs: a cause is named all the same | {len(honest)} | {len(false)} |")
    counted = [o for o in planted if o.kind != "model-column"]
    lines.append(
        f"| planted cause named first | {len(counted)} | {sum(o.right for o in counted)} |"
    )
    for kind in (*PLANTED, "lag"):
        some = [o for o in outcomes if o.kind == kind]
        what = {"model-column": "recognised: ", "lag": "recognised: "}.get(kind, "… ")
        lines.append(f"| {what}{kind} | {len(some)} | {sum(o.right for o in some)} |")
    errors = [o.error for o in planted if o.error is not None]
    if errors:
        mass, centre = np.array(errors).T
        within = int(((mass <= 0.02) & (centre <= 0.005)).sum())
        lines.append(f"| payload within 2 % and 5 mm | {len(errors)} | {within} |")
        lines.append(
            f"| payload, largest error | {len(errors)} | {100 * mass.max():.2g} %, "
            f"{1e3 * centre.max():.2g} mm |"
        )
    held: dict[str, list[tuple[int, int]]] = defaultdict(list)
    for o in outcomes:
        for name, counts in o.covered.items():
            held[name].append(counts)
    for name, counts in held.items():
        inside, total = np.sum(counts, axis=0)
        lines.append(
            f"| 95 % intervals that hold the truth: {name} | {total} intervals | "
            f"{inside / total:.1%} |"
        )
    if size is not None:
        count, seconds, busy, memory = size
        lines.append(
            f"| a recording of {count:,} samples | 1 | {busy:.0f} s of the processor "
            f"({seconds:.0f} s on the clock of a busy machine), {memory:.2f} GB |"
        )
    return "\n".join(lines) + "\n" + _INTERVALS


def main() -> int:
    """Run, print, write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=60)
    parser.add_argument("--minutes", type=float, default=60.0, help="no more runs after them")
    parser.add_argument("--tuning", action="store_true", help="the seeds of tuning")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--large", type=int, default=1_000_000, help="samples; 0 for none")
    parser.add_argument("--page", metavar="FILE")
    args = parser.parse_args()
    first = TUNING if args.tuning else REPORTING
    end = time.monotonic() + 60.0 * args.minutes
    outcomes = []
    with ProcessPoolExecutor(args.jobs, mp_context=get_context("spawn")) as pool:
        for done in pool.map(outcome_of, range(first, first + args.runs)):
            outcomes.append(done)
            if not done.right or (done.kind in HONEST and (done.named or done.remarks)):
                print(done, file=sys.stderr, flush=True)
            if time.monotonic() > end:
                pool.shutdown(cancel_futures=True)
                break
    size = None
    if args.large:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "large.parquet"
            write_large(args.large, file)
            # A process of its own, so that its memory is what the comparison needs.
            with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
                size = args.large, *pool.submit(compare_large, file).result()
    text = page_of(outcomes, size)
    print(text)
    if args.page:
        Path(args.page).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
