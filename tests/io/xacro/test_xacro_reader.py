"""xacro to URDF, and what a hostile or careless file meets instead.

Every refusal is shown with a real file, expanded by the real xacro in its own process.
"""

from __future__ import annotations

import hashlib
import subprocess
import sys
import time
from collections.abc import Mapping
from pathlib import Path

import pytest

from ur5check._errors import ModelError
from ur5check._io.ros_packages import PackageMap
from ur5check._io.xacro.xacro_reader import Expansion, expand_xacro

NO_PACKAGES = PackageMap()


def write(folder: Path, body: str, name: str = "arm.xacro") -> Path:
    """A xacro file whose body starts on line 2."""
    file = folder / name
    file.write_text(
        f'<robot name="arm" xmlns:xacro="http://wiki.ros.org/xacro">\n{body}\n</robot>\n', "utf-8"
    )
    return file


def expand(
    file: Path,
    arguments: Mapping[str, str] | None = None,
    packages: PackageMap = NO_PACKAGES,
    seconds: float = 20.0,
) -> Expansion:
    return expand_xacro(file, arguments=arguments or {}, packages=packages, seconds=seconds)


def refusal(
    file: Path,
    arguments: Mapping[str, str] | None = None,
    packages: PackageMap = NO_PACKAGES,
    seconds: float = 20.0,
) -> ModelError:
    with pytest.raises(ModelError) as caught:
        expand(file, arguments, packages, seconds)
    assert caught.value.fix
    return caught.value


# What it does.


def test_arguments_properties_and_macros_are_expanded(tmp_path: Path) -> None:
    file = write(
        tmp_path,
        '<xacro:arg name="side" default="left"/><xacro:property name="half" value="${pi / 2}"/>'
        '<xacro:macro name="part" params="mass"><link name="$(arg side)" m="${2 * mass}"/>'
        '</xacro:macro><xacro:part mass="1.5"/><turn by="${half}"/>',
    )
    text = expand(file, {"side": "right"}).text
    assert '<link m="3.0" name="right"/>' in text
    assert '<turn by="1.5707963267948966"/>' in text
    assert str(tmp_path) not in text


def test_every_file_read_is_listed_with_its_digest_robot_file_first(tmp_path: Path) -> None:
    package = tmp_path / "package"
    package.mkdir()
    parts = [
        write(package, "<link/>", "part.xacro"),
        tmp_path / "numbers.yaml",
        write(
            tmp_path,
            '<xacro:include filename="$(find pkg)/part.xacro"/>'
            "<a b=\"${xacro.load_yaml('numbers.yaml')['mass']}\"/>",
        ),
    ]
    parts[1].write_text("mass: 3.5")
    expansion = expand(parts[2], packages=PackageMap({"pkg": (package,)}))
    digests = [hashlib.sha256(part.read_bytes()).hexdigest() for part in parts]
    assert expansion.inputs == (
        (str(parts[2]), digests[2]),
        ("package://pkg/part.xacro", digests[0]),
        ("numbers.yaml", digests[1]),
    )
    assert '<a b="3.5"/>' in expansion.text


def test_a_package_in_two_folders_is_included_from_either(tmp_path: Path) -> None:
    for folder in ("one", "two"):
        (tmp_path / folder).mkdir()
        write(tmp_path / folder, f"<{folder}/>", f"{folder}.xacro")
    packages = PackageMap({"pkg": (tmp_path / "one", tmp_path / "two")})
    file = write(
        tmp_path,
        '<xacro:include filename="$(find pkg)/one.xacro"/>'
        '<xacro:include filename="$(find pkg)/two.xacro"/>',
    )
    text = expand(file, packages=packages).text
    assert "<one/>" in text
    assert "<two/>" in text


def test_an_include_may_hold_a_star_or_be_optional(tmp_path: Path) -> None:
    write(tmp_path, "<one/>", "part_1.xacro")
    file = write(
        tmp_path,
        '<xacro:include filename="part_*.xacro"/>'
        '<xacro:include filename="absent.xacro" optional="true"/>',
    )
    assert "<one/>" in expand(file).text


def test_what_xacro_remarks_is_kept(tmp_path: Path) -> None:
    file = write(tmp_path, '<xacro:property name="pi" value="3"/>')
    assert expand(file).warnings == ("redefining global symbol: pi",)


