"""docs/diagnosis.md lists the known mistakes, and its examples print what the page shows."""

from __future__ import annotations

import runpy

from repository import REPOSITORY

DOCS = REPOSITORY / "docs"


def test_page_is_current() -> None:
    # This runs the page's Python blocks, and compares what they print with what stands there.
    page = runpy.run_path(str(DOCS / "generate_mistakes.py"))["page"]
    committed = (DOCS / "diagnosis.md").read_text(encoding="utf-8")
    assert committed == page(), "run: python docs/generate_mistakes.py"
