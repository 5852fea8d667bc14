"""Which file may import which (docs/architecture.md), read from the code's own imports."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

import ur5check
from repository import REPOSITORY

ROOT = Path(ur5check.__file__).parent

#: Third-party engines, and the readers that may import them.  Each engine's adapter imports it
#: lazily (`test_an_engine_is_imported_lazily_by_one_adapter`).
ENGINES = {
    "pinocchio": {"_io/pinocchio_model.py"},
    "mujoco": {"_io/mjcf/mjcf_process.py"},
    "pydrake": {"_io/sdf/sdf_process.py"},
    "dartpy": set(),
    "idyntree": set(),
}

FILES = sorted(path.relative_to(ROOT).as_posix() for path in ROOT.rglob("*.py"))


#: The packages in the order of docs/architecture.md: each imports only those before it.
PAGE = REPOSITORY / "docs" / "architecture.md"
PACKAGES = re.findall(r"^\| `([\w/]+)` \|", PAGE.read_text("utf-8"), re.MULTILINE)

#: The public names, imported lazily, and `python -m ur5check`: above all packages.
TOP = {"__init__", "__main__"}


def package_of(file: str) -> str:
    """The row of the page that a file belongs to: an inner folder with a row, or the top one."""
    top, *rest = file.removesuffix(".py").split("/")
    inner = "/".join([top, *rest[:1]])
    return inner if inner in PACKAGES else top


def imports(file: str) -> list[tuple[str, bool]]:
    """(dotted module, whether it is imported only for type checking) of every import in a file."""
    tree = ast.parse((ROOT / file).read_text())
    for_types = {
        id(node)
        for block in ast.walk(tree)
        if isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING"
        for node in ast.walk(block)
    }
    package = ["ur5check", *Path(file).parent.parts]
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found += [(alias.name, id(node) in for_types) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            above = package[: len(package) - node.level + 1] if node.level else []
            base = ".".join([*above, *([node.module] if node.module else [])])
            names = [f"{base}.{alias.name}" for alias in node.names] if node.level else [base]
            found += [(name, id(node) in for_types) for name in names]
    return found


def imported_files(file: str) -> set[str]:
    """The package's own files that a file imports when it runs."""
    found = set()
    for module, for_types in imports(file):
        parts = module.split(".")[1:]
        for end in (len(parts), len(parts) - 1):
            target = "/".join(parts[:end]) + ".py"
            if module.startswith("ur5check.") and target in FILES and not for_types:
                found.add(target)
    return found


def cycle(graph: dict[str, set[str]]) -> list[str]:
    """Some cycle of a directed graph, or nothing."""
    done: set[str] = set()

    def visit(node: str, path: list[str]) -> list[str]:
        if node in path:
            return [*path[path.index(node) :], node]
        if node in done:
            return []
        for target in sorted(graph[node]):
            if found := visit(target, [*path, node]):
                return found
        done.add(node)
        return []

    for node in sorted(graph):
        if found := visit(node, []):
            return found
    return []


def test_a_cycle_is_found() -> None:
    assert cycle({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c", "b"]
    assert cycle({"a": {"b", "c"}, "b": {"c"}, "c": set()}) == []


def test_the_page_names_every_package_once() -> None:
    assert len(PACKAGES) == len(set(PACKAGES))
    assert set(PACKAGES) == {package_of(file) for file in FILES} - TOP


@pytest.mark.parametrize("package", PACKAGES)
def test_a_package_imports_only_those_above_it(package: str) -> None:
    allowed = {*PACKAGES[: PACKAGES.index(package) + 1], "__init__"}
    for file in FILES:
        if package_of(file) == package:
            for target in imported_files(file):
                assert package_of(target) in allowed, f"{file} imports {target}"


@pytest.mark.parametrize("file", FILES)
def test_a_third_party_engine_is_imported_in_its_own_file_only(file):
    for module, for_types in imports(file):
        for engine, homes in ENGINES.items():
            if module.split(".")[0] == engine and not for_types:
                assert file in homes, f"{file} imports {module}"


def lazy_imports(file: str) -> set[str]:
    """Third-party packages that a file imports by `lazy_import`."""
    return {
        ast.literal_eval(node.args[0]).split(".")[0]
        for node in ast.walk(ast.parse((ROOT / file).read_text()))
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "lazy_import"
    }


def test_an_engine_is_imported_lazily_by_one_adapter() -> None:
    lazy = {file: names for file in FILES if (names := lazy_imports(file))}
    assert all(Path(file).parent.as_posix() == "_engines/adapters" for file in lazy)
    assert sorted(name for names in lazy.values() for name in names) == sorted(ENGINES)


def test_no_file_bears_a_public_functions_name() -> None:
    assert not {file.split("/")[0].removesuffix(".py") for file in FILES} & set(ur5check.__all__)


def test_lxml_parses_in_one_file_only() -> None:
    """Elsewhere an entity or a network address could slip in: `safe_xml` refuses them."""
    parsers = re.compile(r"etree\.(XMLParser|fromstring|parse|XML|iterparse)\b|ElementTree")
    found = {
        str(path.relative_to(ROOT))
        for path in ROOT.rglob("*.py")
        if parsers.search(path.read_text(encoding="utf-8"))
    }
    assert found == {"_io/xml/safe_xml.py"}


def test_files_do_not_import_in_a_cycle() -> None:
    assert not cycle({file: imported_files(file) - {file} for file in FILES})


def loaded_after(statement: str) -> set[str]:
    code = f"import sys; {statement}; print(*sys.modules)"
    output = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    ).stdout
    return {name.split(".")[0] for name in output.split()}


def test_importing_ur5check_loads_nothing_heavy():
    heavy = {
        "numpy",
        "pinocchio",
        "xacro",
        "yourdfpy",
        "rich",
        "sympy",
        "llvmlite",
        *ENGINES,
    }
    assert not loaded_after("import ur5check") & heavy


def test_the_registry_of_engines_loads_none_of_them():
    asked = "from ur5check._engines.registry import installed; installed()"
    assert not loaded_after(asked) & set(ENGINES)


def test_public_names_are_all_there():
    for name in ur5check.__all__:
        assert getattr(ur5check, name) is not None
    assert set(ur5check.__all__) <= set(dir(ur5check))
    with pytest.raises(AttributeError, match="no attribute 'torque'"):
        _ = ur5check.torque


def test_the_typed_names_are_those_that_are_found_lazily():
    tree = ast.parse((ROOT / "__init__.py").read_text())
    typed = {
        alias.asname or alias.name: f".{node.module}" + (f":{alias.name}" * bool(alias.asname))
        for block in tree.body
        if isinstance(block, ast.If)
        for node in block.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert typed == ur5check._DEFINED_IN
