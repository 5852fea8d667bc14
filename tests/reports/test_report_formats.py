"""The list of report formats: what the command line offers is what it holds."""

from __future__ import annotations

import pytest

import ur5check
from ur5check._cli.main import main
from ur5check._reports.report_formats import FORMATS, Contents, Screen, format_of
from ur5check._reports.show_document import show_document
from ur5check._reports.show_json import show_json


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_a_format_is_chosen_by_name_and_by_suffix(form) -> None:
    assert format_of(form.name, None) is form
    for suffix in form.suffixes:
        assert format_of(None, f"report{suffix.upper()}") is form
    assert format_of(form.name, "report.json") is form  # a name outweighs the suffix


def test_text_is_the_default() -> None:
    assert format_of(None, None).name == format_of(None, "report.log").name == "text"


def test_no_suffix_belongs_to_two_formats() -> None:
    suffixes = [suffix for form in FORMATS for suffix in form.suffixes]
    assert len(set(suffixes)) == len(suffixes)


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_the_command_line_renders_each(form, capsys) -> None:
    arm = ur5check.load("paper")
    command = "ur5check show paper"
    contents = Contents(
        lambda: show_document(arm, command=command), lambda: show_json(arm, command=command)
    )
    assert main(["show", "paper", "--format", form.name]) == 0
    assert capsys.readouterr().out == form.render(contents, Screen())
