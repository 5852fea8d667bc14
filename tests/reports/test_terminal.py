"""Text reports: no line broken where a number stands, nothing lost without colour."""

from __future__ import annotations

import re
import unicodedata

import pytest
from rich.cells import cell_len

from ur5check._comparison.difference import Difference
from ur5check._comparison.explanation import Explanation
from ur5check._reports.diff_document import diff_document
from ur5check._reports.document import Column, Document, Row, Section, Table
from ur5check._reports.provenance import Provenance
from ur5check._reports.terminal import render_text
from ur5check._reports.validate_document import validate_document
from ur5check._validation.validation import Validation


def tables(document: Document) -> list[Table]:
    return [table for section in document.sections for table in section.tables]


def of_one_table(table: Table) -> Document:
    return Document("title", None, (), (Section("section", tables=(table,)),), Provenance(()))


def assert_whole(document: Document, width: int) -> None:
    """Lines within the width, except a file's name; every number of every table in one piece."""
    text = render_text(document, width=width)
    for line in text.splitlines():
        assert cell_len(line) <= width or line.startswith("read: sha256"), line
        assert line == line.rstrip()
    words = set(text.split())
    for table in tables(document):
        for i, column in enumerate(table.columns):
            if column.number:
                assert {part for row in table.rows for part in row.cells[i].split()} <= words
    assert "…" not in re.sub(r"sha256 \w{16}…", "", text)


@pytest.mark.parametrize("width", [80, 100])
def test_validation_has_no_broken_line(validation: Validation, width: int) -> None:
    assert_whole(validate_document(validation), width)


@pytest.mark.parametrize("width", [80, 100])
def test_failure_has_no_broken_line(failing: Validation, width: int) -> None:
    assert_whole(validate_document(failing), width)


@pytest.mark.parametrize("width", [80, 100])
def test_difference_has_no_broken_line(difference: Difference, width: int) -> None:
    assert_whole(diff_document(difference), width)


@pytest.mark.parametrize("width", [80, 100])
def test_explanation_has_no_broken_line(explanation: Explanation, width: int) -> None:
    assert_whole(diff_document(explanation.difference, explanation, written_out=True), width)


def test_the_first_screen_tells_it(explanation: Explanation) -> None:
    """24 lines of 100 columns: the verdict, the story, and the mistake that costs most."""
    d = explanation.difference
    screen = render_text(diff_document(d, explanation), width=100).splitlines()[:24]
    assert screen[2].startswith("DIFFER: ")
    dearest = max(explanation.diagnosis.mistakes, key=lambda f: f.before - f.after)
    assert any(re.match(rf"\d  {re.escape(dearest.id)} ", line) for line in screen)


def test_laws_stand_in_one_line_each_at_100_columns(validation: Validation) -> None:
    lines = render_text(validate_document(validation), width=100).splitlines()
    laws = {o.statement for o in validation.outcomes if o.about == "algorithm"}
    assert sum(line.startswith("ok  ") for line in lines) == len(laws) == 15


def test_colour_adds_nothing_but_colour(failing: Validation) -> None:
    document = validate_document(failing)
    coloured = render_text(document, colour=True)
    plain = re.sub(r"\x1b\[[0-9;]*m", "", coloured)
    assert coloured != plain
    assert [line.rstrip() for line in plain.splitlines()] == render_text(document).splitlines()


def test_points_stand_under_each_other() -> None:
    numbers = ("14.62", "0.6860", "7.4e-09", "0", "150", "–")
    table = Table((Column("x", number=True),), tuple(Row((cell,)) for cell in numbers))
    lines = render_text(of_one_table(table)).splitlines()
    points = [line.index(".") for line in lines if re.fullmatch(r" *\d+\.[\de-]+", line)]
    assert len(points) == 3
    assert len(set(points)) == 1


def test_a_table_of_numbers_is_never_squeezed() -> None:
    row = Row(("forearm_link_with_a_long_name", *["-1.234e-05"] * 12))
    columns = (Column("link"), *(Column("value [kg m²]", number=True) for _ in range(12)))
    text = render_text(of_one_table(Table(columns, (row,))), width=80)
    assert text.count("-1.234e-05") == 12


def test_a_name_cannot_steer_the_terminal() -> None:
    table = Table((Column("link"),), (Row(("[bold]arm[/bold] :robot:\x1b[31m\x07",)),))
    text = render_text(of_one_table(table))
    assert "[bold]arm[/bold] :robot:" in text
    assert not any(unicodedata.category(c) == "Cc" for c in text if c != "\n")


def test_a_row_must_fill_its_columns() -> None:
    with pytest.raises(ValueError, match="2 cells under 1 columns"):
        Table((Column("x"),), (Row(("1", "2")),))
