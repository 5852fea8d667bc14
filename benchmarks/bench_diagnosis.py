"""Does the diagnosis find the mistakes that it knows, and only those?  A seeded mutation benchmark.

    python benchmarks/bench_diagnosis.py [--seed N] [--clean N] [--arms NAME…] [--mistakes ID…]
        [--json FILE] [--write-docs] [--quick] [--missed] [--jobs N]

Every mistake of mutations.py is planted in every link of every arm, in one way drawn from the seed,
and the spoiled arm is compared with the arm.  `--missed` lists what was not found or misnamed;
`--arms ur5 --mistakes tensor-axes --missed` looks at one corner.  `--write-docs` writes the page
docs/diagnosis-benchmark.md.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
import zlib
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from functools import cache, partial
from itertools import chain
from pathlib import Path
from textwrap import fill
from typing import Any

import numpy as np
from arms_to_spoil import ARMS, arm_called, with_noise
from mutations import (
    GEOMETRY,
    INERTIAL,
    MISTAKES,
    WHOLE_ARM,
    Planting,
    in_space,
    only_moves_the_next_joint,
    plantings,
    same_inertias,
    same_motion,
)

from ur5check._comparison.arm_pair import pair_up
from ur5check._comparison.diagnosis.diagnosis import Diagnosis, diagnose
from ur5check._robot import SerialArm
from ur5check._robot.states import States, random_states

__all__ = ["SCHEMA", "main", "measure"]

SCHEMA = "ur5check._comparison.diagnosis-benchmark/1"
NOISE = 0.01
_STATES = 1000
_PAGE = Path(__file__).parents[1] / "docs" / "diagnosis-benchmark.md"
_QUICK_ARMS = ("ur5", "panda", "paper", "chain-4")
_STANDS_OUT = 3.0


@dataclass(frozen=True)
class Case:
    """One arm with planted mistakes, and what the diagnosis found.

    how : the way in which the mistake was made;  links : numbers from 1
    ties : other mistakes that come to the same arm, found without the diagnosis
    noise : on all numbers but the planted ones
    detected : a finding; without noise, an unexplained number does too; with noise, where every
        number differs, only one in a spoiled link that stands out among the unexplained
    named : the first finding's id is the planted one
    listed : … or the planted one is among those that the first finding calls equal
    tied : … or the first finding's id is one of `ties`
    placed : the first finding is in a spoiled link, or of the whole arm
    names : how many ids the first finding gave, equals counted
    answer : the first finding's id, its equals and its links; how many findings and unexplained
    seconds : of pairing and diagnosis
    """

    arm: str
    mistake: str
    how: str
    links: tuple[int, ...]
    ties: tuple[str, ...]
    noise: float
    detected: bool
    named: bool
    listed: bool
    tied: bool
    placed: bool
    names: int
    answer: str
    seconds: float


@dataclass(frozen=True)
class Clean:
    """One pair without a mistake; `findings` should be empty."""

    arm: str
    number: int
    level: float
    lengths: bool
    findings: tuple[str, ...]
    seconds: float


def main(arguments: Sequence[str] | None = None) -> int:
    """Plant, diagnose, print; write the JSON and the page if asked to."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=0, metavar="N")
    parser.add_argument(
        "--clean", type=int, default=1000, metavar="N", help="pairs of honest noise"
    )
    parser.add_argument("--arms", nargs="+", choices=ARMS, default=list(ARMS), metavar="NAME")
    parser.add_argument("--mistakes", nargs="+", choices=MISTAKES, default=list(MISTAKES),
                        metavar="ID")  # fmt: skip
    parser.add_argument("--json", type=Path, metavar="FILE", help="write every case here")
    parser.add_argument("--write-docs", action="store_true", help=f"write {_PAGE.name}")
    parser.add_argument("--quick", action="store_true", help="a few seconds: every mistake once")
    parser.add_argument("--missed", action="store_true", help="list what went wrong")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="processes")
    options = parser.parse_args(arguments)
    whole = options.arms == list(ARMS) and options.mistakes == list(MISTAKES)
    if options.write_docs and (options.quick or not whole):
        parser.error("the page is written from a whole run")
    if options.quick:
        options.arms = [name for name in options.arms if name in _QUICK_ARMS]
        options.clean = min(options.clean, 20)
    report = measure(
        options.seed, options.clean, options.arms, options.mistakes,
        quick=options.quick, jobs=options.jobs,
    )  # fmt: skip
    print(tables(report), _time(report), sep="\n\n")
    if options.missed:
        print(missed(report))
    if options.json:
        options.json.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    if options.write_docs:
        _PAGE.write_text(page(report), encoding="utf-8")
    return 0


