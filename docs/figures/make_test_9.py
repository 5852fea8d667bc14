"""Draws docs/figures/test-9-*.svg and .png: the paper's test 9, as printed and with right torques.

python docs/figures/make_test_9.py
"""

from __future__ import annotations

from pathlib import Path

import ur5check
from ur5check.figures.files import as_png, as_svg
from ur5check.figures.standing_figure import draw_standing
from ur5check.paper.cases import case
from ur5check.simulation.standing import Standing, stand

HERE = Path(__file__).resolve().parent


def measure(model: str) -> Standing:
    """The appendix's arm by MuJoCo, under the torques that hold a model."""
    plant, q = ur5check.load("appendix"), case(9).joint_angles()[0]
    return stand(plant, ur5check.load(model), q, engine="mujoco")


def main() -> None:
    """Write all four files."""
    for model in ("paper-listing", "appendix"):
        figure = draw_standing(measure(model))
        (HERE / f"test-9-{model}.svg").write_bytes(as_svg(figure))
        (HERE / f"test-9-{model}.png").write_bytes(as_png(figure))


if __name__ == "__main__":
    main()
