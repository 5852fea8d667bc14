"""Every integrator's error against its step, both on logarithmic scales: order p has slope p."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..._simulation.convergence import Convergence, Refinement
from .figure_style import BLUE, GREEN, GREY, INK, ORANGE, bare, new_figure, titled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_convergence", "headline"]


@dataclass(frozen=True)
class _Stroke:
    colour: str
    marker: str
    width: float
    dashes: tuple[float, ...] | None = None


# DART and two of MuJoCo's integrators give the same numbers: narrower lines on broader ones.
_STROKES = {
    "euler": _Stroke(ORANGE, "o", 5.0),
    "implicitfast": _Stroke(INK, "", 2.0),
    "semi-implicit": _Stroke("#F0E442", "", 1.6, (3, 3)),
    "implicit": _Stroke(GREY, "s", 1.8),
    "rk4": _Stroke(GREEN, "o", 2.4),
    "DOP853": _Stroke(BLUE, "o", 2.4),
}


def draw_convergence(c: Convergence) -> Figure:
    """The picture.  Raises UsageError where matplotlib is absent."""
    figure = new_figure(8.4, 5.0)
    axes = figure.add_axes((0.10, 0.115, 0.56, 0.68))
    bare(axes)
    for refinement in c.refinements:
        _line(axes, refinement)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("step [s]")
    axes.set_ylabel(f"largest joint error after {c.seconds:g} s [rad]")
    axes.legend(
        loc="center left", bbox_to_anchor=(1.03, 0.5), frameon=False, fontsize=9.5, labelspacing=0.9
    )
    turned = np.degrees(c.turned)
    below = f"UR5 under constant torques for {c.seconds:g} s, one joint turning by {turned:.0f}°"
    titled(figure, headline(c), below, left=0.035)
    return figure


def headline(c: Convergence) -> str:
    """What the picture shows."""
    exponent = int(np.ceil(np.log10(c.apart)))
    names = list(dict.fromkeys(r.engine for r in c.refinements))
    return f"At step zero {len(names)} engines agree to 1e{exponent} rad".replace("-", "−")


def _line(axes: Axes, r: Refinement) -> None:
    stroke = _STROKES[r.integrator]
    axes.plot(
        r.dt,
        r.error,
        color=stroke.colour,
        linewidth=stroke.width,
        linestyle="-" if stroke.dashes is None else (0, stroke.dashes),
        marker=stroke.marker or None,
        markersize=6,
        label=f"{r.engine}, {r.integrator}: order {r.order}\nmeasured {r.measured_order[-1]:.2f}",
    )
