"""The plugin's options and hooks, which pytest loads in every run (entry point `pytest11`).

Silent until it is asked, by `--ur5check FILE` or a setting `pytest = […]` of the project: before,
this file alone is imported.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from pathlib import Path

    from .request import PluginRequest

_REQUEST: pytest.StashKey[PluginRequest] = pytest.StashKey()


def pytest_addoption(parser: pytest.Parser) -> None:
    """--ur5check and what belongs to it."""
    group = parser.getgroup("ur5check", "dynamics models of robot arms (ur5check)")
    group.addoption(
        "--ur5check",
        action="append",
        default=[],
        metavar="FILE",
        help="check this model, or all of a folder, with every rule; repeatable",
    )
    group.addoption(
        "--ur5check-against",
        metavar="MODEL",
        help="also compare each model's torques with this one's",
    )
    group.addoption(
        "--ur5check-engines",
        metavar="ENGINES",
        help="also audit what these import, as a,b,c or all",
    )


def pytest_configure(config: pytest.Config) -> None:
    """Add the models to what is collected.  Raises pytest.UsageError for what has no meaning."""
    named = config.getoption("ur5check") or _named_by_project(config.rootpath)
    if not named:
        for option in ("ur5check_against", "ur5check_engines"):
            if config.getoption(option):
                name = f"--{option.replace('_', '-')}"
                raise pytest.UsageError(f"{name} needs a model: --ur5check FILE")
        return
    from . import fixtures
    from .request import PluginRequest

    request = PluginRequest.of(
        named,
        config.getoption("ur5check_against"),
        config.getoption("ur5check_engines"),
        by_option=bool(config.getoption("ur5check")),
        root=config.rootpath,
    )
    config.stash[_REQUEST] = request
    config.pluginmanager.register(fixtures.ModelFixtures(request), "ur5check-fixtures")
    there = {str(config.invocation_params.dir / arg) for arg in config.args}
    config.args += [str(path) for path in request.files if str(path) not in there]


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """A model that is asked for, as a file of test items."""
    request = parent.config.stash.get(_REQUEST, None)
    if request is None or file_path not in request.files:
        return None
    from .items import ModelFile

    return ModelFile.from_parent(parent, path=file_path, request=request)


def _named_by_project(root: Path) -> list[str]:
    """The setting `pytest` of the configuration in the root folder, read without ur5check."""
    for name in ("ur5check.toml", "pyproject.toml"):
        file = root / name
        if not file.is_file():
            continue
        data = file.read_bytes()
        if b"pytest" not in data or (name == "pyproject.toml" and b"[tool.ur5check" not in data):
            continue
        import tomllib

        try:
            table = tomllib.loads(data.decode("utf-8"))
        except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise pytest.UsageError(f"{file}: {error}") from None
        if name == "pyproject.toml":
            table = table["tool"]["ur5check"]
        return [str(pattern) for pattern in table.get("pytest", [])]
    return []
