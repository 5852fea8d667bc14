"""docs/ci.md and the example repository: every command and file of theirs is run or checked."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from repository import REPOSITORY

PAGE = (REPOSITORY / "docs" / "ci.md").read_text("utf-8")
EXAMPLE = REPOSITORY / "examples" / "robot_description_repo"
BLOCKS = re.findall(r"```(\w+)\n(.*?)```", PAGE, re.DOTALL)
COMMANDS = [line for kind, text in BLOCKS if kind == "sh" for line in text.splitlines()]
ACTION = yaml.safe_load((REPOSITORY / "action.yml").read_text("utf-8"))
WORKFLOW = yaml.safe_load((EXAMPLE / ".github" / "workflows" / "robot.yml").read_text("utf-8"))
IDENTITY = "-c user.name=a -c user.email=a@example.org -c commit.gpgsign=false"
#: The installing command is run by .ci/run; `diff` ends with 1 where a commit changes something.
INSTALLING = "python -m pip install ur5check"


def shell(line: str, folder: Path, **more: str) -> subprocess.CompletedProcess[str]:
    """A line of bash, where `ur5check`, `pytest` and `pre-commit` are those of this environment."""
    environment = {
        **os.environ,
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
        "PYTEST_ADDOPTS": "-p ur5check._pytest.plugin -p no:cacheprovider",
        **more,
    }
    return subprocess.run(
        ["bash", "-euo", "pipefail", "-c", line],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """The example as a repository of its own, with two commits."""
    folder = tmp_path / "two_link_description"
    shutil.copytree(EXAMPLE, folder, ignore=shutil.ignore_patterns("__pycache__"))
    done = shell(
        "ur5check expand urdf/arm.urdf.xacro --quiet -o vendor.urdf; git init -q -b main; "
        f"git add .; git {IDENTITY} commit -q -m arm",
        folder,
    )
    assert done.returncode == 0, done.stderr
    return folder


def plant(project: Path) -> int:
    """A mass that is negative.  Returns its line in link.xacro."""
    file = project / "urdf" / "link.xacro"
    text = file.read_text("utf-8").replace('<mass value="${mass}"/>', '<mass value="${-mass}"/>')
    file.write_text(text, "utf-8")
    return next(k for k, line in enumerate(text.splitlines(), 1) if "${-mass}" in line)


def test_the_page_has_five_commands_at_most_before_ci_is_green() -> None:
    first = next(text for kind, text in BLOCKS if kind == "sh")
    assert first.startswith(f"{INSTALLING}\n")
    assert len(first.splitlines()) + 2 <= 5  # and `git add`, `git commit`


@pytest.mark.parametrize("line", sorted({line for line in COMMANDS if line != INSTALLING}))
def test_each_command_of_the_page_runs(project: Path, line: str) -> None:
    if "--update-baseline" not in line and "--baseline" in line:
        shell(f"{line} --update-baseline", project)
    done = shell(line, project)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize(
    "file", [".github/workflows/robot.yml", ".gitlab-ci.yml", ".pre-commit-config.yaml"]
)
def test_the_files_on_the_page_are_those_of_the_example(file: str) -> None:
    assert (EXAMPLE / file).read_text("utf-8") in [text for kind, text in BLOCKS if kind == "yaml"]


def test_the_lines_for_ros_are_those_of_the_example() -> None:
    (shown,) = [text for kind, text in BLOCKS if kind == "cmake"]
    assert shown in (EXAMPLE / "CMakeLists.txt").read_text("utf-8")


@pytest.mark.parametrize(
    ("schema", "file"),
    [
        ("vendor.github-actions", "action.yml"),
        ("vendor.github-workflows", "examples/robot_description_repo/.github/workflows/robot.yml"),
        ("vendor.gitlab-ci", "examples/robot_description_repo/.gitlab-ci.yml"),
    ],
)
def test_a_file_follows_its_hosts_schema(tmp_path: Path, schema: str, file: str) -> None:
    check = f"{sys.executable} -m check_jsonschema --builtin-schema {schema}"
    assert shell(f"{check} {REPOSITORY / file}", tmp_path).returncode == 0
    wrong = tmp_path / "wrong.yml"
    text = (REPOSITORY / file).read_text("utf-8")
    wrong.write_text(re.sub(r"\b(runs-on|using|script):", "unknown:", text), "utf-8")
    assert shell(f"{check} {wrong}", tmp_path).returncode == 1


def action(project: Path, tmp_path: Path, **inputs: str) -> subprocess.CompletedProcess[str]:
    """The action's step as the runner runs it."""
    (step,) = [step for step in ACTION["runs"]["steps"] if step["name"] == "Validate"]
    values = {name: entry["default"] for name, entry in ACTION["inputs"].items()} | inputs
    variables = {
        key: re.sub(r"\$\{\{ inputs\.(\w+) \}\}", lambda m: values[m[1]], text)
        for key, text in step["env"].items()
    }
    runner = {"RUNNER_TEMP": str(tmp_path), "GITHUB_STEP_SUMMARY": str(tmp_path / "summary")}
    return shell(step["run"], project, **variables, **runner)


