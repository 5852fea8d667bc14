"""Which files `validate` judges, how it reads them, and when two of them are compared."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from ur5check._cli.main import main
from ur5check._errors import UsageError
from ur5check._rules.examples import joint, link, robot
from ur5check._validation.configuration import FileSettings, read_configuration
from ur5check._validation.verdict import Request

XACRO = robot(joint(), link(mass="$(arg m)")).replace(
    '<robot name="r">',
    '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="m" default="1"/>',
)


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "urdf").mkdir()
    (tmp_path / "urdf" / "a.urdf").write_text(robot())
    (tmp_path / "urdf" / "b.urdf").write_text(robot(joint(), link(mass="2.5")))
    (tmp_path / "arm.urdf.xacro").write_text(XACRO)
    return tmp_path


def judged(*words: str) -> dict:
    main(["validate", *words, "--samples", "5", "--quiet", "-o", "r.json"])
    return json.loads(Path("r.json").read_text("utf-8"))


def test_two_models_are_compared_only_where_both_are_named(here):
    assert len(judged("urdf/a.urdf", "urdf/b.urdf")["agreements"]) == 1
    for words in (("urdf",), ("urdf/*.urdf",), ("urdf/a.urdf", "urdf/b.urdf", "--each")):
        report = judged(*words)
        assert [entry["file"] for entry in report["files"]] == ["urdf/a.urdf", "urdf/b.urdf"]
        assert report["agreements"] == []
        assert report["passed"]


def test_a_pattern_without_files_is_wrong_usage(here, capsys):
    assert main(["validate", "urdf/*.xml"]) == 2
    assert "urdf/*.xml" in capsys.readouterr().err


def test_the_configuration_says_how_a_file_is_read(here):
    (here / "ur5check.toml").write_text('[[files]]\npath = "arm.*"\narguments = {m = 1.25}\n')
    assert judged("arm.urdf.xacro")["files"][0]["robot"]["mass"] == 1.25
    assert judged("arm.urdf.xacro", "--arg", "m:=3")["files"][0]["robot"]["mass"] == 3.0
    (here / "ur5check.toml").write_text('[[files]]\npath = "arm.*"\nexpect-mass = 7.5\n')
    rules = [f["rule"] for f in judged("arm.urdf.xacro")["files"][0]["findings"]]
    assert any(rule.startswith("ROB") for rule in rules)


def test_the_configuration_names_a_model_to_compare_with(here):
    (here / "ur5check.toml").write_text('against = "urdf/a.urdf"\n')
    (pair,) = judged("urdf/b.urdf")["agreements"]
    assert not pair["passed"]


def test_what_the_request_says_counts_before_the_settings(here):
    (here / "ur5check.toml").write_text(
        '[[files]]\npath = "*"\nbase = "x"\ntip = "y"\narguments = {a = true, b = "c"}\n'
    )
    configuration = read_configuration(here / "ur5check.toml")
    assert configuration.settings_of("z.urdf") == FileSettings(
        "*", (("a", "true"), ("b", "c")), "x", "y"
    )
    named = Request("z.urdf", tip="hand", arguments=(("a", "false"),))
    request = named.with_settings(configuration)
    assert (request.base, request.tip) == (None, "hand")
    assert dict(request.arguments) == {"a": "false", "b": "c"}


@pytest.mark.parametrize(
    "text",
    [
        "[[files]]\nbase = 'x'",
        "[[files]]\npath = 'a'\nunknown = 1",
        "[[files]]\npath = 'a'\nexpect-mass = -1",
        "[[files]]\npath = 'a'\narguments = {a = [1]}",
        "files = 'a'",
        "against = 1",
        "pytest = 'a.urdf'",
    ],
)
def test_settings_that_mean_nothing_are_refused(tmp_path, text):
    file = tmp_path / "ur5check.toml"
    file.write_text(text)
    with pytest.raises(UsageError):
        read_configuration(file)
