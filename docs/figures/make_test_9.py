"""Draws docs/figures/test-9-*.svg and .png: the paper's test 9, as printed and with right torques.

python docs/figures/make_test_9.py
"""

from __future__ import annotations

from pathlib import Path

from matplotlib.figure import Figure

import ur5check
from ur5check._paper.cases import case
from ur5check._paper.figures.figure_files import as_png, as_svg
from ur5check._paper.figures.static_hold_figure import draw_static_hold
from ur5check._simulation.static_hold import StaticHold, stand

HERE = Path(__file__).resolve().parent
MODELS = ("paper-listing", "appendix")


def measure(model: str) -> StaticHold:
    """The appendix's arm by MuJoCo, under the torques that hold a model."""
    plant, q = ur5check.load("appendix"), case(9).joint_angles()[0]
    return stand(plant, ur5check.load(model), q, engine="mujoco")


def figures() -> dict[str, Figure]:
    """What each file shows, by its name without a suffix."""
    return {f"test-9-{model}": draw_static_hold(measure(model)) for model in MODELS}


def main() -> None:
    """Write all four files."""
    for name, figure in figures().items():
        (HERE / f"{name}.svg").write_bytes(as_svg(figure))
        (HERE / f"{name}.png").write_bytes(as_png(figure))


if __name__ == "__main__":
    main()
