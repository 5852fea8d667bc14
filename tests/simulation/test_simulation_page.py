"""docs/simulation.md: its commands and its code run, and its figures say what is measured."""

from __future__ import annotations

import contextlib
import io
import re
import shlex
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from moving_arms import APPENDIX, CASE_9

import ur5check
from ur5check.cli.main import main
from ur5check.figures.convergence_figure import draw_convergence
from ur5check.simulation.convergence import Convergence, Refinement
from ur5check.simulation.standing import stand

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "simulation.md").read_text(encoding="utf-8")
COMMANDS = re.search(r"```sh\n(.*?)```", PAGE, re.DOTALL).group(1).splitlines()


@pytest.mark.parametrize(("command", "code"), list(zip(COMMANDS, (1, 0), strict=True)))
def test_commands_run(command, code, capsys):
    _, *arguments = shlex.split(command)
    assert main(arguments) == code
    assert ("STANDS" if code == 0 else "MOVES") in capsys.readouterr().out


def test_code_prints_what_the_page_says():
    ((code, promised),) = re.findall(r"```python\n(.*?)```\n+```text\n(.*?)```", PAGE, re.DOTALL)
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(code, {})  # noqa: S102 - our own page
    assert printed.getvalue() == promised


def test_energies_are_those_of_the_page():
    """To the one digit that the page gives, and within a factor of 10 where rounding decides."""
    paper = ur5check.load("paper")
    euler, rk4, own = (
        stand(APPENDIX, paper, CASE_9, engine=engine, integrator=name, seconds=0.2).energy.relative
        for engine, name in (("mujoco", "euler"), ("mujoco", "rk4"), ("own", None))
    )
    assert round(euler, 3) == 5e-3
    assert rk4 < 1e-10
    assert own < 1e-9


def test_the_convergence_figure_tells_a_disagreement():
    """The title is measured: engines that part by a milliradian are not said to agree better."""

    def study(off: float) -> Convergence:
        dt = np.array([0.1, 0.05])
        q, limit = np.zeros((2, 1)), np.array([off])
        one = Refinement("A", "rk4", 4, dt, q, dt**4, np.zeros(1), 0.0)
        two = Refinement("B", "semi-implicit", 1, dt, q, dt, limit, off)
        return Convergence(APPENDIX, 1.0, 1.0, 1e-12, (one, two))

    titles = [draw_convergence(study(off)).texts[0].get_text() for off in (6e-8, 6e-4)]
    assert titles[0] == "At step zero 2 engines agree to 1e−7 rad"
    assert titles[1] == "At step zero 2 engines agree to 1e−3 rad"


@pytest.mark.parametrize("name", ["convergence", "test-9-paper-listing", "test-9-appendix"])
def test_committed_pictures_are_pictures(name):
    root = ElementTree.parse(DOCS / "figures" / f"{name}.svg").getroot()  # noqa: S314 - our own
    assert root.tag.endswith("svg")
    assert (DOCS / "figures" / f"{name}.png").read_bytes().startswith(b"\x89PNG")
