"""The README's picture: what its title says is what is measured."""

from __future__ import annotations

import runpy
from xml.etree import ElementTree

import pytest

from repository import REPOSITORY

FIGURES = REPOSITORY / "docs" / "figures"


def test_case_2_says_what_is_measured() -> None:
    script = runpy.run_path(str(FIGURES / "make_case_2.py"))
    case = script["measure"]()
    assert case.excess() == pytest.approx(0.7451, abs=5e-5)
    assert case.opposed()
    title = script["draw"](case).axes[0].get_title(loc="left")
    assert title == "Lost minus signs: torque 74.5 % too large, of opposite sign"


def test_committed_pictures_are_pictures() -> None:
    root = ElementTree.parse(FIGURES / "case-2.svg").getroot()  # noqa: S314 - our own file
    assert root.tag.endswith("svg")
    assert (FIGURES / "case-2.png").read_bytes().startswith(b"\x89PNG")
