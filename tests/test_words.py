"""Words that are not used, because the field has words of its own (docs/glossary.md).

Only words whose every use would be wrong are listed; an exception carries its reason.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from repository import REPOSITORY

#: Words that go, as regular expressions of whole words, and what to write instead.
WORDS = {
    r"account closes": "residual",
    r"admission": "require_same_model",
    r"believ(e|es|ed|ing)": "imported, computed, taken as",
    r"boughs?": "batch",
    r"catalog(ue)?s?": "mistakes, shipped models",
    r"cannot see|cannot tell": "does not determine, does not depend on",
    r"crews?": "executor",
    r"deeds?": "summary",
    r"dust": "zero tolerance",
    r"fail[-_]over": "tolerance",
    r"far[ _-]ends?": "link tip frame",
    r"granted": "feasible, allowed",
    r"habits?": "known issue",
    r"holdings": "imported model",
    r"hand-?overs?": "export to Gazebo",
    r"houses?": "program",
    r"journals?": "checkpoint",
    r"left over": "residual",
    r"listening": "captured warnings",
    r"loudness": "cancellation bound",
    r"made again": "command",
    r"mend(s|ed|ing)?": "repair",
    r"nobody|whoever": "a user, a caller, none",
    r"owners?": "contribution",
    r"parity": "agreement",
    r"referees?|refereed": "reference engine",
    r"remed(y|ies)": "repair, fix",
    r"rooms?": "package, margin",
    r"slack": "free translation",
    r"slips?": "mistake",
    r"story|stories": "summary",
    r"suspicions?": "mismatch",
    r"tally|tallies": "statistics",
    r"travel(s|led)?": "joint range, pass",
    r"turn(s|ed)? away": "refuse",
    r"whose newton metres": "attribution",
    r"wishes": "target values",
}

#: (file, text of the match) that stay, and why.
EXCEPTIONS = {
    ("docs/references.md", "Journal"): "in the names of scientific journals",
    ("docs/identifiability.md", "Journal"): "in the name of a scientific journal",
    ("docs/sweep.md", "Journal"): "in the name of a scientific journal",
    ("CHANGELOG.md", "fail-over"): "names the option that was renamed",
    ("src/ur5check/_dynamics/base_parameters.py", "Journal"): "in the name of a scientific journal",
}

FILES = sorted(
    path
    for pattern in (
        "*.md",
        "docs/*.md",
        "docs/*.py",
        "models/**/*.md",
        "models/*.toml",
        "notebooks/*.ipynb",
        "src/**/*.py",
        "src/**/*.json",
    )
    for path in REPOSITORY.glob(pattern)
)
PATTERN = re.compile(rf"(?<![A-Za-z])({'|'.join(WORDS)})(?![A-Za-z])", re.IGNORECASE)


def unused_words(text: str) -> list[tuple[int, str]]:
    """(line, word) of each word of the list."""
    return [
        (number, match[0])
        for number, line in enumerate(text.splitlines(), 1)
        for match in PATTERN.finditer(line)
    ]


def test_the_words_are_found_in_prose_and_in_names() -> None:
    assert unused_words("a referee's far_end") == [(1, "referee"), (1, "far_end")]
    assert unused_words("history, recommended, islip, headroom") == []


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(REPOSITORY).as_posix())
def test_the_fields_words_are_used(path: Path) -> None:
    name = path.relative_to(REPOSITORY).as_posix()
    found = [
        f"{name}:{line}: {word}"
        for line, word in unused_words(f"{path.read_text('utf-8')}")
        if (name, word) not in EXCEPTIONS
    ]
    assert not found, "\n".join(found)


def test_no_file_is_named_by_them() -> None:
    names = [path.stem for path in (REPOSITORY / "src").rglob("*.py")]
    assert [name for name in names if PATTERN.search(name)] == []


def test_every_exception_is_needed() -> None:
    for name, word in EXCEPTIONS:
        assert word in {found for _, found in unused_words((REPOSITORY / name).read_text("utf-8"))}
