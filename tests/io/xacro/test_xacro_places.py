"""What is wrong after an expansion is reported where it was written."""

from __future__ import annotations

from pathlib import Path

import pytest

from ur5check import load
from ur5check._errors import ModelError
from ur5check._finding import Finding
from ur5check._io.ros_packages import PackageMap
from ur5check._io.xacro.xacro_reader import expand_xacro
from ur5check._validation.judgement import judge

MACROS = """\
<?xml version="1.0"?>
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="body" params="mass">
    <inertial>
      <mass
         value="${mass}"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/>
    </inertial>
  </xacro:macro>
  <xacro:macro name="part" params="name parent mass **where">
    <joint name="to_${name}" type="revolute">
      <parent link="${parent}"/><child link="${name}"/>
      <xacro:insert_block name="where"/>
      <axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
    </joint>
    <xacro:if value="true"><link name="${name}"><xacro:body mass="${mass}"/></link></xacro:if>
  </xacro:macro>
</robot>
"""
ROBOT = """\
<robot name="größe" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="parts/macros.xacro"/>
  <link name="base"/>
  <xacro:part name="a" parent="base" mass="2">
    <where><origin xyz="0 0 0.2"/></where>
  </xacro:part>
  <xacro:call macro="part" name="b" parent="a" mass="MASS"><where><origin xyz="XYZ"/></where>
  </xacro:call>
  <xacro:element xacro:name="link" name="a">
    <xacro:attribute name="note" value="again"/>
  </xacro:element>
</robot>
"""


def written(folder: Path, mass: str = "1", xyz: str = "0 0 0.2") -> Path:
    (folder / "parts").mkdir()
    (folder / "parts" / "macros.xacro").write_text(MACROS)
    file = folder / "arm.urdf.xacro"
    file.write_text(ROBOT.replace("MASS", mass).replace("XYZ", xyz), encoding="utf-8")
    return file


def places(file: Path, rule: str) -> list[tuple[str, int, int]]:
    (finding,) = [f for f in judge(file, samples=2).findings if f.rule == rule]
    return shown(finding, file.parent)


def shown(finding: Finding, folder: Path) -> list[tuple[str, int, int]]:
    return [(p.file.removeprefix(f"{folder}/"), p.line, p.column) for p in finding.places]


def test_a_mass_in_an_included_macro_is_found_there_with_its_calls(tmp_path):
    file = written(tmp_path, mass="-1")
    *sources, expanded = places(file, "INE101")
    assert sources == [
        ("parts/macros.xacro", 5, 7),  # <mass>
        ("parts/macros.xacro", 16, 49),  # <xacro:body>
        ("arm.urdf.xacro", 7, 3),  # <xacro:call>
    ]
    text = expand_xacro(file, arguments={}, packages=PackageMap()).text
    assert expanded[0] == "arm.urdf.xacro (expanded)"
    assert text.splitlines()[expanded[1] - 1].strip() == '<mass value="-1"/>'


def test_a_block_is_found_at_the_call_that_gives_it(tmp_path):
    assert places(written(tmp_path, xyz="0 0"), "XML103")[0] == ("arm.urdf.xacro", 7, 64)


def test_an_element_named_by_xacro_is_found_where_it_was_named(tmp_path):
    assert places(written(tmp_path), "TRE101")[0] == ("arm.urdf.xacro", 9, 3)


def test_files_of_the_own_package_have_paths_and_others_their_package_address(tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    (other / "macros.xacro").write_text(MACROS)
    own = tmp_path / "own"
    (own / "urdf").mkdir(parents=True)
    (own / "macros.xacro").write_text(MACROS)
    file = own / "urdf" / "arm.xacro"
    found = []
    for package in ("own", "other"):
        text = ROBOT.replace("parts/", f"$(find {package})/").replace("XYZ", "0 0 1")
        file.write_text(text.replace("MASS", "-1"), encoding="utf-8")
        findings = judge(file, packages={"own": own, "other": other}, samples=2).findings
        found += [f.place.file for f in findings if f.rule == "INE101"]
    assert found == [str(own / "macros.xacro"), "package://other/macros.xacro"]


def test_load_names_the_source_too(tmp_path):
    file = written(tmp_path, mass="-1")
    file.write_text(file.read_text().replace('xacro:name="link" name="a"', 'xacro:name="x"'))
    with pytest.raises(ModelError) as caught:
        load(file)
    assert (caught.value.file, caught.value.line) == (str(tmp_path / "parts/macros.xacro"), 5)


def test_a_recursion_as_deep_as_xacro_allows_still_expands(tmp_path):
    # Python allows 1,000 frames, and xacro itself takes four for a call and its condition.
    file = tmp_path / "deep.xacro"
    file.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:macro name="down" params="n"><a n="${n}"/><xacro:if value="${n &gt; 0}">'
        '<xacro:down n="${n - 1}"/></xacro:if></xacro:macro><xacro:down n="240"/></robot>'
    )
    text = expand_xacro(file, arguments={}, packages=PackageMap()).text
    assert text.count("<a ") == 241
