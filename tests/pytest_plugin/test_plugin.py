"""The pytest plugin, in runs of pytest of its own."""

from __future__ import annotations

import tomllib
from importlib import import_module

import pytest
from junitparser import JUnitXml

from judged_files import GOOD, SPOILED
from repository import REPOSITORY
from ur5check._rules.examples import joint, link, robot
from ur5check._validation.configuration import Configuration
from ur5check._validation.rule_outcomes import rules_asked

pytest_plugins = ["pytester"]

ACCEPTED = '[[accepted]]\nrule = "INE101"\nsubject = "{}"\nreason = "a known defect"\n'


@pytest.fixture
def run(pytester, monkeypatch):
    """`run(*options)` in a process of its own, with no other plugin than this one."""
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    pytester.makefile(".urdf", good=GOOD, spoiled=SPOILED)
    pytester.makefile(".toml", ur5check="")

    def process(*options: str) -> pytest.RunResult:
        plugin = ("-p", "ur5check._pytest.plugin")
        return pytester.runpytest_subprocess(
            *plugin, "-p", "no:cacheprovider", *options, timeout=90
        )

    return process


def test_one_item_a_rule_grouped_by_family(run):
    result = run("--ur5check", "good.urdf", "--collect-only", "-q")
    ids = [line for line in result.outlines if "::" in line]
    rules = rules_asked("good.urdf", Configuration())
    assert [i for i in ids if "::computation::" not in i] == sorted(
        (f"good.urdf::{rule.family}::{rule.id}-{rule.name}" for rule in rules), key=ids.index
    )
    assert len(ids) == len(rules) + 1
    assert "good.urdf::computation::laws-of-dynamics" in ids


def test_a_good_model_passes(run):
    result = run("--ur5check", "good.urdf")
    assert result.ret == 0
    outcomes = result.parseoutcomes()
    assert outcomes == {"passed": len(rules_asked("good.urdf", Configuration())) + 1}


def test_a_failure_shows_value_place_and_repair(run):
    result = run("--ur5check", "spoiled.urdf", "--junitxml", "r.xml", "-rfs")
    assert result.ret == 1
    assert result.parseoutcomes()["failed"] == 1
    result.stdout.fnmatch_lines(
        [
            "spoiled.urdf:4:*: error INE101: link 'arm': *",
            "  value: -1.0*",
            "  effect: *",
            "  fix: *",
        ]
    )
    result.stdout.no_fnmatch_line("*Traceback*")
    cases = [case for suite in JUnitXml.fromfile("r.xml") for case in suite]
    (failed,) = [case for case in cases if case.is_failure]
    assert failed.name == "INE101-mass-negative"


def test_an_accepted_finding_is_an_expected_failure_with_its_reason(run, pytester):
    pytester.makefile(".toml", ur5check=ACCEPTED.format("link 'arm'"))
    result = run("--ur5check", "spoiled.urdf", "-rx")
    assert result.ret == 0
    assert result.parseoutcomes()["xfailed"] == 1
    result.stdout.fnmatch_lines(["XFAIL *INE101*a known defect*"])


def test_a_stale_acceptance_fails(run, pytester):
    pytester.makefile(".toml", ur5check=ACCEPTED.format("link 'gone'"))
    result = run("--ur5check", "good.urdf")
    assert result.ret == 1
    assert result.parseoutcomes()["failed"] == 1
    result.stdout.fnmatch_lines(["INE101 link 'gone' is accepted (a known defect) but *"])


def test_a_difference_shows_its_worst_state(run, pytester):
    pytester.makefile(".urdf", heavier=robot(joint(), link(mass="2.5"), name="good"))
    result = run("--ur5check", "heavier.urdf", "--ur5check-against", "good.urdf")
    assert result.parseoutcomes()["failed"] == 1
    result.stdout.fnmatch_lines(["*CMP001*torques differ by*", "  worst q: *", "  worst qdd: *"])
    same = run("--ur5check", "good.urdf", "--ur5check-against", "good.urdf")
    assert same.ret == 0


