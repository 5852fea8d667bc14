"""All engines on every serial arm of example-robot-data, and the page with the results.

One run serves all tests here; it takes most of this folder's time.
"""

from __future__ import annotations

import re
import runpy
import shlex
from pathlib import Path

import pytest

import ur5check
from report_schema import read_report
from repository import REPOSITORY
from three_joints import ARM
from ur5check._cli.main import main
from ur5check._engines.audit import fleet_comparison as fleet_module
from ur5check._engines.audit.engine_comparison import SAME_ROBOT, compare_engines
from ur5check._engines.audit.fleet_comparison import FLEET_SAMPLES, compare_fleet
from ur5check._engines.registry import installed
from ur5check._io.example_robots import FLEET
from ur5check._io.urdf.urdf_reader import read_urdf
from ur5check._reports.engines_fleet_document import engines_fleet_document
from ur5check._reports.engines_fleet_json import engines_fleet_json
from ur5check._reports.json_report import json_text
from ur5check._reports.markdown import render_markdown

DOCS = REPOSITORY / "docs"
PAGE = (DOCS / "engines.md").read_text(encoding="utf-8")
COMMANDS = [
    line
    for block in re.findall(r"```sh\n(.*?)```", PAGE, re.DOTALL)
    for line in block.splitlines()
    if line.startswith("ur5check ")
]
#: What an engine cannot read, whatever is done to it: a tensor with a moment of zero.
REFUSED = {("finger-edu", "mujoco")}


@pytest.fixture(scope="session")
def fleet():
    return compare_fleet()


@pytest.fixture(scope="session")
def appendix():
    return compare_engines("appendix", samples=FLEET_SAMPLES)


def test_all_engines_take_part():
    assert set(installed()) >= {"ur5check", "pinocchio", "mujoco", "drake", "dart", "idyntree"}


def test_with_the_repairs_all_engines_agree_on_every_arm(fleet):
    assert len(fleet.reports) == len(FLEET) > 30
    assert fleet.worst(as_read=False) <= SAME_ROBOT
    for report in fleet.reports:
        assert report.final.matrix.worst <= 1e-12  # what docs/engines.md says


def test_before_them_every_larger_difference_is_explained(fleet):
    larger = 0
    for report in fleet.reports:
        assert report.explained, report.arm.name
        for reading in report.as_read.readings:
            if reading.refused is not None or reading.key == "ur5check":
                continue
            if report.as_read.matrix.between("ur5check", reading.key).torque > SAME_ROBOT:
                larger += 1
                assert all(one.known_issue is not None for one in reading.imported.harmful)
    assert larger >= 2


def test_what_is_refused_is_known(fleet):
    refused = {(r.arm.name, one.key) for r in fleet.reports for one in r.final.refusals}
    assert refused == REFUSED


def test_refusals_are_counted_apart(fleet):
    n = len(fleet.reports)
    counts = [
        (
            fleet.agreeing(SAME_ROBOT, as_read=as_read),
            fleet.differing(SAME_ROBOT, as_read=as_read),
            fleet.refused(as_read=as_read),
        )
        for as_read in (True, False)
    ]
    assert counts == [(n - 3, 2, 1), (n - 1, 0, 1)]
    assert not fleet.agrees(SAME_ROBOT, as_read=False)


def test_an_arm_that_an_engine_refuses_never_counts_as_agreement(plant):
    arms = FLEET[:1]
    for name, agrees in (("Honest", True), ("Refusing", False)):
        report = compare_fleet(engines=[plant(name)], samples=3, arms=arms)
        assert report.worst(as_read=False) <= SAME_ROBOT  # no two engines differ
        assert report.agrees(SAME_ROBOT, as_read=False) is agrees
        assert report.agreeing(SAME_ROBOT, as_read=True) == agrees
        assert report.refused(as_read=True) == (not agrees)


def test_the_default_inertia_of_dart_is_found_named_and_removed(appendix):
    dart = appendix.as_read.reading("dart").imported
    assert [(one.kind, one.where) for one in dart.harmful] == [
        ("default-inertia", "link 'ee_link'"),
        ("default-inertia", "link 'tool0'"),
    ]
    assert dart.added_mass == pytest.approx(2.0)
    assert {one.known_issue.id for one in dart.harmful} == {"dart-default-inertia"}
    assert appendix.as_read.matrix.between("ur5check", "dart").torque > 10.0
    assert appendix.repaired.matrix.between("ur5check", "dart").torque <= SAME_ROBOT


def test_erd_ur5_gets_a_default_inertia_once_its_empty_inertials_are_left_out():
    written = ur5check.load("erd-ur5")
    assert compare_engines(written, engines=["dart"], samples=20).as_read.agrees()
    empty = r"<inertial>\s*<mass value=\"0\"/>.*?</inertial>"
    text = re.sub(empty, "", written.source.urdf, flags=re.DOTALL)
    bare = read_urdf(text.encode(), file="bare.urdf", base="base_link", tip="tool0")
    report = compare_engines(bare, engines=["dart"], samples=20)
    dart = report.as_read.reading("dart").imported
    assert {one.where for one in dart.harmful} == {"link 'ee_link'", "link 'tool0'"}
    assert report.as_read.matrix.worst > 10.0
    assert report.explained
    assert report.repaired.agrees()


def test_the_page_is_current(fleet, appendix):
    generator = runpy.run_path(str(DOCS / "generate_engines.py"))
    assert generator["page"](fleet, appendix) == PAGE, "run: python docs/generate_engines.py"


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_of_the_page_runs(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("my.urdf.xacro").write_text(ARM, encoding="utf-8")
    monkeypatch.setattr(fleet_module, "FLEET", FLEET[-2:])
    _, *arguments = shlex.split(command)
    fast = ["--samples", "10"] if len(arguments) > 1 else []
    # Left as it is, DART and MuJoCo make up a body for this arm's empty frames.
    assert main([*arguments, *fast, "--quiet"]) == (1 if "--as-read" in arguments else 0)
    assert capsys.readouterr().out


def test_the_fleet_is_a_report(fleet, capsys, monkeypatch, tmp_path):
    said = render_markdown(engines_fleet_document(fleet))
    assert "**REFUSED: as read, all engines agree on 32 of 35 arms and differ on 2" in said
    assert "finger-edu is refused by MuJoCo" in said
    assert "**DIFFER:" in render_markdown(engines_fleet_document(fleet, as_read=True))
    report = read_report(json_text(engines_fleet_json(fleet)))
    assert not report["agree"]  # a refusal is no agreement
    assert [arm["name"] for arm in report["arms"] if not arm["verdict"]["agree"]] == ["finger-edu"]
    monkeypatch.setattr(fleet_module, "FLEET", [one for one in FLEET if one.name == "xarm7"])
    options = ["engines", "--fleet", "--with", "dart", "--samples", "5", "--quiet"]
    assert main(options) == 0
    assert "DART has added 1 kg" in capsys.readouterr().out
    assert main([*options, "--as-read"]) == 1
