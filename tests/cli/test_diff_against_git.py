"""`diff --against-git`: a file as a commit has it, with that commit's includes."""

from __future__ import annotations

import json
import subprocess

import pytest

from ur5check._cli.main import main
from ur5check._rules.examples import link

ARM = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find my_arm)/urdf/body.xacro"/>
  <link name="base"/>
  <joint name="j" type="revolute"><origin xyz="0 0 0.3"/>
    <parent link="base"/><child link="arm"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="20" velocity="3"/></joint>
  <xacro:body/>
</robot>
"""
BODY = (
    '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="body">'
    "{}</xacro:macro></robot>"
)
FILE = "my_arm/urdf/arm.urdf.xacro"


def git(*words: str) -> str:
    identity = ["-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"]
    done = subprocess.run(
        ["git", *identity, *words], check=True, capture_output=True, text=True, timeout=30
    )
    return done.stdout


@pytest.fixture
def repository(tmp_path, monkeypatch):
    """A package whose second commit would be a body of another mass; it is not committed yet."""
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "my_arm" / "urdf"
    folder.mkdir(parents=True)
    (tmp_path / "my_arm" / "package.xml").write_text("<package><name>my_arm</name></package>")
    (folder / "arm.urdf.xacro").write_text(ARM)
    (folder / "body.xacro").write_text(BODY.format(link(mass="2")))
    git("init", "-q", "-b", "main")
    git("add", ".")
    git("commit", "-q", "-m", "an arm")
    return tmp_path


def changed(*options: str) -> tuple[int, dict]:
    words = ["diff", FILE, "--against-git", "HEAD", "--samples", "50", "--quick", "--quiet"]
    code = main([*words, "-o", "d.json", *options])
    with open("d.json", encoding="utf-8") as file:  # noqa: PTH123
        return code, json.load(file)


def test_nothing_has_changed(repository):
    code, report = changed()
    assert code == 0
    assert report["since_commit"]["new"] == report["since_commit"]["gone"] == []


def test_an_included_files_change_is_said_in_newton_metres_mass_and_findings(repository):
    body = repository / "my_arm" / "urdf" / "body.xacro"
    heavy = link(mass="3").replace("<inertial>", '<inertial><unknown a="1"/>')
    body.write_text(BODY.format(heavy.replace('ixx="0.008"', 'ixx="0.02"')))
    before = git("status", "--porcelain"), git("worktree", "list")
    code, report = changed()
    assert code == 1
    change = report["since_commit"]
    assert (change["mass_before"], change["mass_after"]) == (2.0, 3.0)
    assert "INE103" in {finding["rule"] for finding in change["new"]}
    # The centre lies 0.1 m from the axis: 1 kg more needs 0.1 · 9.81 N m more to hold.
    worst = report["comparison"]["torques"][0]["max"]
    assert worst > 0.9
    assert report["inputs"][0]["name"].startswith(("HEAD:", "package://"))
    assert (git("status", "--porcelain").replace("?? d.json\n", ""), git("worktree", "list")) == (
        before
    )


def test_a_repaired_finding_is_gone(repository):
    body = repository / "my_arm" / "urdf" / "body.xacro"
    body.write_text(BODY.format(link(ixx="0.02")))
    git("commit", "-q", "-a", "-m", "a wrong tensor")
    body.write_text(BODY.format(link()))
    _, report = changed()
    change = report["since_commit"]
    assert change["new"] == []
    (gone,) = change["gone"]
    assert gone["rule"] == "INE103"
    assert gone["places"][0]["file"] == "HEAD:my_arm/urdf/body.xacro"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((FILE, "--against-git", "nothing"), "names no commit"),
        ((FILE, "--against-git", "--all"), "expected one argument"),
        (("new.urdf", "--against-git", "HEAD"), "has no file new.urdf"),
        ((FILE, FILE, "--against-git", "HEAD"), "no second model"),
        (("paper", "--against-git", "HEAD"), "shipped model"),
        ((FILE,), "required: B"),
    ],
)
def test_bad_usage_is_one_line(repository, capsys, words, said):
    (repository / "new.urdf").write_text(ARM)
    assert main(["diff", *words]) == 2
    assert said in capsys.readouterr().err.splitlines()[-1]


def test_without_a_repository(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.urdf").write_text(ARM)
    assert main(["diff", "a.urdf", "--against-git", "HEAD"]) == 2
    assert "repository" in capsys.readouterr().err
