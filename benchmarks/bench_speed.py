"""How fast inverse dynamics is computed here, compared with Pinocchio, MuJoCo, Drake and JAX.

    python benchmarks/bench_speed.py [MODEL] [--only WHAT …] [-o FILE.md]

Also: matrices, longer arms, one state and many, the limit that memory sets, the first call of a
kernel, start-up, operation counts, and the parts of `validate` and `diff`.  All of it takes some
minutes.  Prints a report in Markdown; docs/performance.md holds one.
"""

from __future__ import annotations

import argparse
import shlex
import sys
from collections.abc import Sequence
from pathlib import Path

from speed.measure import QUESTIONS, measure
from speed.report import speed_document

import ur5check
from ur5check._errors import Ur5checkError
from ur5check._reports.markdown import render_markdown

#: The most states in one call: by default, and with --large.
_DEFAULT, _LARGE = 10**6, 10**7


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure and print."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    options = _parser().parse_args(words)
    try:
        found = measure(
            ur5check.load(options.model),
            only=options.only,
            states=options.states,
            rounds=options.rounds,
            threads=options.threads,
            lengths=options.lengths,
            up_to=_LARGE if options.large else min(_DEFAULT, options.states),
            seed=options.seed,
            progress=lambda line: print(line, file=sys.stderr),
        )
    except Ur5checkError as error:
        print(f"bench_speed: error: {error}", file=sys.stderr)
        return 2
    command = shlex.join(["python", "benchmarks/bench_speed.py", *words])
    text = render_markdown(speed_document(found, command=command))
    if options.output is None:
        print(text, end="")
    else:
        options.output.write_text(text, encoding="utf-8")
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model", nargs="?", default="appendix", help="default: appendix")
    parser.add_argument(
        "--only", nargs="+", default=[], metavar="WHAT", help=f"{', '.join(QUESTIONS)} (all)"
    )
    numbers = {
        "states": (10**6, "at which torques are computed"),
        "rounds": (5, "whose median is reported"),
        "threads": (2, "measured beside one thread"),
        "seed": (0, "of states and longer arms"),
    }
    for name, (default, meaning) in numbers.items():
        parser.add_argument(
            f"--{name}", type=int, default=default, metavar="N", help=f"{meaning} ({default})"
        )
    parser.add_argument(
        "--lengths",
        type=int,
        nargs="+",
        default=[6, 12, 24, 48],
        metavar="N",
        help="joints of the longer arms (6 12 24 48)",
    )
    parser.add_argument(
        "--large", action="store_true", help="up to 1e7 states in one call (needs 8 GB)"
    )
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="default: stdout")
    return parser


if __name__ == "__main__":
    raise SystemExit(main())
