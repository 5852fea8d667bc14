"""Test 9: the falling arm seen from the side, and its drift over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..._dynamics.kinematics import link_frames
from ..._robot.transforms import Array
from ..._simulation.static_hold import STILL, StaticHold
from .figure_style import BLUE, GREY, INK, ORANGE, bare, new_figure, titled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_static_hold", "headline"]

_SHOTS = 6  # postures of the arm that are drawn
_SHOWN = 0.4  # s of the motion that are drawn: later postures overlap too much


def draw_static_hold(s: StaticHold) -> Figure:
    """The picture.  Raises UsageError where matplotlib is absent."""
    figure = new_figure(9.0, 4.6)
    arm_axes = figure.add_axes((0.03, 0.09, 0.37, 0.70))
    drift_axes = figure.add_axes((0.51, 0.135, 0.45, 0.62))
    _arm(arm_axes, s)
    _drift(drift_axes, s)
    how = "held constant" if s.held else "recomputed at each step"
    below = f"{s.pair.a.label}, moved by {s.mover.name}; torques that hold {s.pair.b.label}, {how}"
    titled(figure, headline(s), below, left=0.03)
    return figure


def headline(s: StaticHold) -> str:
    """What the picture shows."""
    if s.stands:
        return f"It stands: {s.seconds:g} s, and the tool is within {1e3 * STILL:g} mm of its place"
    gap = s.given - s.needed
    joint = int(np.abs(gap).argmax())
    given, needed = (f"{tau[joint]:+.1f}".replace("-", "−") for tau in (s.given, s.needed))
    return f"It moves: joint {joint + 1} is given {given} N m and needs {needed}"


def _arm(axes: Axes, s: StaticHold) -> None:
    """The chain at a few instants, in the vertical plane that shows most of it."""
    until = min(_SHOWN, float(s.motion.t[-1]))
    picked = np.searchsorted(s.motion.t, np.linspace(0.0, until, _SHOTS))
    chains = np.array([_corners(s, int(k)) for k in picked])
    plane = _widest_direction(chains)
    views = np.stack([chains @ plane, chains[..., 2]], axis=-1)
    colour = BLUE if s.stands else ORANGE
    for view, strength in zip(views[1:], np.linspace(0.2, 1.0, _SHOTS - 1), strict=True):
        axes.plot(*view.T, color=colour, alpha=strength, linewidth=3.0, solid_capstyle="round")
    axes.plot(*views[0].T, color=INK, linewidth=5.0, solid_capstyle="round", zorder=3)
    axes.plot(*views[0, -1], "o", color="white", markeredgecolor=INK, markersize=8, zorder=4)
    axes.axhline(0.0, color="#BBBBBB", linewidth=1.0, zorder=0)
    axes.set_aspect("equal")
    axes.margins(0.12)
    axes.set_axis_off()
    said = "the start, and the same after it" if s.stands else f"the start, and {until:.2g} s of it"
    axes.text(
        0.0,
        -0.04,
        f"side view: {said}\ngrey line: the height of the base",
        transform=axes.transAxes,
        va="top",
        color=GREY,
    )


def _drift(axes: Axes, s: StaticHold) -> None:
    """How far the tool is away, on a scale that shows micrometres and metres."""
    bare(axes)
    t, drift = s.motion.t[1:], 1e3 * s.tool_drift[1:]
    axes.axhspan(1e-12, 1e3 * STILL, color="#EAF3F8", zorder=0)
    axes.plot(t, np.maximum(drift, 1e-12), color=BLUE if s.stands else ORANGE, linewidth=2.4)
    axes.set_yscale("log")
    axes.set_ylim(1e-12, 1e4)
    axes.set_yticks([1e-12, 1e-8, 1e-4, 1e0, 1e4])
    axes.set_xlim(0.0, s.seconds)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("tool from its place [mm]")
    axes.text(
        0.98 * s.seconds, 0.6e3 * STILL, "stands", ha="right", va="top", color=BLUE, fontsize=10
    )
    if s.motion.stopped:
        end = (float(t[-1]), float(drift[-1]))
        axes.plot(*end, "o", color=ORANGE, markersize=6)
        axes.annotate(
            f"a joint meets its\nlimit at {t[-1]:.2f} s",
            end,
            (10, -8),
            textcoords="offset points",
            color=GREY,
            va="top",
        )


def _corners(s: StaticHold, k: int) -> Array:
    """Base, link ends and joints of the arm at instant k, shape (n + 1, 3) [m]."""
    arm = s.pair.a
    frames = link_frames(arm, s.motion.q[min(k, len(s.motion.t) - 1)])
    return np.vstack([np.zeros(3), arm.base.p, frames[:, :3, 3]])


def _widest_direction(chains: Array) -> Array:
    """The horizontal direction along which the points are spread most, shape (3,)."""
    flat = chains.reshape(-1, 3)[:, :2]
    _, _, axes = np.linalg.svd(flat - flat.mean(axis=0), full_matrices=False)
    return np.array([*axes[0], 0.0])
