"""docs/paper-claims.md is a run of `ur5check paper`; its commands, code and pictures do too."""

from __future__ import annotations

import contextlib
import io
import re
import runpy
import shlex
from pathlib import Path
from typing import Any

import pytest

from repository import REPOSITORY
from ur5check._cli.main import main
from ur5check._paper import reproduction as room
from ur5check._paper.reproduction import Reproduction, reproduce

DOCS = REPOSITORY / "docs"
PAGE = (DOCS / "paper-claims.md").read_text(encoding="utf-8")
COMMANDS = [
    line.partition("#")[0].strip()
    for block in re.findall(r"```sh\n(.*?)```", PAGE, re.DOTALL)
    for line in block.splitlines()
]
WORDS = re.compile(r">([^<>\n]+)</text>")


@pytest.fixture(scope="module")
def reproduction() -> Reproduction:
    return reproduce()


@pytest.fixture
def at_hand(monkeypatch: pytest.MonkeyPatch, reproduction: Reproduction) -> None:
    """One run for all of the page."""
    monkeypatch.setattr(room, "reproduce", lambda progress=None: reproduction)


def test_page_is_a_run(reproduction: Reproduction) -> None:
    generator = runpy.run_path(str(DOCS / "generate_paper_claims.py"))
    assert generator["page"](reproduction) == PAGE, "run: python docs/generate_paper_claims.py"


@pytest.mark.usefixtures("at_hand")
def test_commands_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert len(COMMANDS) == 3
    for command in COMMANDS:
        _, *arguments = shlex.split(command)
        assert main(arguments) == 0, capsys.readouterr().err
    assert (tmp_path / "paper.md").read_text("utf-8").startswith("# The paper, claim by claim")
    linked = re.findall(r"!\[Case \d\. .*?\]\((.*?)\)", (tmp_path / "paper.md").read_text("utf-8"))
    assert linked == [f"figures/paper-case-{k}.svg" for k in range(1, 10)]
    names = [f"paper-case-{k}" for k in range(1, 10)] + ["paper-all-cases"]
    expected = {f"{name}.{kind}" for name in names for kind in ("svg", "png")}
    assert {path.name for path in (tmp_path / "figures").iterdir()} == expected


@pytest.mark.usefixtures("at_hand")
def test_code_runs(reproduction: Reproduction) -> None:
    (code,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    names: dict[str, Any] = {}
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(code, names)  # noqa: S102 - our own page
    assert printed.getvalue().count("\n") == len(reproduction.verdicts)
    assert names["curve"].shape == (361,)


def test_committed_pictures_say_what_is_measured(reproduction: Reproduction) -> None:
    """Titles, legends and ticks, word by word; the bytes depend on matplotlib's version."""
    script = runpy.run_path(str(DOCS / "figures" / "make_paper_cases.py"))
    fresh: dict[str, bytes] = script["svgs"](reproduction)
    assert len(fresh) == 9
    for name, svg in fresh.items():
        committed = (DOCS / "figures" / name).read_text("utf-8")
        assert WORDS.findall(committed) == WORDS.findall(svg.decode()), name
        assert f"(figures/{name})" in PAGE
        png = (DOCS / "figures" / name).with_suffix(".png").read_bytes()
        assert png.startswith(b"\x89PNG")
