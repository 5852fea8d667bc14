"""docs/closed-form.md runs as it stands, and prints what it says it prints."""

from __future__ import annotations

import contextlib
import io
import re
import shlex

import pytest

from repository import REPOSITORY
from ur5check._cli.main import main

PAGE = (REPOSITORY / "docs" / "closed-form.md").read_text(encoding="utf-8")
(COMMANDS, *_) = [block.splitlines() for block in re.findall(r"(?ms)^```sh\n(.*?)^```", PAGE)]
BLOCK = re.compile(r"^```python\n(.*?)^```\n+(?:```text\n(.*?)^```)?", re.M | re.S)


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_of_the_page_run(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    program, *arguments = shlex.split(command)
    assert program == "ur5check"
    assert main(arguments) == 0
    assert (tmp_path / arguments[-1]).stat().st_size > 0
    assert "in all" in capsys.readouterr().err


def test_code_prints_what_the_page_says():
    names: dict[str, object] = {}
    for code, expected in BLOCK.findall(PAGE):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, names)  # noqa: S102 - our own page
        assert printed.getvalue() == expected