def measure(
    seed: int,
    clean: int,
    arms: Sequence[str],
    mistakes: Sequence[str],
    *,
    quick: bool = False,
    jobs: int = 1,
) -> dict[str, Any]:
    """Everything that is measured, as plain values."""
    work = [((name,), mistake) for name in arms for mistake in mistakes]
    if quick:
        rotations = (np.roll(arms, -k) for k in range(len(mistakes)))
        work = [
            (tuple(rotation.tolist()), mistake)
            for rotation, mistake in zip(rotations, mistakes, strict=True)
        ]
    plant = partial(_cases, seed=seed, once=quick)
    with_lengths = (clean + 9) // 10
    numbers = range(clean + with_lengths)
    look = partial(_clean, seed=seed, arms=tuple(arms), without_lengths=clean)
    if jobs > 1:
        with ProcessPoolExecutor(jobs) as pool:
            cases = list(chain.from_iterable(pool.map(plant, work, chunksize=4)))
            pairs = list(pool.map(look, numbers, chunksize=20))
    else:
        cases = list(chain.from_iterable(map(plant, work)))
        pairs = list(map(look, numbers))
    return {
        "schema": SCHEMA,
        "seed": seed,
        "arms": list(arms),
        "noise": NOISE,
        "states": _STATES,
        "cases": [asdict(case) for case in cases],
        "clean": [asdict(pair) for pair in pairs],
    }


# --- one case ------------------------------------------------------------------------------------


def _cases(work: tuple[tuple[str, ...], str], *, seed: int, once: bool) -> list[Case]:
    """One mistake in every link of some arms, without and with noise; or `once` and no more."""
    names, mistake = work
    found = []
    for name in names:
        arm = arm_called(name, seed)
        rng = np.random.default_rng([seed, zlib.crc32(name.encode()), zlib.crc32(mistake.encode())])
        links = list(range(1, arm.n + 1))
        if once:
            rng.shuffle(links)
        for link in links:
            ways = list(plantings(mistake, arm, link))
            if ways:
                planting = ways[int(rng.integers(len(ways)))]
                ties = tuple(sorted({*_ties(name, seed, planting)} - {mistake}))
                for noise in (0.0, NOISE):
                    spoiled = planting.arm
                    if noise:
                        spoiled = with_noise(spoiled, noise, rng, truth=arm)
                    found.append(_case(name, arm, planting, ties, noise, spoiled, seed))
                if once:
                    return found
    return found


def _case(
    name: str,
    arm: SerialArm,
    planting: Planting,
    ties: tuple[str, ...],
    noise: float,
    spoiled: SerialArm,
    seed: int,
) -> Case:
    start = time.perf_counter()
    said: Diagnosis | None = None
    try:
        said = diagnose(pair_up(arm, spoiled), _states(arm.n, seed))
    except Exception as error:  # noqa: BLE001  an exception counts as a miss and does not end the benchmark
        answer = f"{type(error).__name__}: {error}"
    seconds = time.perf_counter() - start
    first, equals, place = "", (), ()
    detected = False
    if said is not None:
        if said.mistakes:
            first, equals = said.mistakes[0].id, said.mistakes[0].equals
            place = said.mistakes[0].links
        detected = bool(said.mistakes) or _stands_out(said, planting, noise)
        places = f" in {', '.join(map(str, place))}" if place else ""
        others = f" (or {', '.join(equals)})" if equals else ""
        rest = f"; {len(said.mistakes)} findings, {len(said.unexplained)} unexplained"
        answer = (first or "nothing") + others + places + rest
    listed = planting.mistake in (first, *equals)
    return Case(
        name,
        planting.mistake,
        planting.how,
        planting.links,
        ties,
        noise,
        detected,
        first == planting.mistake,
        listed,
        listed or first in ties,
        bool(first) and (not place or not planting.links or bool({*place} & {*planting.links})),
        1 + len(equals) if first else 0,
        answer,
        seconds,
    )


