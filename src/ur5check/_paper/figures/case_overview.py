"""All nine cases on one sheet, small."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..._arguments import instance
from ..._reports.paper_summary import headline_of_all
from ..cases import CASES
from ..reproduction import Reproduction
from .case_figure import draw_bars, draw_curves, legend_entries
from .figure_style import GREY, INK, new_figure, titled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["draw_overview"]


def draw_overview(r: Reproduction) -> Figure:
    """Draw all nine cases of the paper on one sheet, each with its claim above it.

    Parameters
    ----------
    r : Reproduction
        From `reproduce`.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    UsageError
        For another type, or where matplotlib is not installed.

    Examples
    --------
    >>> import ur5check
    >>> len(ur5check.draw_overview(ur5check.reproduce()).axes)
    9
    """
    instance("r", r, Reproduction, "see ur5check.reproduce")
    figure = new_figure(9.6, 8.0)
    panels = figure.subplots(3, 3)
    figure.subplots_adjust(left=0.06, right=0.985, top=0.845, bottom=0.095, hspace=0.7, wspace=0.25)
    for case, axes in zip(CASES, panels.flat, strict=True):
        runs = [run for run in r.cases if run.case.number == case.number]
        if case.watched is None:
            draw_bars(axes, runs, range(6))
            axes.set_xticklabels([f"τ{i}" for i in range(1, 7)])
            shown = "all torques [N m]"
        else:
            draw_curves(axes, runs, thickness=0.7)
            shown = f"τ{case.watched} [N m] over θ{case.swept} [°]"
        axes.tick_params(labelsize=8, labelcolor=GREY)
        axes.set_title(f"{case.number}  {case.claim}", loc="left", fontsize=10, color=INK, pad=17)
        axes.text(0.0, 1.045, shown, transform=axes.transAxes, fontsize=8.5, color=GREY)
    titled(
        figure,
        headline_of_all(r),
        "UR5 at rest; above each curve, what the paper claims of it",
        left=0.015,
    )
    handles, labels = legend_entries(panels[0][0])
    names = [label.partition("\n")[0] for label in labels]
    figure.legend(handles, names, loc="lower center", ncols=5, frameon=False, fontsize=9)
    return figure
