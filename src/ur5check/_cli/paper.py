"""Reproduce the paper (SSRN 3939013): its nine torque cases, inertia formulas,
limits, controller and simulation.  Each claim is confirmed, confirmed only after
a correction, or refuted.

Exit code 0: the paper was reproduced, whatever the verdicts.  1: the recursion
and Pinocchio disagree on the appendix, so the verdicts have no basis.
"""

from __future__ import annotations

import argparse
import os
from pathlib import Path
from typing import TYPE_CHECKING

from .._reports.report_formats import Contents
from .options import command_line, progress
from .output import check_folder, emit_files
from .report_output import add_report_options, check_reports, write_reports

if TYPE_CHECKING:
    from .._paper.reproduction import Reproduction

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = """\
examples:
  ur5check paper
  ur5check paper --figures figures -o paper.md
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `paper` takes."""
    parser.add_argument(
        "--figures",
        metavar="DIR",
        help="also plot the nine cases into this folder, as SVG and PNG (needs ur5check[figures])",
    )
    add_report_options(parser)


def run(args: argparse.Namespace) -> int:
    """Reproduce the paper, write report and figures; 1 if recursion and Pinocchio disagree."""
    from .._paper.reproduction import reproduce
    from .._reports.paper_document import paper_document
    from .._reports.paper_json import paper_json

    check_reports(args, _inputs())
    if args.figures is not None:
        _check_figures(args.figures)
    r = reproduce(lambda line: progress(args.quiet, line))
    pictures = {} if args.figures is None else _pictures(r, quiet=args.quiet)
    command = command_line("paper", args, ())
    contents = Contents(
        document=lambda target: paper_document(
            r,
            pictures=_places(args.figures, target.file),
            written_out=target.form.all_tables,
            command=command,
        ),
        report=lambda: paper_json(r, command=command),
    )
    if args.figures is not None:
        emit_files(pictures, args.figures, option="--figures")
        progress(args.quiet, f"drew {len(pictures)} pictures in {args.figures}")
    write_reports(args, contents)
    return 0 if r.trustworthy else 1


def _places(folder: str | None, output: str | None) -> dict[int, str]:
    """Where the report finds each case's picture: beside itself, or from here on stdout."""
    if folder is None:
        return {}
    home = Path.cwd() if output is None else Path(output).resolve().parent
    there = Path(os.path.relpath(Path(folder).resolve(), home)).as_posix()
    return {k: f"{there}/{_name(k)}.svg" for k in range(1, 10)}


def _name(case: int) -> str:
    return f"paper-case-{case}"


def _inputs() -> list[Path]:
    from .._io.shipped_models import SHIPPED_MODELS

    return [entry.path() for entry in SHIPPED_MODELS.values()]


def _check_figures(folder: str) -> None:
    from .._paper.figures.figure_style import matplotlib

    matplotlib()
    check_folder(folder, option="--figures")


def _pictures(r: Reproduction, *, quiet: bool) -> dict[str, bytes]:
    """File name and content of every picture: drawn before the first is written."""
    from .._paper.figures.case_figure import draw_case
    from .._paper.figures.case_overview import draw_overview
    from .._paper.figures.figure_files import as_png, as_svg

    progress(quiet, "drawing")
    drawn = {_name(k): draw_case(r, k) for k in range(1, 10)}
    drawn["paper-all-cases"] = draw_overview(r)
    pictures = {f"{name}.svg": as_svg(figure) for name, figure in drawn.items()}
    return pictures | {f"{name}.png": as_png(figure) for name, figure in drawn.items()}
