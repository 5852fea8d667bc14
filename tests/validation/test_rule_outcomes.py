"""Which rules a file is asked, and what each of them answered."""

from __future__ import annotations

from judged_files import SPOILED_NAME, judged
from ur5check._rules.registry import all_rules
from ur5check._validation.configuration import Configuration
from ur5check._validation.fingerprints import fingerprints, path_from
from ur5check._validation.rule_outcomes import rule_outcomes, rules_asked


def test_each_family_is_asked_where_it_has_a_meaning():
    def families(file: str, **more: bool) -> set[str]:
        return {rule.family for rule in rules_asked(file, Configuration(), **more)}

    assert families("a.urdf") == {"XML", "TRE", "INE", "GEO", "JNT", "ROB"}
    assert families("a.urdf.xacro") - families("a.urdf") == {"XAC"}
    assert families("a.urdf", engines=True) - families("a.urdf") == {"ENG"}


def test_what_is_ignored_or_not_selected_is_not_asked():
    only = rules_asked("a.urdf", Configuration(select=("INE",), ignore=("INE101",)))
    assert [r.id for r in only] == [
        rule for rule in all_rules() if rule.startswith("INE") and rule != "INE101"
    ]
    here = Configuration(per_file=(("old_*", ("INE", "JNT")),))
    assert {rule.family for rule in rules_asked("old_a.urdf", here)} == {"XML", "TRE", "GEO", "ROB"}


def test_an_outcome_sorts_the_findings_of_its_rule(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    verdicts, configuration = judged(tmp_path)
    outcomes = {o.rule.id: o for o in rule_outcomes(verdicts.models[0], configuration)}
    assert len(outcomes["INE101"].failing) == len(outcomes["INE101"].open) == 1
    assert not outcomes["JNT103"].open
    ((_, acceptance),) = outcomes["JNT103"].accepted
    assert acceptance.reason == "a <passive> joint"
    assert not outcomes["INE102"].open


def test_findings_alike_have_fingerprints_of_their_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (finding,) = judged(tmp_path)[0].models[0].findings.open
    twice = fingerprints([finding, finding], SPOILED_NAME)
    assert len(set(twice)) == 2
    assert fingerprints([finding], SPOILED_NAME) == twice[:1]
    assert fingerprints([finding], str(tmp_path / SPOILED_NAME)) != []


def test_a_path_is_seen_from_the_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "b.urdf").write_text("x")
    whole = str(tmp_path / "a" / "b.urdf")
    for name in ("a/b.urdf", "./a/b.urdf", "a/../a/b.urdf", whole):
        assert path_from(None, name) == "a/b.urdf"
        assert path_from(tmp_path / "a", name) == "b.urdf"
    assert path_from(tmp_path / "other", whole) == whole
    assert path_from(None, "package://x/b.urdf") == "package://x/b.urdf"
