"""What a project accepts, and what it may not say."""

from __future__ import annotations

import datetime

import pytest

from ur5check._errors import UsageError
from ur5check._finding import Finding
from ur5check._validation.configuration import find_configuration, read_configuration

FOUND = [
    Finding("INE109", "error", "link 'a'", ""),
    Finding("INE113", "warning", "link 'b'", ""),
    Finding("JNT103", "warning", "joint 'j'", ""),
]
DAY = datetime.date(2026, 11, 25)


def configuration(tmp_path, text, name="ur5check.toml"):
    file = tmp_path / name
    file.write_text(text)
    return read_configuration(file)


def rules(findings):
    return [finding.rule for finding in findings]


def test_without_settings_everything_counts(tmp_path):
    assert rules(configuration(tmp_path, "").sort(FOUND, "x.urdf").open) == rules(FOUND)


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ('ignore = ["INE"]', ["JNT103"]),
        ('ignore = ["INE113"]', ["INE109", "JNT103"]),
        ('select = ["INE"]', ["INE109", "INE113"]),
        ('[per-file]\n"x*.urdf" = ["JNT"]', ["INE109", "INE113"]),
        ('[per-file]\n"y*.urdf" = ["JNT"]', ["INE109", "INE113", "JNT103"]),
    ],
)
def test_rules_are_selected_and_ignored(tmp_path, text, left):
    assert rules(configuration(tmp_path, text).sort(FOUND, "urdf/x1.urdf").open) == left


ACCEPTED = """
[[accepted]]
rule = "INE109"
subject = "link 'a'"
reason = "measured"
until = 2026-11-25
"""


def test_an_accepted_finding_counts_for_nothing_until_its_day(tmp_path):
    c = configuration(tmp_path, ACCEPTED)
    found = c.sort(FOUND, "x.urdf", today=DAY)
    assert rules(found.open) == ["INE113", "JNT103"]
    assert [(f.rule, a.reason) for f, a in found.accepted] == [("INE109", "measured")]
    assert not found.stale
    after = c.sort(FOUND, "x.urdf", today=DAY + datetime.timedelta(days=1))
    assert rules(after.open) == rules(FOUND)


def test_an_acceptance_that_covers_nothing_is_stale(tmp_path):
    found = configuration(tmp_path, ACCEPTED).sort(FOUND[1:], "x.urdf", today=DAY)
    assert [a.rule for a in found.stale] == ["INE109"]


def test_an_acceptance_of_what_engines_do_is_stale_only_where_they_were_asked(tmp_path):
    c = configuration(tmp_path, ACCEPTED.replace("INE109", "ENG201"))
    assert not c.sort(FOUND, "x.urdf", today=DAY).stale
    assert [a.rule for a in c.sort(FOUND, "x.urdf", today=DAY, engines=True).stale] == ["ENG201"]


def test_engines_are_named_in_a_configuration(tmp_path):
    assert configuration(tmp_path, "").engines == ()
    assert configuration(tmp_path, "engines = ['all', 'drake']").engines == ("all", "drake")


def test_another_links_finding_is_not_accepted(tmp_path):
    text = ACCEPTED.replace("link 'a'", "link 'b'")
    assert rules(configuration(tmp_path, text).sort(FOUND, "x.urdf", today=DAY).open) == rules(
        FOUND
    )


@pytest.mark.parametrize(
    "text",
    [
        "ignore = 'INE'",
        "ignore = ['FOO']",
        "fail-level = 'grave'",
        "unknown = 1",
        "engines = 'mujoco'",
        "engines = ['bullet']",
        "engines = [1]",
        "[[accepted]]\nrule = 'INE109'\nsubject = 'x'",
        "[[accepted]]\nsubject = 'x'\nreason = 'y'",
        "[[accepted]]\nrule = 'INE109'\nreason = 'y'\nuntil = 'never'",
        "not toml",
    ],
)
def test_settings_that_mean_nothing_are_refused(tmp_path, text):
    with pytest.raises(UsageError, match=r"ur5check\.toml"):
        configuration(tmp_path, text)


def test_the_nearest_file_above_is_found(tmp_path):
    (tmp_path / "pyproject.toml").write_text('[tool.ur5check]\nfail-level = "note"\n')
    inner = tmp_path / "a" / "b"
    inner.mkdir(parents=True)
    assert find_configuration(inner).fail_level == "note"
    (tmp_path / "a" / "ur5check.toml").write_text('fail-level = "warning"\n')
    assert find_configuration(inner).fail_level == "warning"
