"""The house: who may call whom (docs/architecture.md), read from the code's own imports."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import ur5check

ROOT = Path(ur5check.__file__).parent

#: A value flows one way; each room may import those named.
MAY_IMPORT = {
    "errors": set(),
    "version": set(),
    "arm": {"errors"},
    "strategies": {"arm"},
    "export": {"arm", "errors", "version"},
    "handover": {"arm", "sources", "dynamics", "engines", "export", "errors", "version"},
    "sources": {"arm", "errors"},
    "dynamics": {"arm", "errors"},
    "engines": {"arm", "dynamics", "errors", "version"},
    "comparison": {"arm", "dynamics", "sources", "errors"},
    "plausibility": {"arm", "sources"},
    "identifiability": {"arm", "dynamics", "comparison", "errors"},
    "digits": {"arm", "dynamics", "comparison"},
    "diagnosis": {"arm", "dynamics", "comparison"},
    "worst_case": {"arm", "dynamics", "comparison", "engines", "errors"},
    "closed_form": {"arm", "dynamics", "errors", "version"},
    "kernels": {"arm", "dynamics", "closed_form", "errors", "version"},
    "benchmarking": {
        "arm", "sources", "dynamics", "engines", "closed_form", "kernels", "export", "errors",
    },
    "sweeping": {
        "arm", "sources", "dynamics", "kernels", "comparison", "worst_case", "errors", "version",
    },
    "parity": {"arm", "sources", "dynamics", "engines", "comparison", "worst_case", "errors"},
    "explanation": {
        "arm", "comparison", "plausibility", "identifiability", "digits", "diagnosis", "worst_case",
    },
    "simulation": {"arm", "dynamics", "engines", "comparison", "parity", "errors", "version"},
    "control": {"arm", "sources", "engines", "simulation", "errors"},
    "paper": {
        "arm", "sources", "dynamics", "engines", "comparison", "diagnosis", "digits", "simulation",
        "control", "errors",
    },
    "figures": {"arm", "dynamics", "paper", "simulation", "errors"},
    "checks": {"arm", "dynamics", "sources", "engines", "comparison", "errors"},
    "reports": {
        "arm", "sources", "comparison", "plausibility", "identifiability", "digits", "diagnosis",
        "worst_case", "sweeping", "closed_form", "explanation", "paper", "checks", "engines",
        "benchmarking",
        "parity", "simulation", "errors", "version",
    },
    "cli": {
        "arm", "sources", "engines", "comparison", "diagnosis", "explanation", "paper", "checks",
        "export", "figures", "handover", "sweeping", "parity", "closed_form", "simulation",
        "benchmarking", "reports", "errors", "version",
    },
}  # fmt: skip

#: Third-party engines, and the files that may import them.
ENGINES = {
    "pinocchio": {
        "engines/pinocchio.py",
        "sources/pinocchio_model.py",
        "benchmarking/pinocchio_calls.py",
    },
    "mujoco": {"engines/mujoco.py", "sources/mjcf_file.py"},
    "pydrake": {"engines/drake.py", "sources/sdf_file.py"},
    "dartpy": {"engines/dart.py"},
    "idyntree": {"engines/idyntree.py"},
}

FILES = sorted(path.relative_to(ROOT).as_posix() for path in ROOT.rglob("*.py"))


def room_of(file: str) -> str:
    return file.split("/")[0].removesuffix(".py")


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


@pytest.mark.parametrize("file", FILES)
def test_every_import_follows_the_arrows(file):
    room = room_of(file)
    if room in ("__init__", "__main__"):
        return  # the front door shows every room's public names, lazily
    for module, _ in imports(file):
        parts = module.split(".")
        if parts[0] == "ur5check" and len(parts) > 1 and parts[1] != room:
            assert parts[1] in MAY_IMPORT[room], f"{file} imports {module}"


@pytest.mark.parametrize("file", FILES)
def test_a_third_party_engine_is_imported_in_its_own_file_only(file):
    for module, for_types in imports(file):
        for engine, homes in ENGINES.items():
            if module.split(".")[0] == engine and not for_types:
                assert file in homes, f"{file} imports {module}"


def test_every_room_is_on_the_plan():
    rooms = {room_of(file) for file in FILES} - {"__init__", "__main__"}
    assert rooms == set(MAY_IMPORT)


def test_no_room_bears_a_public_functions_name():
    assert not {room_of(file) for file in FILES} & set(ur5check.__all__)


def test_there_is_no_circle_of_files():
    graph = {file: set() for file in FILES}
    for file in FILES:
        for module, for_types in imports(file):
            parts = module.split(".")[1:]
            for end in (len(parts), len(parts) - 1):
                target = "/".join(parts[:end]) + ".py"
                if module.startswith("ur5check") and target in graph and not for_types:
                    graph[file].add(target)
    done, path = set(), []

    def visit(file):
        assert file not in path, " → ".join([*path, file])
        if file in done:
            return
        path.append(file)
        for target in sorted(graph[file]):
            visit(target)
        path.pop()
        done.add(file)

    for file in FILES:
        visit(file)


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
        "numba",
        "llvmlite",
        *ENGINES,
    }
    assert not loaded_after("import ur5check") & heavy


def test_the_registry_of_engines_loads_none_of_them():
    asked = "from ur5check.engines.registry import installed; installed()"
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
        alias.name: "." + (node.module or "")
        for block in tree.body
        if isinstance(block, ast.If)
        for node in block.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert typed == ur5check._HOMES
