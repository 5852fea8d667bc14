"""One test case of the paper, all models overlaid; the title states the result."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..._arguments import instance
from ..._reports.paper_summary import headline
from ..case_runs import Run
from ..cases import SWEEP
from ..cases import case as paper_case
from ..reproduction import Reproduction
from .figure_style import GREY, LOOKS, READING_ORDER, bare, new_figure, titled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_bars", "draw_case", "draw_curves", "legend_entries"]

_LEFT = 0.09


def draw_case(r: Reproduction, number: int) -> Figure:
    """Draw the torque of one of the paper's cases, for every model.

    Parameters
    ----------
    r : Reproduction
        From `reproduce`.
    number : int
        Of the case, 1 … 9.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    UsageError
        For another type or number, or where matplotlib is not installed.

    Examples
    --------
    >>> import ur5check
    >>> figure = ur5check.draw_case(ur5check.reproduce(), 2)
    >>> figure.axes[0].get_ylabel()
    'torque of joint 2 [N m]'
    """
    instance("r", r, Reproduction, "see ur5check.reproduce")
    paper_case(number)
    return _posture(r) if number == 9 else _sweep(r, number)


def draw_curves(axes: Axes, runs: list[Run], *, thickness: float = 1.0) -> None:
    """The watched torque of one case over the turn, for every model; thickness : of all lines."""
    by_model = {run.model.name: run for run in runs}
    bare(axes)
    for name, look in LOOKS.items():
        run = by_model[name]
        line = look.line(thickness)
        axes.plot(np.degrees(SWEEP), run.watched, label=f"{look.label}\n{_size(run)}", **line)
    largest = max(run.peak for run in runs)
    # A zero torque is a flat line in the middle.
    axes.set_ylim(*((-1.15 * largest, 1.15 * largest) if largest else (-1.0, 1.0)))
    axes.set_xlim(0, 360)
    axes.set_xticks(range(0, 361, 90))
    axes.locator_params(axis="y", nbins=7)


def draw_bars(axes: Axes, runs: list[Run], joints: range) -> None:
    """The torques of some joints, from 0, in one posture: a bar for every model."""
    by_model = {run.model.name: run for run in runs}
    width = 0.8 / len(READING_ORDER)
    bare(axes)
    for k, name in enumerate(READING_ORDER):
        look, torque = LOOKS[name], by_model[name].watched
        places = [j + 1 + (k - 2) * width for j in joints]
        axes.bar(places, torque[list(joints)], width, color=look.colour, label=look.label)
    for j in joints:
        if not any(abs(run.watched[j]) > run.rounding for run in runs):
            axes.annotate(
                "0", (j + 1, 0), (0, 4), textcoords="offset points", ha="center", color=GREY
            )
    axes.set_xticks([j + 1 for j in joints])
    axes.tick_params(axis="x", length=0)
    axes.locator_params(axis="y", nbins=7)


def legend_entries(axes: Axes) -> tuple[list[Any], list[str]]:
    """Handles and labels in reading order: what the paper printed comes first."""
    handles, labels = axes.get_legend_handles_labels()
    names = [label.partition("\n")[0] for label in labels]
    order = [names.index(LOOKS[name].label) for name in READING_ORDER]
    return [handles[k] for k in order], [labels[k] for k in order]


def _legend(axes: Axes) -> None:
    axes.legend(
        *legend_entries(axes),
        loc="center left",
        bbox_to_anchor=(1.03, 0.5),
        frameon=False,
        fontsize=9.5,
        labelspacing=0.9,
        handlelength=2.6,
    )


def _sweep(r: Reproduction, number: int) -> Figure:
    runs = [run for run in r.cases if run.case.number == number]
    case = runs[0].case
    figure = new_figure(8.4, 4.4)
    axes = figure.add_axes((_LEFT, 0.125, 0.625, 0.655))
    draw_curves(axes, runs)
    axes.set_xlabel(f"angle of joint {case.swept} [°]")
    axes.set_ylabel(f"torque of joint {case.watched} [N m]")
    titled(
        figure,
        headline(r, number),
        f"case {number} of the paper: UR5 at rest, θ = {case.in_words()}",
        left=_LEFT - 0.065,
    )
    _legend(axes)
    return figure


def _posture(r: Reproduction) -> Figure:
    """Six torques a model: those of the heavy joints and of the wrist on scales of their own."""
    runs = {run.model.name: run for run in r.cases if run.case.number == 9}
    figure = new_figure(8.4, 4.4)
    panels = (
        (figure.add_axes((_LEFT, 0.125, 0.27, 0.655)), range(3), "torque [N m]"),
        (figure.add_axes((_LEFT + 0.355, 0.125, 0.27, 0.655)), range(3, 6), ""),
    )
    for axes, joints, label in panels:
        draw_bars(axes, list(runs.values()), joints)
        axes.set_xticklabels([f"joint {j + 1}" for j in joints])
        axes.set_ylabel(label)
    titled(
        figure,
        headline(r, 9),
        f"case 9 of the paper: UR5 at rest, θ = {runs['appendix'].case.in_words()}",
        left=_LEFT - 0.065,
    )
    _legend(panels[-1][0])
    return figure


def _size(run: Run) -> str:
    return f"±{run.peak:#.3g} N m" if run.peak else "0 N m"