def test_the_worker_starts_without_numpy() -> None:
    code = "import sys, ur5check._io.xacro.xacro_process; print('numpy' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


# Files that reach for what is not theirs.

EXPRESSIONS = {
    "attributes inside a lambda": "(lambda: ().__class__.__base__.__subclasses__())()",
    "attributes outside of one": "().__class__",
    "a generator's frame": "(x for x in [1]).gi_frame.f_back.f_globals",
    "a class by its dictionary": "python.vars(python.type)['mro'](python.int)",
    "a dunder name": "[__import__ for x in [1]]",
}


@pytest.mark.parametrize("expression", EXPRESSIONS.values(), ids=list(EXPRESSIONS))
def test_an_expression_may_not_reach_for_pythons_internals(tmp_path: Path, expression: str) -> None:
    file = write(tmp_path, f'<link/>\n<a b="${{{expression}}}"/>')
    error = refusal(file)
    assert (error.file, error.line) == (str(file), 3)
    assert error.element == f"${{{expression}}}"
    assert "reaches for" in error.problem
    assert "ask who wrote this file" in error.fix


def test_the_dictionary_of_a_class_is_out_of_reach_by_index_too(tmp_path: Path) -> None:
    assert "vars" in refusal(write(tmp_path, "<a b=\"${python['vars']}\"/>")).problem


def test_substitutions_have_no_functions_of_python(tmp_path: Path) -> None:
    file = write(
        tmp_path,
        '<xacro:property name="p" value="open(\'/etc/passwd\').read()"/>\n<a b="$(eval ${p})"/>',
    )
    error = refusal(file)
    assert "name 'open' is not defined" in error.problem
    assert error.element == "$(eval open('/etc/passwd').read())"


def test_load_yaml_may_not_leave_the_folders(tmp_path: Path) -> None:
    error = refusal(write(tmp_path, "<a b=\"${xacro.load_yaml('/etc/passwd')}\"/>"))
    assert "outside" in error.problem
    assert (error.element, error.line, error.value) == ("xacro.load_yaml", 2, "/etc/passwd")


@pytest.mark.parametrize("optional", ["", ' optional="true"'])
def test_an_include_may_not_leave_the_folders(tmp_path: Path, optional: str) -> None:
    inside = tmp_path / "inside"
    inside.mkdir()
    write(tmp_path, "<secret/>", "secret.xacro")
    file = write(inside, f'<link/>\n<xacro:include filename="../secret.xacro"{optional}/>')
    error = refusal(file)
    assert (error.file, error.line, error.element) == (str(file), 3, "<xacro:include>")
    assert "outside" in error.problem
    assert "--package NAME=DIR" in error.fix


def test_a_link_in_the_file_system_leads_nowhere_else(tmp_path: Path) -> None:
    inside = tmp_path / "inside"
    inside.mkdir()
    (inside / "harmless.yaml").symlink_to("/etc/passwd")
    error = refusal(write(inside, "<a b=\"${xacro.load_yaml('harmless.yaml')}\"/>"))
    assert "outside" in error.problem


def test_an_include_may_not_list_other_folders(tmp_path: Path) -> None:
    error = refusal(write(tmp_path, '<xacro:include filename="/etc/*"/>'))
    assert error.problem == "the file tried to list '/etc/*'"


def test_the_environment_is_empty(tmp_path: Path) -> None:
    error = refusal(write(tmp_path, '<a b="$(env HOME)"/>'))
    assert "environment variable 'HOME' is not set" in error.problem
    assert (error.line, error.element) == (2, "$(env HOME)")


# Each line runs behind the fence; `{file}` is a file inside of the folder that may be read.
FENCED = {
    "reading elsewhere": "open('/etc/passwd')",
    "writing": "open({file!r}, 'w')",
    "appending": "open({file!r}, 'a')",
    "opening for both": "__import__('os').open({file!r}, 2)",
    "a process": "subprocess.run(['true'])",
    "a shell": "os.system('true')",
    "a fork": "os.fork()",
    "a socket": "socket.socket()",
    "a new module": "import ctypes",
    "deleting": "os.remove({file!r})",
    "a folder": "os.mkdir({file!r} + '.d')",
    "the heap": "gc.get_objects()",
}


