"""Input that is no description: devices, pipes, huge counts, expressions that reach too far."""

from __future__ import annotations

import os
import time

import pytest

from ur5check._errors import ModelError
from ur5check._files import read_regular
from ur5check._io.ros_packages import PackageMap
from ur5check._io.xacro.xacro_reader import expand_xacro
from ur5check._rules.examples import robot
from ur5check._validation.judgement import judge

XACRO = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
MJCF = (
    "<mujoco><asset>{asset}</asset>"
    '<worldbody>{more}<body name="a">{body}</body></worldbody></mujoco>'
)
BODY = '<inertial pos="0 0 0.1" mass="1" diaginertia="1 1 1"/><joint name="j" axis="0 1 0"/>'


def rules_of(folder, name, text):
    file = folder / name
    file.write_text(text)
    return [finding.rule for finding in judge(file, samples=5).findings]


def test_only_regular_files_of_bounded_size_are_read(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "large").write_bytes(b"x" * 11)
    for path in ("/dev/zero", tmp_path / "pipe", tmp_path, tmp_path / "large"):
        with pytest.raises(OSError, match=r"regular|bytes"):
            read_regular(path, most=10)
    assert read_regular(tmp_path / "large", most=11) == b"x" * 11


@pytest.mark.parametrize(
    ("asset", "more"),
    [
        ('<hfield name="h" nrow="100000" ncol="100000" size="1 1 1 1"/>', ""),
        ('<texture name="t" type="2d" builtin="flat" width="99999" height="99999"/>', ""),
        ("", '<replicate count="100000000"><geom size="1"/></replicate>'),
        ("", 3 * '<replicate count="1000">' + '<geom size="1"/>' + 3 * "</replicate>"),
        ("", '<replicate count="20000"><geom size="1"/></replicate>'),
        ("", 9 * '<replicate count="900"><geom size="1"/></replicate>'),
        ("", '<include file="/dev/zero"/>'),
    ],
)
def test_an_mjcf_that_unfolds_into_memory_is_a_finding(tmp_path, asset, more):
    sound = MJCF.format(asset="", more="", body=BODY)
    assert "XML100" not in rules_of(tmp_path, "sound.xml", sound)
    found = rules_of(tmp_path, "m.xml", MJCF.format(asset=asset, more=more, body=BODY))
    assert {"XML100", "XML109"} & set(found)


def test_a_pipe_in_the_place_of_an_include_does_not_wait(tmp_path):
    os.mkfifo(tmp_path / "pipe.xacro")
    found = rules_of(tmp_path, "r.xacro", f'{XACRO}<xacro:include filename="pipe.xacro"/></robot>')
    assert found[0].startswith(("XAC", "XML"))


@pytest.mark.parametrize(
    "expression",
    [
        "${('%c0.__globals__%c' % (123, 125)).format(xacro.load_yaml)}",
        "${('%cx.real%c' % (123, 125)).format_map(dict(x=1))}",
        "${str.format('%c0.real%c' % (123, 125), 1)}",
    ],
)
def test_format_reaches_no_attribute(tmp_path, expression):
    text = robot().replace('<robot name="r">', f'{XACRO}<link name="{expression}"/>')
    assert rules_of(tmp_path, "r.xacro", text) == ["XAC103"]


def test_names_of_any_language_are_ordinary_properties(tmp_path):
    text = robot().replace('<robot name="r">', XACRO + '<xacro:property name="größe" value="2"/>')
    text = text.replace('<mass value="2"/>', '<mass value="${größe}"/>')
    assert rules_of(tmp_path, "r.xacro", text) == []


def test_expansion_gives_only_xml(tmp_path):
    file = tmp_path / "r.xacro"
    file.write_text(f"{XACRO}<link name=\"${{'\\x01'}}\"/></robot>")
    with pytest.raises(ModelError) as caught:
        expand_xacro(file, arguments={}, packages=PackageMap())
    assert (caught.value.rule, caught.value.file) == ("XML101", f"{file} (expanded)")
    assert caught.value.line


def test_memory_that_a_size_element_asks_for_is_not_taken(tmp_path):
    text = MJCF.format(asset="", more="", body=BODY)
    text = text.replace("<mujoco>", '<mujoco><size memory="900T" nuserdata="2000000000"/>')
    assert "XML100" not in rules_of(tmp_path, "m.xml", text)


def test_twenty_thousand_fixed_links_take_seconds(tmp_path):
    n = 20_000
    chain = "".join(
        f'<link name="f{i}"/><joint name="t{i}" type="fixed">'
        f'<parent link="f{i}"/><child link="{f"f{i + 1}" if i + 1 < n else "base"}"/></joint>'
        for i in range(n)
    )
    file = tmp_path / "r.urdf"
    file.write_text(robot().replace('<robot name="r">', f'<robot name="r">{chain}'))
    start = time.process_time()
    judgement = judge(file, samples=5)
    assert time.process_time() - start < 20  # a quadratic rule takes 30 s and more
    assert len(judgement.robot.links) > n