def test_a_planted_fault_gives_one_annotation_on_its_line(project: Path, tmp_path: Path) -> None:
    clean = action(project, tmp_path, files="urdf/arm.urdf.xacro")
    assert clean.returncode == 0, clean.stderr
    assert "::error" not in clean.stdout
    file = project / "urdf" / "arm.urdf.xacro"
    text = file.read_text("utf-8").replace('lower="-2" upper="2"', 'lower="2" upper="-2"')
    file.write_text(text, "utf-8")
    line = next(k for k, row in enumerate(text.splitlines(), 1) if 'lower="2"' in row)
    found = action(project, tmp_path, files="urdf/*.urdf.xacro")
    assert found.returncode == 1
    annotations = [row for row in found.stdout.splitlines() if row.startswith("::")]
    assert len(annotations) == 1
    assert annotations[0].startswith(f"::error file=urdf/arm.urdf.xacro,line={line},col=")
    assert "title=JNT105" in annotations[0]
    assert "### ur5check: FAIL" in (tmp_path / "summary").read_text("utf-8")
    assert (project / "ur5check.sarif").is_file()


def test_a_fault_in_a_macro_is_annotated_in_the_macro(project: Path, tmp_path: Path) -> None:
    line = plant(project)
    found = action(project, tmp_path, files="urdf/", options="--samples 10")
    assert found.returncode == 1
    assert f"::error file=urdf/link.xacro,line={line},col=" in found.stdout


def test_the_steps_of_the_workflow_run(project: Path, tmp_path: Path) -> None:
    steps = [step["run"] for step in WORKFLOW["jobs"]["model"]["steps"] if "run" in step]
    assert steps[0] == INSTALLING
    for step in steps[1:]:
        done = shell(step, project, GITHUB_STEP_SUMMARY=str(tmp_path / "summary"))
        assert done.returncode == 0, done.stdout + done.stderr
    assert "### ur5check: PASS" in (tmp_path / "summary").read_text("utf-8")
    plant(project)
    assert shell(steps[1], project).returncode == 1


def test_the_script_of_gitlab_runs(project: Path) -> None:
    (job,) = yaml.safe_load((EXAMPLE / ".gitlab-ci.yml").read_text("utf-8")).values()
    assert job["script"][0] == INSTALLING
    assert shell(job["script"][1], project).returncode == 0
    assert (project / job["artifacts"]["reports"]["junit"]).is_file()


def test_the_hook_runs_before_a_commit(project: Path, tmp_path: Path) -> None:
    home = {"PRE_COMMIT_HOME": str(tmp_path / "cache")}
    shutil.copy(project / "urdf" / "arm.urdf.xacro", project / "urdf" / "second.urdf.xacro")
    shell("git add .", project)
    passed = shell("pre-commit run --all-files", project, **home)
    assert passed.returncode == 0, passed.stdout
    plant(project)
    refused = shell("pre-commit run --all-files", project, **home)
    assert refused.returncode == 1
    assert "INE101" in refused.stdout


def test_the_hooks_manifest_is_valid_and_that_of_the_example(tmp_path: Path) -> None:
    manifest = REPOSITORY / ".pre-commit-hooks.yaml"
    assert shell(f"pre-commit validate-manifest {manifest}", tmp_path).returncode == 0
    (hook,) = yaml.safe_load(manifest.read_text("utf-8"))
    config = yaml.safe_load((EXAMPLE / ".pre-commit-config.yaml").read_text("utf-8"))
    (local,) = config["repos"][0]["hooks"]
    for key in ("id", "entry", "files", "require_serial"):
        assert hook[key] == local[key]


def test_the_test_of_the_package_runs(project: Path) -> None:
    assert shell("python -m pytest -q test", project).returncode == 0
    plant(project)
    assert shell("python -m pytest -q test", project).returncode == 1