@pytest.mark.parametrize("line", FENCED.values(), ids=list(FENCED))
def test_whoever_gets_hold_of_python_still_meets_the_fence(tmp_path: Path, line: str) -> None:
    file = tmp_path / "inside.txt"
    file.write_text("unchanged")
    code = (
        "import gc, os, socket, subprocess, sys\n"
        "from ur5check._io.xacro.xacro_confinement import raise_fence\n"
        "raise_fence([sys.argv[1]], lambda tried: os.write(1, b'refused'))\n"
        f"open({str(file)!r}).close(); os.write(1, b'read ')\n"
        "try:\n"
        f"    {line.format(file=str(file))}\n"
        "except BaseException: pass\n"  # what a hostile expression would do
        "os.write(1, b' and went on')\n"
    )
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path)], capture_output=True)
    assert done.stdout == b"read refused"
    assert done.returncode != 0
    assert [path.name for path in tmp_path.iterdir()] == ["inside.txt"]
    assert file.read_text() == "unchanged"


def test_format_is_a_property_like_another(tmp_path: Path) -> None:
    """Descriptions call the suffix of their meshes so; as a method of text it stays refused."""
    macro = '<xacro:macro name="part" params="format:=stl"><m file="a.${format}"/></xacro:macro>'
    assert '<m file="a.dae"/>' in expand(write(tmp_path, macro + '<xacro:part format="dae"/>')).text
    error = refusal(write(tmp_path, "<a b=\"${'a'.format(1)}\"/>"))
    assert error.rule == "XAC103"


# Files that never end, or end too large.


@pytest.mark.parametrize(
    "expression", ["9**9**8", "list(map(lambda x: 9**9**8, [1]))"], ids=["power", "in a lambda"]
)
def test_a_power_that_never_ends_is_ended_and_named(tmp_path: Path, expression: str) -> None:
    file = write(tmp_path, f'<link/>\n<a b="${{{expression}}}"/>')
    start = time.monotonic()
    error = refusal(file, seconds=1.0)
    assert time.monotonic() - start < 5.0
    assert error.problem == "the expansion took longer than 1 s"
    assert (error.file, error.line, error.element) == (str(file), 3, f"${{{expression}}}")


@pytest.mark.parametrize("expression", ["[0] * 10**10", "len('x' * 10**10)"])
def test_a_memory_bomb_is_refused(tmp_path: Path, expression: str) -> None:
    error = refusal(write(tmp_path, f'<a b="${{{expression}}}"/>'))
    assert "memory" in error.problem
    assert (error.line, error.element) == (2, f"${{{expression}}}")


def test_an_expansion_that_is_too_large_is_refused(tmp_path: Path) -> None:
    error = refusal(write(tmp_path, "<a b=\"${'x' * 20 * 10**6}\"/>"))
    assert "larger than 16 MiB" in error.problem


@pytest.mark.parametrize(
    "body",
    [
        '<xacro:include filename="arm.xacro"/>',
        '<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>',
        '<a b="${(lambda f: f(f))(lambda f: f(f))}"/>',
    ],
    ids=["include", "macro", "expression"],
)
def test_endless_recursion_is_refused(tmp_path: Path, body: str) -> None:
    error = refusal(write(tmp_path, body))
    assert "never ends" in error.problem
    assert "xacro:if" in error.fix


def test_a_circle_of_properties_is_refused(tmp_path: Path) -> None:
    file = write(
        tmp_path,
        '<xacro:property name="a" value="${b}"/><xacro:property name="b" value="${a}"/>'
        '<x y="${a}"/>',
    )
    assert "circular variable definition: a -> b -> a" in refusal(file).problem


# Files that are wrong.


def test_an_unknown_argument_is_refused_with_the_nearest_one(tmp_path: Path) -> None:
    file = write(tmp_path, '<xacro:arg name="limited" default="false"/>')
    error = refusal(file, {"limted": "true"})
    assert (error.file, error.value) == (str(file), "limted:=true")
    assert error.fix == "did you mean 'limited'?"
    assert "choose one of: limited" in refusal(file, {"zzz": "1"}).fix


