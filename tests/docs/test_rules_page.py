"""docs/rules.md is what the rules' records say."""

from __future__ import annotations

import runpy

from repository import REPOSITORY
from ur5check._rules.registry import all_rules

PAGE = (REPOSITORY / "docs" / "rules.md").read_text(encoding="utf-8")


def test_the_page_is_current():
    assert runpy.run_path(str(REPOSITORY / "docs" / "generate_rules.py"))["page"]() == PAGE


def test_every_rule_is_on_it():
    assert all(f"| `{rule}` " in PAGE for rule in all_rules())
