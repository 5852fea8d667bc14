"""The first screen: 24 lines of 80 columns, worst first."""

from __future__ import annotations

import pytest

from ur5check._reports.verdict_text import LINES, WIDTH, verdicts_text
from ur5check._rules.examples import joint, link, robot
from ur5check._validation.configuration import Configuration
from ur5check._validation.verdict import Request, VerdictSet, verdicts


def many_faults() -> str:
    parts = []
    for k in range(12):
        parent = "base" if k == 0 else f"l{k - 1}"
        parts += [joint(f"j{k}", parent=parent, child=f"l{k}"), link(f"l{k}", mass="-1")]
    return robot(*parts)


def shown(tmp_path, *texts, **options):
    files = []
    for k, text in enumerate(texts):
        file = tmp_path / f"arm{k}.urdf"
        file.write_text(text)
        files.append(file)
    requests = [Request(str(file), samples=5) for file in files]
    return verdicts_text(VerdictSet(tuple(verdicts(requests, Configuration(), "error"))), **options)


@pytest.mark.parametrize("texts", [[robot()], [many_faults()], [many_faults(), many_faults()]])
def test_the_first_screen_fits(tmp_path, texts):
    lines = shown(tmp_path, *texts).splitlines()
    assert len(lines) <= LINES
    assert max(map(len, lines)) <= WIDTH


def test_the_verdict_and_the_number_of_findings_stand_first(tmp_path):
    text = shown(tmp_path, many_faults())
    assert text.startswith("FAIL")
    assert "12 errors" in text.splitlines()[0]
    assert "more (--full" in text


def test_full_shows_every_finding(tmp_path):
    text = shown(tmp_path, many_faults(), full=True)
    assert text.count("INE101") == 12 + 1  # and where the laws are not asked
    assert all(f"link 'l{k}'" in text for k in range(12))


def test_many_files_are_a_table_with_their_masses(tmp_path):
    lines = shown(tmp_path, robot(), many_faults(), robot()).splitlines()
    assert [line.split()[0] for line in lines[1:4]] == ["PASS", "FAIL", "PASS"]
    assert lines[1].split()[-1] == "2"
    assert lines[4] == "3 files: 2 pass, 1 fail"
