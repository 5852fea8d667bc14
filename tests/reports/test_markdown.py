"""Markdown: tables that GitHub reads, and names that cannot break them."""

from __future__ import annotations

import re

from ur5check._comparison.explanation import Explanation
from ur5check._reports.diff_document import diff_document
from ur5check._reports.document import Column, Document, Row, Section, Table
from ur5check._reports.markdown import render_markdown
from ur5check._reports.provenance import Provenance
from ur5check._reports.validate_document import validate_document
from ur5check._validation.validation import Validation


def unescaped_pipes(line: str) -> int:
    return len(re.findall(r"(?<!\\)\|", line))


def assert_rectangular(text: str, least: int) -> None:
    blocks = [block for block in text.split("\n\n") if block.startswith("|")]
    assert len(blocks) >= least
    for block in blocks:
        assert len({unescaped_pipes(line) for line in block.splitlines()}) == 1


def test_every_table_is_rectangular(validation: Validation) -> None:
    text = render_markdown(validate_document(validation))
    assert_rectangular(text, 5)
    assert text.startswith("# Validation of paper against appendix\n\n**PASS: ")


def test_an_explanation_is_rectangular_too(explanation: Explanation) -> None:
    d = explanation.difference
    text = render_markdown(diff_document(d, explanation, written_out=True))
    assert_rectangular(text, 12)
    assert "\n### Identifiable combinations\n" in text


def test_hashes_are_whole(validation: Validation) -> None:
    text = render_markdown(validate_document(validation))
    for model in validation.models:
        assert all(digest in text for _, digest in model.arm.source.inputs)


def test_what_failed_is_bold_and_first(failing: Validation) -> None:
    text = render_markdown(validate_document(failing))
    assert text.index("## What fails") < text.index("## The algorithm")
    assert "| **FAILS** |" in text


def test_names_are_shown_as_they_are() -> None:
    table = Table((Column("a|b"),), (Row(("x|y\n<b>*&",), bad=True),))
    document = Document("t_1", None, (), (Section("s", tables=(table,)),), Provenance(()))
    text = render_markdown(document)
    assert "| a\\|b |" in text
    assert "| **x\\|y \\<b\\>\\*&amp;** |" in text
