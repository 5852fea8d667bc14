"""Draws docs/figures/paper-case-1 … 9 (.svg and .png) and paper-all-cases.png.

python docs/figures/make_paper_cases.py
"""

from __future__ import annotations

from pathlib import Path

from ur5check._paper.cases import CASES
from ur5check._paper.claims import OF_CASES
from ur5check._paper.evidence import gather
from ur5check._paper.figures.case_figure import draw_case
from ur5check._paper.figures.case_overview import draw_overview
from ur5check._paper.figures.figure_files import as_png, as_svg
from ur5check._paper.reproduction import Reproduction, judge
from ur5check._reports.paper_summary import headline

HERE = Path(__file__).resolve().parent


def measure() -> Reproduction:
    """The nine cases, and what came of the claims on them."""
    return judge(gather(print), OF_CASES)


def svgs(r: Reproduction) -> dict[str, bytes]:
    """File name and content of every SVG; the same numbers give the same bytes."""
    return {f"paper-case-{c.number}.svg": as_svg(draw_case(r, c.number)) for c in CASES}


def main() -> None:
    """Write all files."""
    r = measure()
    for name, content in svgs(r).items():
        (HERE / name).write_bytes(content)
    for case in CASES:
        (HERE / f"paper-case-{case.number}.png").write_bytes(as_png(draw_case(r, case.number)))
        print(f"case {case.number}: {headline(r, case.number)}")
    (HERE / "paper-all-cases.png").write_bytes(as_png(draw_overview(r)))


if __name__ == "__main__":
    main()