def test_an_argument_without_a_value_is_refused(tmp_path: Path) -> None:
    error = refusal(write(tmp_path, '<a b="$(arg side)"/>'))
    assert error.problem == "argument 'side' has no value"
    assert (error.line, error.element) == (2, "$(arg side)")
    assert "--arg side:=" in error.fix


def test_an_argument_declared_without_a_default_is_refused(tmp_path: Path) -> None:
    error = refusal(write(tmp_path, '<xacro:arg name="side"/>'))
    assert "missing attribute 'default'" in error.problem


def test_an_unknown_package_is_refused_with_the_option(tmp_path: Path) -> None:
    packages = PackageMap({"ur_description": (tmp_path,)})
    file = write(tmp_path, '<a b="$(find ur_descripton)"/>')
    error = refusal(file, packages=packages)
    assert (error.file, error.line) == (str(file), 2)
    assert error.element == "$(find ur_descripton)"
    assert "--package ur_descripton=DIR" in error.fix
    assert "did you mean 'ur_description'?" in error.fix


def test_a_missing_include_is_refused(tmp_path: Path) -> None:
    file = write(tmp_path, '<link/>\n<xacro:include filename="absent.xacro"/>')
    error = refusal(file)
    assert (error.file, error.line) == (str(file), 3)
    assert error.element == "<xacro:include>"
    assert error.value == str(tmp_path / "absent.xacro")
    assert "No such file" in error.problem


def test_an_undefined_property_is_refused_with_the_nearest_one(tmp_path: Path) -> None:
    file = write(tmp_path, '<xacro:property name="length" value="1"/>\n<a b="${2 * lenght}"/>')
    error = refusal(file)
    assert (error.file, error.line, error.element) == (str(file), 3, "${2 * lenght}")
    assert "name 'lenght' is not defined" in error.problem
    assert "did you mean 'length'?" in error.fix


def test_a_mistake_in_a_macro_is_found_in_the_file_that_defines_it(tmp_path: Path) -> None:
    macros = write(
        tmp_path,
        '<xacro:macro name="m" params="n">\n<a b="${n &lt; 1 / 0}"/></xacro:macro>',
        "macros.xacro",
    )
    file = write(tmp_path, '<xacro:include filename="macros.xacro"/><xacro:m n="1"/>')
    error = refusal(file)
    assert (error.file, error.line) == (str(macros), 3)
    assert "division by zero" in error.problem


@pytest.mark.parametrize(
    ("body", "problem", "element"),
    [
        ("<xacro:m/>", "unknown macro name", "<xacro:m>"),
        ('<xacro:insert_block name="m"/>', "Undefined block", "<xacro:insert_block>"),
        ('<xacro:if value="perhaps"/>', "not a boolean expression", "perhaps"),
        ('<a b="${1 +}"/>', "SyntaxError", "${1 +}"),
        ('<a b="${1 / 0}"/>', "ZeroDivisionError", "${1 / 0}"),
    ],
)
def test_a_careless_file_is_told_where_it_went_wrong(
    tmp_path: Path, body: str, problem: str, element: str
) -> None:
    error = refusal(write(tmp_path, f"<link/>\n{body}"))
    assert problem in error.problem
    assert (error.line, error.element) == (3, element)


@pytest.mark.parametrize(
    ("text", "problem", "line"),
    [
        ("", "empty", None),
        ("mass: 3.7", "not well-formed", 1),
        ("<robot>\n<link>\n", "not well-formed", 3),
        ('<!DOCTYPE robot [<!ENTITY a "b">]>\n<robot name="&a;"/>', "DOCTYPE", 1),
    ],
    ids=["empty", "yaml", "cut off", "entities"],
)
@pytest.mark.parametrize("included", [False, True], ids=["robot file", "included file"])
def test_a_file_that_is_no_plain_xml_is_refused(
    tmp_path: Path, text: str, problem: str, line: int | None, included: bool
) -> None:
    bad = tmp_path / "bad.xacro"
    bad.write_text(text)
    file = write(tmp_path, '<xacro:include filename="bad.xacro"/>') if included else bad
    error = refusal(file)
    assert problem in error.problem
    assert (error.file, error.line) == (str(bad), line)


def test_a_path_that_is_no_file_is_refused(tmp_path: Path) -> None:
    assert refusal(tmp_path / "absent.xacro").problem == "no such file"
    assert refusal(tmp_path).problem == "this is not a file"
