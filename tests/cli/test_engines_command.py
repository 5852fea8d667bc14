"""`ur5check engines`: the gate's exit codes, and its report as text, Markdown and JSON."""

from __future__ import annotations

import pytest

from report_schema import read_report
from repository import REPOSITORY
from three_joints import ARM
from ur5check._cli.main import main
from ur5check._engines.adapters.ur5check_recursion import RecursionEngine
from ur5check._engines.audit.import_difference import KINDS
from ur5check._engines.engine_entry import EngineEntry
from ur5check._engines.registry import REGISTRY

DOCS = REPOSITORY / "docs"


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "three.urdf"
    path.write_text(ARM, encoding="utf-8")
    return str(path)


def engines(*arguments: object) -> int:
    return main(["engines", *map(str, arguments), "--quiet"])


def test_those_that_agree_pass(file, capsys):
    assert engines(file, "--tip", "tool", "--with", "pinocchio", "--samples", 20) == 0
    said = capsys.readouterr().out
    assert "AGREE: ur5check and Pinocchio agree." in said
    assert "--with pinocchio --tolerance 1e-10" in said


def test_one_that_does_not_agree_fails_the_gate(file, plant, capsys):
    key = plant("DefaultMass")
    options = (file, "--tip", "tool", "--with", f"pinocchio,{key}", "--samples", 20)
    assert engines(*options) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert "DIFFER: ur5check and Pinocchio agree; DefaultMass has added 1 kg" in said
    assert "default-inertia" in said
    assert engines(*options, "--tolerance", 1e6) == 0


def test_dart_needs_its_repair(file, capsys):
    options = (file, "--tip", "tool", "--with", "dart,pinocchio", "--samples", 20)
    assert engines(*options, "--as-read") == 1
    assert engines(*options, "--as-read", "--tolerance", 1e6) == 0
    capsys.readouterr()
    assert engines(*options) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "AGREE ONCE REPAIRED: ur5check and Pinocchio agree" in said
    assert "DART has added 2 kg" in said  # plate and tool have no <inertial>
    assert f"`ur5check expand {file} --for dart` repairs it." in said


def test_a_refusal_fails_the_gate(file, plant):
    options = (file, "--tip", "tool", "--samples", 5, "--with")
    assert engines(*options, plant("Refusing")) == 1
    assert engines(*options, plant("Honest")) == 0


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["appendix", "--with", "bullet"], "no engine is called 'bullet'"),
        (["appendix", "--tolerance", "-1"], "give a torque of zero or more"),
        (["appendix", "--tolerance", "nan"], "give a torque of zero or more"),
        (["appendix", "--samples", "0"], "samples must be a whole number of at least 1"),
        (["appendix", "--fleet"], "--fleet takes no model"),
        (["appendix", "--list"], "--list takes no model"),
        (["--list", "--fleet"], "do not go together"),
        (["--as-read"], "--as-read needs a model"),
        (["--fleet", "--gravity", "0", "0", "-9"], "--gravity needs a model"),
        (["nothing"], "no shipped model and no file"),
    ],
)
def test_bad_usage_is_one_line_and_exit_code_2(arguments, said, capsys):
    assert engines(*arguments) == 2
    heard = capsys.readouterr()
    assert heard.out == ""
    assert said in heard.err
    assert heard.err.count("\n") == 1


def test_json_holds_every_number(file, plant, tmp_path):
    out = tmp_path / "report.json"
    key = plant("RotationDropped")
    options = (file, "--tip", "tool", "--with", f"dart,{key}", "--samples", 20, "-o", out)
    assert engines(*options) == 1
    report = read_report(out.read_text(encoding="utf-8"))
    assert report["schema"] == "ur5check.engines/2"
    assert report["verdict"]["explained"]
    assert not report["verdict"]["agree"]
    assert [(row["engine"], row["stage"]) for row in report["engines"]] == [
        (engine, stage) for stage in ("as read", "repaired") for engine in ("ur5check", "dart", key)
    ]
    pairs = {(row["a"], row["b"], row["stage"]): row["torque"] for row in report["pairs"]}
    assert len(pairs) == 6
    assert (
        pairs["ur5check", "dart", "as read"] > 1.0 > 1e-10 > pairs["ur5check", "dart", "repaired"]
    )
    assert pairs["ur5check", key, "repaired"] == pairs["ur5check", key, "as read"] > 1e-3
    harmful = [row for row in report["imports"] if row["bears_on"] == "torque"]
    assert {(row["engine"], row["kind"], row["stage"]) for row in harmful} == {
        ("dart", "default-inertia", "as read"),
        (key, "rotation-dropped", "as read"),
        (key, "rotation-dropped", "repaired"),
    }
    dart = [row for row in harmful if row["engine"] == "dart"]
    assert {row["known_issue"] for row in dart} == {"dart-default-inertia"}
    assert all(row["torque_effect"] > 1e-3 for row in harmful)


def test_json_of_what_is_no_number_is_null(file, plant, capsys):
    assert engines(file, "--with", plant("BreakingDown"), "--tip", "tool", "--format", "json") == 1
    (pair,) = read_report(capsys.readouterr().out)["pairs"]
    assert pair["torque"] is None


def test_markdown_has_a_row_an_engine(file, plant, capsys):
    options = (file, "--tip", "tool", "--with", plant("BodyLost"), "--samples", 20)
    assert engines(*options, "--format", "markdown") == 1
    said = capsys.readouterr().out
    assert "**DIFFER:" in said
    assert "| **BodyLost** | **body-lost** | **link 'weight'** |" in said


def test_the_list_names_all_engines(capsys, tmp_path):
    assert engines() == 0
    said = capsys.readouterr().out
    for title in ("ur5check", "Pinocchio", "MuJoCo", "Drake", "DART", "iDynTree"):
        assert title in said
    out = tmp_path / "list.json"
    assert engines("--list", "-o", out) == 0
    report = read_report(out.read_text(encoding="utf-8"))
    assert [row["key"] for row in report["engines"]][:2] == ["ur5check", "pinocchio"]


def test_the_list_says_what_installs_an_absent_engine(capsys, monkeypatch):
    absent = EngineEntry(
        key="absent",
        title="Absent",
        order=99,
        make=RecursionEngine,
        distribution="no-such-thing",
        extra="absent",
    )
    monkeypatch.setitem(REGISTRY, "absent", absent)
    assert engines("--list") == 0
    assert "pip install 'ur5check[absent]'" in capsys.readouterr().out


def test_every_kind_is_on_the_page():
    kinds = (DOCS / "engines.md").read_text(encoding="utf-8")
    for kind in KINDS:
        assert f"| `{kind}` |" in kinds, kind
