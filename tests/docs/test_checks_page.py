"""docs/checks.md says what the registry says, and each check has its place in the text."""

from __future__ import annotations

import runpy

from repository import REPOSITORY
from ur5check._validation.laws import LAWS
from ur5check._validation.pair_laws import BODIES, PAIRS

DOCS = REPOSITORY / "docs"


def test_page_is_the_registrys() -> None:
    generator = runpy.run_path(str(DOCS / "generate_checks.py"))
    committed = (DOCS / "checks.md").read_text(encoding="utf-8")
    assert committed == generator["page"](), "run: python docs/generate_checks.py"


def test_every_check_is_explained() -> None:
    template = (DOCS / "checks.in.md").read_text(encoding="utf-8")
    explained = ("-reference", "-inverse")  # agreement needs no formula beyond its own
    for check in (*LAWS, *BODIES, *PAIRS):
        assert check.id.endswith(explained) or f"`{check.id}`" in template, check.id  # type: ignore[attr-defined]
