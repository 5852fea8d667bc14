"""What the pages refer to exists: links, folders, files, and the works that the code cites."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from repository import REPOSITORY

ROOT = REPOSITORY
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")])


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    for target in re.findall(r"\]\(([^)#]+)[^)]*\)", text):
        if not target.startswith("https://"):
            assert (page.parent / target).exists(), target


def test_contributing_names_what_is_there() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    named = re.findall(r"\b(?:src|tests|docs|benchmarks)/[\w./]+\w", text)
    named = [path for path in named if "NAME" not in path]
    assert len(named) > 20
    for path in named:
        assert (ROOT / path).exists(), path


def test_contributing_names_every_package() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    for folder in (ROOT / "src" / "ur5check").glob("_*/"):
        if folder.name != "__pycache__":
            assert f"`src/ur5check/{folder.name}`" in text, folder.name


def test_cited_works_are_in_the_references() -> None:
    references = (ROOT / "docs" / "references.md").read_text(encoding="utf-8")
    cited = set()
    for file in [*(ROOT / "src").rglob("*.py"), ROOT / "docs" / "checks.md"]:
        text = file.read_text(encoding="utf-8")
        cited |= set(
            re.findall(r"\b([A-Z][a-z]+)(?: et al\.| &|, [A-Z][a-z]+)[^()\n]{0,40}?20[012]\d", text)
        )
        cited |= set(re.findall(r"\b([A-Z][a-z]+) (?:19|20)\d\d\b", text))
    assert {"Siciliano", "Featherstone", "Shapley"} <= cited
    for name in cited:
        assert name in references, name
