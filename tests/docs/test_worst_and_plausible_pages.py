"""The pages on the worst case and on plausibility run as they stand, and print what they say."""

from __future__ import annotations

import contextlib
import io
import re

import pytest

from repository import REPOSITORY

DOCS = REPOSITORY / "docs"
BLOCK = re.compile(r"^```python\n(.*?)^```\n+(?:```text\n(.*?)^```)?", re.M | re.S)


def printed_and_promised(page: str) -> list[tuple[str, str]]:
    """What each code block of a page prints, and what the block after it says that it does."""
    names: dict[str, object] = {}
    pairs = []
    for code, promised in BLOCK.findall((DOCS / page).read_text(encoding="utf-8")):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, names)  # noqa: S102 - our own pages
        pairs.append((printed.getvalue(), promised))
    return pairs


@pytest.mark.parametrize(("page", "blocks"), [("worst-case.md", 4), ("plausibility.md", 1)])
def test_code_prints_what_the_page_says(page: str, blocks: int) -> None:
    pairs = printed_and_promised(page)
    assert len(pairs) == blocks
    for printed, promised in pairs:
        assert printed
        assert printed == promised
