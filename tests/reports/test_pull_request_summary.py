"""The summary of a pull request: a row a file, findings folded, nothing read as Markdown."""

from __future__ import annotations

from judged_files import GOOD, SPOILED, judged
from ur5check._reports.pull_request_summary import render_summary
from ur5check._validation.configuration import Configuration
from ur5check._validation.verdict import Request, VerdictSet, verdicts


def test_files_in_a_table_and_findings_folded(here):
    found, _ = judged(here)
    text = render_summary(found)
    assert text.startswith("### ur5check: FAIL\n")
    rows = [line for line in text.splitlines() if line.startswith("| ")]
    assert [row.split(" | ")[2:6] for row in rows[2:4]] == [["1", "0", "0", "1"], ["0"] * 4]
    assert text.count("<details>") == text.count("</details>") == 2
    assert "INE101" in text
    assert len(text.splitlines()) < 40


def test_names_are_not_read_as_markdown_or_html(here):
    found, _ = judged(here, SPOILED.replace('"arm"', '"a|b&lt;img&gt;_c_"'))
    text = render_summary(found)
    assert r"a\|b\<img\>\_c\_" in text


def test_without_findings_it_is_short(here):
    found, _ = judged(here, GOOD)
    text = render_summary(found)
    assert text.startswith("### ur5check: PASS\n")
    assert "<details>" not in text


def test_a_files_name_is_not_read_as_html(here):
    (here / "<b>_x_.urdf").write_text(SPOILED)
    (verdict,) = verdicts([Request("<b>_x_.urdf", samples=5)], Configuration(), "error")
    text = render_summary(VerdictSet((verdict,)))
    assert "<summary>&lt;b&gt;_x_.urdf: 2 findings</summary>" in text
    assert r"| **FAIL** | \<b\>\_x\_.urdf | 1 | 1 |" in text
