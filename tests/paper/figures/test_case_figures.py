"""The pictures of the nine cases: every model in each, its finding above, the same file always."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from ur5check._paper.cases import case
from ur5check._paper.claims import OF_CASES
from ur5check._paper.evidence import gather
from ur5check._paper.figures.case_figure import draw_case
from ur5check._paper.figures.case_overview import draw_overview
from ur5check._paper.figures.figure_files import as_png, as_svg
from ur5check._paper.figures.figure_style import LOOKS, READING_ORDER
from ur5check._paper.reproduction import Reproduction, judge
from ur5check._reports.paper_summary import headline, headline_of_all

#: A picture on a page shall load at once.
MOST_BYTES = 60_000


@pytest.fixture(scope="module")
def reproduction() -> Reproduction:
    return judge(gather(lambda line: None), OF_CASES)


@pytest.mark.parametrize("number", range(1, 9))
def test_a_sweep_shows_every_models_curve(reproduction: Reproduction, number: int) -> None:
    figure = draw_case(reproduction, number)
    (axes,) = figure.axes
    lines = {str(line.get_label()).partition("\n")[0]: line for line in axes.get_lines()}
    for name, look in LOOKS.items():
        run = reproduction.run(number, name)
        assert np.asarray(lines[look.label].get_ydata()) == pytest.approx(run.watched)
        low, high = axes.get_ylim()
        assert low <= run.watched.min() <= run.watched.max() <= high
    legend = axes.get_legend()
    assert legend is not None
    assert [text.get_text().partition("\n")[0] for text in legend.get_texts()] == [
        LOOKS[name].label for name in READING_ORDER
    ]
    assert axes.get_xlabel() == f"angle of joint {case(number).swept} [°]"


def test_case_9_shows_six_torques_of_every_model(reproduction: Reproduction) -> None:
    figure = draw_case(reproduction, 9)
    for axes, joints in zip(figure.axes, (range(3), range(3, 6)), strict=True):
        for name, bars in zip(READING_ORDER, axes.containers, strict=True):
            heights = [bar.get_height() for bar in bars]
            assert heights == pytest.approx(reproduction.run(9, name).watched[list(joints)])


@pytest.mark.parametrize("number", range(1, 10))
def test_the_title_says_the_finding(reproduction: Reproduction, number: int) -> None:
    figure = draw_case(reproduction, number)
    title, below = (text.get_text() for text in figure.texts)
    assert title == headline(reproduction, number)
    assert below == f"case {number} of the paper: UR5 at rest, θ = {case(number).in_words()}"


def test_nothing_is_cut_off(reproduction: Reproduction) -> None:
    for figure in [*(draw_case(reproduction, k) for k in (2, 5, 9)), draw_overview(reproduction)]:
        figure.draw_without_rendering()
        tight, whole = figure.get_tightbbox(), figure.bbox_inches
        assert tight.x0 >= 0.0
        assert tight.y0 >= 0.0
        assert tight.x1 <= whole.x1
        assert tight.y1 <= whole.y1


@pytest.mark.parametrize("number", [4, 9])
def test_the_same_numbers_give_the_same_svg(reproduction: Reproduction, number: int) -> None:
    svg = as_svg(draw_case(reproduction, number))
    assert svg == as_svg(draw_case(reproduction, number))
    assert len(svg) <= MOST_BYTES
    root = ElementTree.fromstring(svg)  # noqa: S314 - our own text
    assert root.tag.endswith("svg")
    words = " ".join(re.findall(r">([^<>\n]+)</text>", svg.decode()))
    assert headline(reproduction, number) in words  # as text, to be searched and read aloud
    assert b"<dc:date>" not in svg


def test_the_overview_shows_nine_panels(reproduction: Reproduction) -> None:
    figure = draw_overview(reproduction)
    assert figure.texts[0].get_text() == headline_of_all(reproduction)
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert titles == [f"{k}  {case(k).claim}" for k in range(1, 10)]
    assert as_png(figure).startswith(b"\x89PNG")
