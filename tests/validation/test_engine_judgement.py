"""What engines make of a file, as findings of its judgement."""

from __future__ import annotations

import json

import pytest

import ur5check
from ur5check._cli.main import main
from ur5check._engines.registry import installed
from ur5check._errors import UsageError
from ur5check._io.ros_packages import example_robot_data
from ur5check._rules.examples import joint, link, robot
from ur5check._rules.registry import all_rules
from ur5check._validation.judgement import judge

FRAME = joint("tool_joint", "fixed", "arm", "tool", axis="", limit="")


def write(folder, text):
    file = folder / "arm.urdf"
    file.write_text(text)
    return file


def found_by_engines(file, *engines, **options):
    findings = judge(file, samples=5, engines=engines, **options).findings
    return [one for one in findings if one.rule.startswith("ENG")]


def test_no_engine_is_asked_unless_named(tmp_path):
    file = write(tmp_path, robot(joint(), link(), FRAME, link("tool", "")))
    assert judge(file, samples=5).engines == ()
    assert found_by_engines(file) == []
    assert judge(file, samples=5, engines=["all"]).engines == installed()[1:]
    assert judge(file, samples=5, engines=["dart", "drake"]).engines == ("drake", "dart")


def test_what_an_engine_reads_otherwise_is_a_warning_with_its_numbers(tmp_path):
    file = write(tmp_path, robot(joint(), link(), FRAME, link("tool", "")))
    (found,) = found_by_engines(file, "dart")
    assert (found.rule, found.severity, found.subject) == ("ENG201", "warning", "link 'tool'")
    assert (round(found.value, 12), found.bound, found.unit) == (1.0, 0.0, "kg")
    assert found.effect > 1.0
    assert "DART" in found.message
    assert '<link name="tool">' in file.read_text().splitlines()[found.place.line - 1]
    assert judge(file, samples=5, engines=["dart"]).passed()
    assert not judge(file, samples=5, engines=["dart"]).passed("warning")


def test_the_error_of_the_file_is_an_error_of_the_engines_too(tmp_path):
    file = write(tmp_path, robot(joint(), link(izz="0.02")))
    found = {one.rule: one for one in found_by_engines(file, "mujoco", "drake")}
    assert {rule: one.severity for rule, one in found.items()} == {
        "ENG101": "error",  # MuJoCo's words name the link
        "ENG207": "error",  # Drake's sphere
        "ENG306": "note",
    }
    assert found["ENG101"].subject == "engine 'MuJoCo'"
    assert "A + B >= C" in found["ENG101"].message
    assert "4." in found["ENG101"].message  # its version


def test_an_engine_that_refuses_a_sound_file_is_a_warning(tmp_path, plant):
    (found,) = found_by_engines(write(tmp_path, robot()), plant("Refusing"))
    assert (found.rule, found.severity) == ("ENG101", "warning")
    assert "it has no taste for this file" in found.message


@pytest.mark.parametrize(
    "text",
    [
        robot(joint(kind="floating"), link()),
        all_rules()["TRE104"].bad,  # a loop of links, on which a parser may never end
        robot(joint(), link(mass="nan")),
    ],
    ids=["floating", "loop", "nan"],
)
def test_engines_are_not_given_what_is_no_robot(text, tmp_path):
    (found,) = found_by_engines(write(tmp_path, text), "all")
    assert (found.rule, found.severity) == ("ENG103", "note")


@pytest.mark.parametrize("rule", ["INE101", "INE104", "INE105", "JNT104", "JNT105"])
def test_faulty_numbers_stop_no_engine_s_judgement(rule, tmp_path, capfd):
    """Negative or no mass, no inverse of M, Drake's asserts: findings, nothing printed."""
    found = found_by_engines(write(tmp_path, all_rules()[rule].bad), "all")
    assert "ENG102" not in {one.rule for one in found}
    assert capfd.readouterr().out == ""


def test_what_engines_make_of_a_negative_mass_is_told(tmp_path):
    """Drake replaces it by 1 kg; Pinocchio divides a first moment by it."""
    file = write(tmp_path, all_rules()["INE101"].bad)
    found = {one.rule: one for one in found_by_engines(file, "drake", "pinocchio")}
    assert (round(found["ENG205"].value, 9), found["ENG205"].bound) == (1.0, -1.0)
    assert {found[rule].severity for rule in ("ENG205", "ENG206")} == {"error"}


def test_a_robot_with_many_chains_is_judged_whole():
    file = example_robot_data() / "robots" / "tiago_pro_description/robots/tiago_pro.urdf"
    found = found_by_engines(file, "dart", "mujoco", meshes=False)
    frames = {one.subject for one in found if one.rule == "ENG201"}
    assert {"link 'arm_left_tool_link'", "link 'arm_right_tool_link'"} <= frames
    (velocity,) = (one for one in found if one.rule == "ENG305")
    assert (velocity.subject, len(velocity.places)) == ("33 joints", 33)


def test_an_arm_far_from_its_base_is_explained(tmp_path):
    """Carrying a body 1 km to the base frame and back rounds; it is no defect of an engine."""
    far = joint(origin='<origin xyz="1000 0 0.3" rpy="0.1 0.2 0.3"/>')
    assert "ENG102" not in {
        one.rule for one in found_by_engines(write(tmp_path, robot(far, link())), "all")
    }


def test_names_that_are_no_engine_are_refused(tmp_path):
    file = write(tmp_path, robot())
    for engines in (["bullet"], "mujoco", [1]):
        with pytest.raises(UsageError):
            judge(file, engines=engines)


def test_a_dh_table_has_no_text_to_be_misread():
    assert ur5check.judge("paper", samples=5, engines=["all"]).passed("note")


def test_the_command_asks_those_it_is_given_else_those_of_the_configuration(tmp_path, capsys):
    file = write(tmp_path, robot(joint(), link(), FRAME, link("tool", "")))
    options = ["validate", str(file), "--samples", "5", "--quiet", "--format", "json"]

    def asked(*more):
        code = main([*options, *more])
        report = json.loads(capsys.readouterr().out)
        (verdict,) = report["files"]
        return code, verdict["engines"], report["command"]

    assert asked()[:2] == (0, [])
    code, engines, command = asked("--engines", "dart,mujoco", "--fail-level", "warning")
    assert (code, engines) == (1, ["mujoco", "dart"])
    assert "--engines dart,mujoco" in command
    (tmp_path / "ur5check.toml").write_text('engines = ["drake"]\n')
    assert asked()[1] == ["drake"]
    assert asked("--engines", "dart")[1] == ["dart"]
    assert main([*options, "--engines", "bullet"]) == 2
