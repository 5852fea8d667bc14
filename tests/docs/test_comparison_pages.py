"""The pages on comparison run as they stand, and print what they say they print."""

from __future__ import annotations

import contextlib
import io
import re

import pytest

from repository import REPOSITORY

DOCS = REPOSITORY / "docs"
PAGES = ("identifiability.md", "error-budget.md", "attribution.md")
BLOCK = re.compile(r"^```python\n(.*?)^```\n+(?:```text\n(.*?)^```)?", re.M | re.S)


@pytest.mark.parametrize("page", PAGES)
def test_code_prints_what_the_page_says(page: str) -> None:
    names: dict[str, object] = {}
    blocks = BLOCK.findall((DOCS / page).read_text(encoding="utf-8"))
    assert blocks
    for code, expected in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, names)  # noqa: S102 - our own pages
        assert printed.getvalue() == expected
