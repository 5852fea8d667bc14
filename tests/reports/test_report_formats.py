"""The list of report formats: what the command line offers is what it holds."""

from __future__ import annotations

import pytest

import ur5check
from ur5check._cli.main import main
from ur5check._reports.report_formats import (
    FORMATS,
    Contents,
    Target,
    format_named,
    format_of_file,
)
from ur5check._reports.show_document import show_document
from ur5check._reports.show_json import show_json


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_a_format_is_chosen_by_name_and_by_suffix(form) -> None:
    assert format_named(form.name) is form
    for suffix in form.suffixes:
        assert format_of_file(f"report{suffix.upper()}") is form


def test_the_longest_suffix_counts_and_an_unknown_one_stands_for_nothing() -> None:
    assert format_of_file("pull.summary.md") is format_named("summary")
    assert format_of_file("findings.sarif.json") is format_named("sarif")
    assert format_of_file("report.log") is format_of_file("report") is None


def test_no_suffix_belongs_to_two_formats() -> None:
    suffixes = [suffix for form in FORMATS for suffix in form.suffixes]
    assert len(set(suffixes)) == len(suffixes)


@pytest.mark.parametrize(
    "form", [form for form in FORMATS if not form.of_findings], ids=lambda form: form.name
)
def test_the_command_line_renders_each(form, capsys) -> None:
    arm = ur5check.load("paper")
    command = "ur5check show paper"
    contents = Contents(
        lambda target: show_document(arm, command=command), lambda: show_json(arm, command=command)
    )
    assert main(["show", "paper", "--format", form.name]) == 0
    assert capsys.readouterr().out == form.render(contents, Target(form))
