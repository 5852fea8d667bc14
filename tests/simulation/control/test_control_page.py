"""docs/control.md: its code runs as it stands, and prints what the page says."""

from __future__ import annotations

import contextlib
import io
import re

from repository import REPOSITORY

PAGE = (REPOSITORY / "docs" / "control.md").read_text(encoding="utf-8")


def test_code_prints_what_the_page_says():
    names: dict[str, object] = {}
    pairs = re.findall(r"```python\n(.*?)```\n+```text\n(.*?)```", PAGE, re.DOTALL)
    assert len(pairs) == PAGE.count("```python") == 4
    for code, promised in pairs:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, names)  # noqa: S102
        assert printed.getvalue() == promised