def _stands_out(said: Diagnosis, planting: Planting, noise: float) -> bool:
    if not noise or not said.unexplained:
        return bool(said.unexplained)
    worst = max(said.unexplained, key=lambda mismatch: mismatch.gap)
    usual = statistics.median(mismatch.gap for mismatch in said.unexplained)
    here = worst.link + 1 in planting.links or not planting.links
    return here and worst.gap > _STANDS_OUT * usual


@cache
def _states(n: int, seed: int) -> States:
    return random_states(n, _STATES, seed)


# --- ties ----------------------------------------------------------------------------------------


def _ties(name: str, seed: int, planting: Planting) -> Iterator[str]:
    """Ids of other mistakes that lead from the arm to the spoiled one, or from that one back."""
    arm, spoiled = arm_called(name, seed), planting.arm
    if planting.mistake in INERTIAL:
        same_place = [i - 1 for i in planting.links]
        for other in INERTIAL:
            if other != planting.mistake and any(
                way.links == planting.links and same_inertias(way.arm, target, same_place)
                for truth, target in ((arm, spoiled), (spoiled, arm))
                for link in planting.links[:1]
                for way in plantings(other, truth, link)
            ):
                yield other
    elif planting.mistake in (*GEOMETRY, *WHOLE_ARM):
        here = in_space(spoiled)
        if planting.links and only_moves_the_next_joint(arm, planting):
            yield "zero-shifted"
        for other, there in _moved_arms(name, seed):
            if other != planting.mistake and same_motion(here, there):
                yield other


@cache
def _moved_arms(name: str, seed: int) -> list[tuple[str, tuple[Any, Any]]]:
    arm = arm_called(name, seed)
    return [
        (mistake, in_space(way.arm))
        for mistake in (*GEOMETRY, "dh-convention", "base-turned")
        for link in range(1, arm.n + 1)
        for way in plantings(mistake, arm, link)
    ]


# --- clean pairs ---------------------------------------------------------------------------------


def _clean(number: int, *, seed: int, arms: tuple[str, ...], without_lengths: int) -> Clean:
    """Pair number `number`: an arm, and itself measured again with an error of 1 to 5 %."""
    name = arms[number % len(arms)]
    arm = arm_called(name, seed)
    rng = np.random.default_rng([seed, 1, number])
    level = float(rng.uniform(0.01, 0.05))
    lengths = number >= without_lengths
    other = with_noise(arm, level, rng, lengths=lengths)
    start = time.perf_counter()
    said = diagnose(pair_up(arm, other), _states(arm.n, seed))
    seconds = time.perf_counter() - start
    findings = tuple(
        f"{finding.id} in {', '.join(map(str, finding.links))}" for finding in said.mistakes
    )
    return Clean(name, number, level, lengths, findings, seconds)


# --- what is shown -------------------------------------------------------------------------------


def tables(report: dict[str, Any]) -> str:
    """The report as Markdown."""
    cases = report["cases"]
    heads = ["mistake", "planted", "tied"]
    for which in ("", ", 1 % noise"):
        heads += [f"{word}{which}" for word in ("detected", "named", "or equal", "or tied")]
    lines = ["| " + " | ".join(heads) + " |", "|---|" + "---:|" * (len(heads) - 1)]
    for mistake in MISTAKES:
        some = [case for case in cases if case["mistake"] == mistake]
        if some:
            lines.append(_row(mistake, some))
    lines.append(_row("**all**", cases))
    alone = [case for case in cases if not case["ties"]]
    lines += [_row("**all without ties**", alone), "", _rest(report)]
    return "\n".join(lines)


def _row(name: str, cases: list[dict[str, Any]]) -> str:
    quiet = [case for case in cases if not case["noise"]]
    noisy = [case for case in cases if case["noise"]]
    cells = [name, str(len(quiet)), str(sum(bool(case["ties"]) for case in quiet))]
    for some in (quiet, noisy):
        cells += [_share(some, key) for key in ("detected", "named", "listed", "tied")]
    return "| " + " | ".join(cells) + " |"


def _share(cases: list[dict[str, Any]], key: str) -> str:
    if not cases:
        return "–"
    percent = 100.0 * sum(case[key] for case in cases) / len(cases)
    # Rounded down: 100 means every one.
    return f"{np.floor(10.0 * percent) / 10.0:.1f}".removesuffix(".0")


