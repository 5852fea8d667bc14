"""Draws docs/figures/case-2.svg and .png: one joint, one sweep, three sets of numbers.

python docs/figures/make_case_2.py
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import matplotlib as mpl

mpl.use("Agg")  # a file is drawn, no window
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

import ur5check
from ur5check._engines.adapters.pinocchio import PinocchioEngine
from ur5check._robot.transforms import Array

HERE = Path(__file__).resolve().parent
ORANGE, BLUE, INK = "#D55E00", "#0072B2", "#333333"  # Okabe and Ito: told apart by every eye


@dataclass(frozen=True, eq=False)
class Case2:
    """Torque of joint 2 [N m] while joint 2 sweeps 0…360° and everything else stays at 0.

    angle : [°];  listing, paper : our recursion, under the listing's gravity;  appendix : Pinocchio
    """

    angle: Array
    listing: Array
    paper: Array
    appendix: Array

    def excess(self) -> float:
        """By which part the listing's amplitude exceeds that of the controller's DH."""
        return float(np.abs(self.listing).max() / np.abs(self.paper).max()) - 1.0

    def opposed(self) -> bool:
        """Whether the listing pulls the other way, all along the sweep."""
        return float(self.listing @ self.paper) < 0.0


def measure() -> Case2:
    """The paper's case 2, computed."""
    angle = np.arange(361.0)
    q = np.zeros((361, 6))
    q[:, 1] = np.radians(angle)
    printed = ur5check.load("paper-listing")
    controller = ur5check.load("paper").with_gravity(printed.gravity)
    listing, paper = (ur5check.gravity_torque(arm, q)[:, 1] for arm in (printed, controller))
    appendix = PinocchioEngine(ur5check.load("appendix")).gravity_torque(q)[:, 1]
    return Case2(angle, listing, paper, appendix)


def draw(case: Case2) -> Figure:
    """The figure, with the measured message as its title."""
    plt.rcParams.update({"font.size": 11, "svg.hashsalt": "case-2", "svg.fonttype": "path"})
    figure, axes = plt.subplots(figsize=(8.4, 4.4))
    axes.axhline(0.0, color="#BBBBBB", linewidth=0.8, zorder=0)
    axes.plot(case.angle, case.listing, color=ORANGE, linewidth=2.6)
    axes.plot(case.angle, case.paper, color=BLUE, linewidth=2.6)
    axes.plot(case.angle, case.appendix, color=INK, linewidth=1.6, linestyle=(0, (4, 2)))
    labels = (
        (case.listing, 0, ORANGE, "the paper's listing,\nas printed"),
        (case.paper, 18, BLUE, "the controller's DH"),
        (case.appendix, -18, INK, "the appendix URDF,\nby Pinocchio"),
    )
    for curve, shift, colour, text in labels:
        axes.annotate(
            f"{text}: ±{np.abs(curve).max():.0f} N m",
            (360, curve[-1]),
            xytext=(8, shift),
            textcoords="offset points",
            va="center",
            color=colour,
        )
    turned = ", of opposite sign" if case.opposed() else ""
    axes.set_title(
        f"Lost minus signs: torque {100 * case.excess():.1f} % too large{turned}",
        loc="left",
        fontsize=13,
        fontweight="bold",
        color=INK,
        pad=24,
    )
    axes.text(
        0.0,
        1.03,
        "UR5 at rest, joint 2 sweeps, all other joints at 0°: case 2 of the paper",
        transform=axes.transAxes,
        color="#666666",
    )
    axes.set_xlabel("angle of joint 2 [°]")
    axes.set_ylabel("torque of joint 2 [N m]")
    axes.set_xlim(0, 360)
    axes.set_xticks(range(0, 361, 90))
    axes.set_ylim(-105, 105)
    axes.set_yticks(range(-100, 101, 50))
    axes.spines[["top", "right"]].set_visible(False)
    figure.subplots_adjust(left=0.095, right=0.745, top=0.83, bottom=0.13)
    return figure


def main() -> None:
    """Write both files; the same numbers give the same SVG."""
    case = measure()
    figure = draw(case)
    figure.savefig(HERE / "case-2.svg", metadata={"Date": None})
    figure.savefig(HERE / "case-2.png", dpi=110)
    amplitudes = (float(np.abs(curve).max()) for curve in (case.listing, case.paper, case.appendix))
    print("amplitudes [N m]: listing {:.2f}, paper {:.2f}, appendix {:.2f}".format(*amplitudes))
    print(f"listing over paper: {1 + case.excess():.4f}, opposed: {case.opposed()}")


if __name__ == "__main__":
    main()
