"""docs/simulation.md: its commands and its code run, and its figures say what is measured."""

from __future__ import annotations

import contextlib
import io
import re
import runpy
import shlex

import numpy as np
import pytest
from moving_arms import APPENDIX, CASE_9

import ur5check
from repository import REPOSITORY
from ur5check._cli.main import main
from ur5check._paper.figures.convergence_figure import draw_convergence
from ur5check._paper.figures.figure_files import as_svg
from ur5check._simulation.convergence import Convergence, Refinement
from ur5check._simulation.joint_range import joint_range_of
from ur5check._simulation.static_hold import stand

DOCS = REPOSITORY / "docs"
PAGE = (DOCS / "simulation.md").read_text(encoding="utf-8")
COMMANDS = re.search(r"```sh\n(.*?)```", PAGE, re.DOTALL).group(1).splitlines()
WORDS = re.compile(r">([^<>\n]+)</text>")


def rows(head: str) -> list[list[str]]:
    """The cells of the page's table whose first column is called `head`."""
    table = PAGE.split(f"| {head} |")[1].split("\n\n")[0]
    return [line.strip("| ").split(" | ") for line in table.splitlines()[2:]]


def committed(name: str) -> str:
    """A picture's SVG; its PNG is there, too."""
    assert (DOCS / "figures" / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    return (DOCS / "figures" / f"{name}.svg").read_text(encoding="utf-8")


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


@pytest.mark.parametrize("row", rows("torques that hold"), ids=lambda row: row[0])
def test_the_table_of_test_9_is_a_run(row):
    model, given, verdict_, after = row
    s = stand(APPENDIX, ur5check.load(model.strip("`")), CASE_9, engine="mujoco")
    assert f"{s.given[1]:+.2f} N m".replace("-", "−") == given
    assert f"needs {s.needed[1]:.2f} N m".replace("-", "−") in PAGE
    assert verdict_ == ("stands" if s.stands else "moves")
    if s.stands:
        assert after == "5 s, drift below 0.001 mm"  # rounding, grown for 18 times 0.28 s
        assert 1e3 * s.tool_drift.max() < 0.001
    else:
        limits, end = joint_range_of(APPENDIX, CASE_9), s.motion.q[-1]
        joint = np.minimum(end - limits.lower, limits.upper - end).argmin() + 1
        assert after == f"{s.motion.t[-1]:.2f} s joint {joint} meets its limit"
    assert f"by a factor e every {1.0 / s.growth:.2f} s" in PAGE


def test_energies_are_those_of_the_page():
    """To the one digit that the page gives, and within a factor of 10 where rounding decides."""
    paper = ur5check.load("paper")
    euler, dart, rk4, own = (
        stand(APPENDIX, paper, CASE_9, engine=engine, integrator=name, seconds=0.2).energy.relative
        for engine, name in (
            ("mujoco", "euler"),
            ("dart", None),
            ("mujoco", "rk4"),
            ("ur5check", None),
        )
    )
    assert round(euler, 3) == round(dart, 3) == 5e-3
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


def test_pictures_of_test_9_say_what_is_measured():
    """Word by word; the bytes depend on matplotlib's version."""
    drawn = runpy.run_path(str(DOCS / "figures" / "make_test_9.py"))["figures"]()
    assert sorted(drawn) == ["test-9-appendix", "test-9-paper-listing"]
    for name, figure in drawn.items():
        words = WORDS.findall(as_svg(figure).decode())
        assert any(word.startswith(("It stands: 5 s", "It moves: joint 2")) for word in words)
        assert WORDS.findall(committed(name)) == words


def test_the_convergence_picture_says_what_the_table_says():
    """Its script needs half a minute: the table is drawn instead, and every word compared.

    That errors fall at these orders is measured on a gentler motion in `test_convergence`.
    """
    refinements = []
    for mover, order, measured, limit in rows("integrator"):
        engine, off = mover.split()[0].rstrip(","), float(limit.removesuffix(" rad"))
        error = np.array([2.0 ** float(measured), 1.0])
        for name in re.findall(r"`(.*?)`", mover):
            refinements.append(
                Refinement(
                    engine, name, int(order), np.array([0.2, 0.1]), np.zeros((2, 1)), error,
                    np.array([off]), off,
                )
            )  # fmt: skip
    turned = np.radians(float(re.search(r"joint 5 turns by (\d+)°", PAGE).group(1)))
    study = Convergence(APPENDIX, 1.0, turned, 1e-9, tuple(refinements))
    words = WORDS.findall(as_svg(draw_convergence(study)).decode())
    assert sorted(WORDS.findall(committed("convergence"))) == sorted(words)
    assert f"All agree to {study.apart:.0e} rad".replace("e-0", "e-") in PAGE
