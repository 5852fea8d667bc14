"""Files of the repository that must agree with one another."""

from __future__ import annotations

import re

import ur5check
from repository import REPOSITORY


def test_version_and_date_agree_everywhere() -> None:
    citation = (REPOSITORY / "CITATION.cff").read_text("utf-8")
    changes = (REPOSITORY / "CHANGELOG.md").read_text("utf-8")
    releases = re.findall(r"^## (\d+\.\d+\.\d+) – (\d{4}-\d\d-\d\d)$", changes, re.MULTILINE)
    assert len(releases) == len(re.findall(r"^## \d", changes, re.MULTILINE)), "a date is missing"
    version, date = releases[0]
    assert version == ur5check.__version__
    assert f"\nversion: {version}\n" in citation
    assert f"\ndate-released: {date}\n" in citation
    assert [date for _, date in releases] == sorted((d for _, d in releases), reverse=True)


def test_hooks_and_sessions_run_the_same_tools() -> None:
    hooks = (REPOSITORY / ".pre-commit-config.yaml").read_text("utf-8")
    sessions = (REPOSITORY / "noxfile.py").read_text("utf-8")
    for tool in re.findall(r"entry: (\w+)", hooks):
        assert f'session.run("{tool}"' in sessions


def test_ci_checks_every_supported_version_of_python() -> None:
    workflow = (REPOSITORY / ".github" / "workflows" / "checks.yml").read_text("utf-8")
    project = (REPOSITORY / "pyproject.toml").read_text("utf-8")
    oldest = re.findall(r'requires-python = ">=(3\.\d+)"', project)
    matrices = re.findall(r"python: \[(.*)\]", workflow)
    assert len(matrices) == 2
    for matrix in matrices:
        assert re.findall(r'"(3\.\d+)"', matrix)[:1] == oldest
