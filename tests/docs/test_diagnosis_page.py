"""docs/diagnosis.md says what the list of mistakes says, and its examples print what it prints."""

from __future__ import annotations

import re
import runpy
from typing import Any, get_args

import pytest

from repository import REPOSITORY
from ur5check._comparison.diagnosis import arm_mistakes as whole_arm
from ur5check._comparison.diagnosis.mistakes import MISTAKES
from ur5check._io.shipped_models import SHIPPED_MODELS

DOCS = REPOSITORY / "docs"


@pytest.fixture(scope="module")
def generator() -> dict[str, Any]:
    return runpy.run_path(str(DOCS / "generate_catalogue.py"))


def test_page_is_the_catalogues(generator: dict[str, Any]) -> None:
    # This runs the page's Python blocks, and holds what they print against what stands there.
    committed = (DOCS / "diagnosis.md").read_text(encoding="utf-8")
    assert committed == generator["page"](), "run: python docs/generate_catalogue.py"


def test_whole_arm_is_complete(generator: dict[str, Any]) -> None:
    assert set(generator["WHOLE_ARM"]) == set(get_args(whole_arm.Id))


def test_those_who_met_a_mistake_met_a_known_one(generator: dict[str, Any]) -> None:
    known = {mistake.id for mistake in MISTAKES} | set(get_args(whole_arm.Id))
    assert set(generator["MET"]) <= known
    for source in (source for sources in generator["MET"].values() for source in sources):
        thread = re.fullmatch(r"[\w.-]+/[\w.-]+#\d+", source)
        assert thread or source in SHIPPED_MODELS, source