def _rest(report: dict[str, Any]) -> str:
    cases, clean = report["cases"], report["clean"]
    lines = []
    if cases:
        quiet = [case for case in cases if not case["noise"]]
        names = [case["names"] for case in quiet if case["names"]]
        lines.append(
            f"{len(quiet):,} mistakes in {len(report['arms'])} arms, each without and with noise. "
            f"The first finding is in a spoiled link in {_share(quiet, 'placed')} % without noise. "
            f"It gives {statistics.fmean(names or [0]):.2f} names on average."
        )
    for lengths, what in ((False, "masses, centres and tensors"), (True, "lengths, too")):
        some = [pair for pair in clean if pair["lengths"] == lengths]
        if some:
            wrong = sum(bool(pair["findings"]) for pair in some)
            lines.append(
                f"False alarms in {len(some):,} pairs that differ by 1 to 5 % in {what}: {wrong}."
            )
    return "\n\n".join(fill(line, 100) for line in lines)


def _time(report: dict[str, Any]) -> str:
    times = [entry["seconds"] for entry in (*report["cases"], *report["clean"])]
    return (
        f"Pairing and diagnosis: median {1e3 * statistics.median(times):.0f} ms, "
        f"longest {1e3 * max(times):.0f} ms."
    )


def missed(report: dict[str, Any]) -> str:
    """What went wrong, one line each."""
    lines = []
    for case in report["cases"]:
        if not case["detected"] or not case["tied"]:
            what = "MISNAMED" if case["detected"] else "MISSED"
            links = ",".join(map(str, case["links"])) or "all"
            lines.append(
                f"{what} {case['arm']} {case['mistake']} link {links} ({case['how']}) "
                f"noise {case['noise']:g} ties {','.join(case['ties']) or '-'}: {case['answer']}"
            )
    for pair in report["clean"]:
        if pair["findings"]:
            what = "ALARM with lengths" if pair["lengths"] else "ALARM"
            said = "; ".join(pair["findings"])
            lines.append(f"{what} pair {pair['number']} {pair['arm']} {pair['level']:.3f}: {said}")
    return "\n".join(lines)


def page(report: dict[str, Any]) -> str:
    """docs/diagnosis-benchmark.md."""
    robots = len(report["arms"]) - 4
    about = fill(
        f"plants every known mistake in every link of {len(report['arms'])} arms and writes this "
        f"page. Seed {report['seed']}; arms: {', '.join(report['arms'])}. The first {robots} come "
        "from `example-robot-data`, `paper` is the DH table of the UR5, the chains are drawn at "
        "random.",
        100,
    )
    return f"""# How well the diagnosis finds mistakes

    python benchmarks/bench_diagnosis.py --write-docs

{about}

{tables(report)}

## How it is counted

**Planted** in the numbers as the file writes them: at the link's joint for a URDF, at its tip frame
for a DH table. `benchmarks/mutations.py` is written from the mistakes' names, not from
their code, and draws one of the ways to make each: which sign, which axis, which power of ten, the
whole vector or one component. A mistake that would change a number by less than 0.1 % is
not planted, nor one that moves no axis and no body. Rounded angles and 1/12 rounded are smaller by
nature and planted all the same.

**Detected**: there is a finding or, without noise, a number that stays unexplained. With noise
every number stays unexplained; there a finding counts, or the most different number of all if it
stands in the spoiled link and out from the others by a factor of {_STANDS_OUT:g}.

**Named**: the first finding, and only that, bears the planted id. Two ids joined into one finding
count as neither.

**Or equal**: the planted id is the first finding's, or one of those that this finding says would
explain the numbers as well.

**Or tied**: or the first finding's id is another mistake that leads to the very same arm, to four
digits, as the benchmark finds by planting all of them. A tensor whose frame was forgotten and one
with two axes exchanged are the same numbers where the frames differ by a quarter turn, and nobody
can tell which mistake was made. **Tied** counts such cases; the last row leaves them out. Ties are
sought from the right arm to the spoiled one and back: a tensor about the origin looks like another
one from which parallel axes were taken off. A twist about the next joint's own axis is that joint's
zero, whatever its size.

**Noise**: every mass, component of a centre and entry of a tensor that was not planted is
multiplied by 1 + U(−0.01, 0.01); the planted numbers keep their exact relation to the truth, and
the geometry stays exact. **Clean pairs** have noise alone, of a level drawn from 1 to 5 % for each
pair; any finding is a false alarm.

`--json FILE` keeps every case, `--missed` lists what was not found or misnamed.
"""


if __name__ == "__main__":
    sys.exit(main())