def test_engines_are_audited_when_asked(run):
    result = run("--ur5check", "good.urdf", "--ur5check-engines", "mujoco", "--collect-only", "-q")
    assert any("::ENG::ENG" in line for line in result.outlines)
    assert run("--ur5check", "good.urdf", "--ur5check-engines", "mujoco").ret == 0


FIXTURES = """
import numpy as np
import ur5check

def test_torques(arm, reference, states, robot):
    tau = ur5check.rnea(arm, states.q, states.qd, states.qdd)
    np.testing.assert_allclose(
        tau, reference.inverse_dynamics(states.q, states.qd, states.qdd), atol=1e-9)
    assert robot.name == "good"
"""


def test_fixtures_run_a_test_for_each_model(run, pytester):
    pytester.makefile(".urdf", second=GOOD)
    pytester.makepyfile(test_mine=FIXTURES)
    result = run("test_mine.py", "--ur5check", "good.urdf", "--ur5check", "second.urdf", "-v")
    assert result.ret == 0
    result.stdout.fnmatch_lines(
        ["test_mine.py::test_torques[[]good.urdf[]] PASSED*", "*[[]second.urdf[]] PASSED*"]
    )


def test_a_project_asks_in_its_configuration(run, pytester):
    pytester.makefile(".toml", ur5check='pytest = ["*.urdf"]')
    result = run()
    assert result.parseoutcomes()["failed"] == 1
    (pytester.path / "ur5check.toml").unlink()
    pytester.makefile(".toml", pyproject='[tool.ur5check]\npytest = ["good.urdf"]')
    assert run().ret == 0
    pytester.makefile(".toml", pyproject='[tool.ur5check]\npytest = ["none.urdf"]')
    assert run().ret == pytest.ExitCode.USAGE_ERROR


def test_xdist_collects_and_judges_the_same(run):
    result = run("-p", "xdist", "-n", "2", "--dist", "loadfile", "--ur5check", "spoiled.urdf")
    alone = run("--ur5check", "spoiled.urdf")
    assert result.parseoutcomes() == alone.parseoutcomes()


def test_a_suite_of_ones_own(run, pytester):
    pytester.makepyfile(
        test_mine="""
        from ur5check.testing import parametrize_with_rules

        @parametrize_with_rules(["good.urdf", "spoiled.urdf"])
        def test_models(model, check):
            check(model)
        """
    )
    result = run("test_mine.py")
    assert result.parseoutcomes()["failed"] == 1
    result.stdout.fnmatch_lines(["FAILED test_mine.py::test_models[[]spoiled.urdf-INE101-*"])


@pytest.mark.parametrize(
    "options",
    [
        ("--ur5check", "none.urdf"),
        ("--ur5check", "good.urdf", "--ur5check-engines", "mojuco"),
        ("--ur5check-against", "good.urdf"),
    ],
)
def test_bad_usage_is_said_before_tests_run(run, options):
    result = run(*options)
    assert result.ret == pytest.ExitCode.USAGE_ERROR
    assert "Traceback" not in result.stderr.str()


def test_it_is_silent_and_costs_nothing_until_it_is_asked(run, pytester):
    pytester.makepyfile(
        test_mine="""
        import sys

        def test_nothing_is_loaded():
            heavy = {"numpy", "pinocchio", "ur5check._validation", "ur5check._rules", "lxml"}
            assert not heavy & set(sys.modules)
        """
    )
    result = run()
    assert result.ret == 0
    assert result.parseoutcomes() == {"passed": 1}
    assert "ur5check" not in result.stdout.str().replace(str(pytester.path), "")


def test_the_distribution_declares_it():
    project = tomllib.loads((REPOSITORY / "pyproject.toml").read_text("utf-8"))["project"]
    (module,) = project["entry-points"]["pytest11"].values()
    assert callable(import_module(module).pytest_addoption)
