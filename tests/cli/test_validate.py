"""`ur5check validate`: exit code, text and JSON give one verdict, whatever is given."""

from __future__ import annotations

import json

import pytest

from ur5check._cli.main import main
from ur5check._rules.examples import joint, link, robot

#: Files, each with whether it passes by itself.
FILES = {
    "good.urdf": robot(),
    "same.urdf": robot(name="other"),
    "heavier.urdf": robot(joint(), link(mass="2.5")),
    "warned.urdf": robot(
        joint(limit='<limit lower="-2" upper="2" effort="0" velocity="3"/>'), link()
    ),
    "impossible.urdf": robot(joint(), link(mass="-1")),
    "broken.urdf": "<robot name='r'><link",
    "no_arm.urdf": robot(joint(kind="fixed", axis="", limit=""), link()),
    "two_joints.urdf": robot(joint(), link(), joint("k", parent="arm", child="hand"), link("hand")),
}

# models, options, exit code, files that pass, pairs that agree
CASES = [
    ("good", "", 0, "good", []),
    ("warned", "", 0, "warned", []),
    ("warned", "--fail-level warning", 1, "", []),
    ("impossible", "", 1, "", []),
    ("broken", "", 1, "", []),
    ("good same", "", 0, "good same", [True]),
    ("good heavier", "", 1, "good heavier", [False]),
    ("good impossible", "", 1, "good", [False]),
    ("good broken", "", 1, "good", [False]),
    ("broken good", "", 1, "good", [False]),
    ("good no_arm", "", 1, "good no_arm", [False]),
    ("good two_joints", "", 1, "good two_joints", [False]),
    ("good same heavier", "", 0, "good same heavier", []),
    ("good same broken", "", 1, "good same", []),
    ("good same", "--against good", 0, "good same", [True]),
    ("same", "--against good", 0, "same", [True]),
    ("heavier", "--against good", 1, "heavier", [False]),
    ("same heavier good", "--against good", 1, "same heavier good", [True, False]),
    ("same", "--against broken", 1, "same", [False]),
    ("heavier", "--against good --config accepted.toml", 0, "heavier", [True]),
    ("good heavier", "--config accepted.toml", 0, "good heavier", [True]),
    ("good same", "--config accepted.toml", 0, "good same", [True]),
]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name, text in FILES.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "accepted.toml").write_text(
        '[[accepted]]\nrule = "CMP001"\nsubject = ""\nreason = "the new motor is heavier"\n'
    )
    return tmp_path


def words(models, options):
    named = [f"{name}.urdf" for name in models.split()]
    chosen = [f"{word}.urdf" if f"{word}.urdf" in FILES else word for word in options.split()]
    return ["validate", *named, *chosen, "--samples", "3", "--jobs", "1", "--quiet"]


@pytest.mark.parametrize(("models", "options", "code", "passing", "agreeing"), CASES)
def test_exit_code_json_and_text_agree(folder, capsys, models, options, code, passing, agreeing):
    arguments = words(models, options)
    assert main([*arguments, "--format", "json"]) == code
    report = json.loads(capsys.readouterr().out)
    verdict = report["verdict"]
    assert report["passed"] == (code == 0)
    assert [f["file"] for f in report["files"] if f["passed"]] == [
        f"{name}.urdf" for name in passing.split()
    ]
    assert [pair["passed"] for pair in report["agreements"]] == agreeing
    assert verdict["files"] == (passing == models)
    assert verdict["agreement"] == (all(agreeing) if agreeing else None)
    assert report["passed"] == (verdict["files"] and verdict["agreement"] is not False)
    assert not report["passed"] or False not in verdict.values()
    count = len(models.split())
    assert report["summary"][0].startswith(f"{len(passing.split())} of {count} models pass.")
    assert report["summary"][0].count("DIFFER") == agreeing.count(False)

    assert main(arguments) == code
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 80
    assert len(lines) <= 24
    words_of = [line.split()[0] for line in lines if line.strip()]
    assert words_of.count("PASS") == len(passing.split())
    assert words_of.count("FAIL") == count - len(passing.split())
    assert words_of.count("DIFFER") == agreeing.count(False)
    assert main([*arguments, "--format", "markdown"]) == code
    assert ("**FAIL:" in capsys.readouterr().out) == (code == 1)


def test_of_three_models_agreement_is_said_to_be_asked_for(folder, capsys):
    assert main(words("good same heavier", "")) == 0
    assert "--against" in capsys.readouterr().out


@pytest.mark.parametrize(
    "options",
    [
        "good.urdf --fail-level worst",
        "good.urdf --samples 0",
        "good.urdf --jobs 0",
        "absent.urdf",
        "good.urdf --against absent.urdf",
        "good.urdf same.urdf --tip arm",
        "good.urdf same.urdf heavier.urdf --tip-a arm",
        "good.urdf --arm hand",
        "good.urdf --hold j=x",
        "good.urdf --config absent.toml",
        "good.urdf --package x",
    ],
)
def test_wrong_usage_is_one_line_and_2(folder, capsys, options):
    assert main(["validate", *options.split(), "--quiet"]) == 2
    out, err = capsys.readouterr()
    assert (out, len(err.splitlines())) == ("", 1)
