"""Draws docs/figures/convergence.svg and .png: every integrator's error against its step.

python docs/figures/make_convergence.py
"""

from __future__ import annotations

from pathlib import Path

import ur5check
from ur5check._comparison.arm_pair import pair_up
from ur5check._paper.cases import case
from ur5check._paper.figures.convergence_figure import draw_convergence
from ur5check._paper.figures.figure_files import as_png, as_svg
from ur5check._simulation.convergence import Convergence, convergence

HERE = Path(__file__).resolve().parent


def measure() -> Convergence:
    """Test 9 again: the appendix's arm under the torques that hold the controller's DH, for 1 s."""
    plant, q = ur5check.load("appendix"), case(9).joint_angles()[0]
    tau = ur5check.gravity_torque(pair_up(plant, ur5check.load("paper")).b, q)
    return convergence(plant, q, tau, progress=print)


def main() -> None:
    """Write both files; half a minute."""
    c = measure()
    figure = draw_convergence(c)
    (HERE / "convergence.svg").write_bytes(as_svg(figure))
    (HERE / "convergence.png").write_bytes(as_png(figure))
    for r in c.refinements:
        orders = " ".join(f"{order:.2f}" for order in r.measured_order)
        print(
            f"{r.engine:9} {r.integrator:14} orders {orders}; limit off by {r.limit_error:.1e} rad"
        )
    print(f"apart at step zero: {c.apart:.1e} rad; error of the reference: {c.reference_error:.1e}")


if __name__ == "__main__":
    main()
