"""docs/gazebo.md: its commands run, write what it says, and it claims no check that is not made."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

from repository import REPOSITORY
from ur5check._cli.main import main

ROOT = REPOSITORY
PAGE = (ROOT / "docs" / "gazebo.md").read_text("utf-8")
COMMANDS = re.findall(r"^```sh\n(ur5check .*)\n```$", PAGE, re.M)
(TREE,) = re.findall(r"^```text\n(.*?)^```$", PAGE, re.M | re.S)


def test_the_commands_write_what_the_page_says(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert len(COMMANDS) == 2
    for command in COMMANDS:
        assert main([*shlex.split(command)[1:], "--quiet"]) == 0
    written = {
        path.relative_to("ur5_in_gazebo").as_posix()
        for path in Path("ur5_in_gazebo").rglob("*")
        if path.is_file()
    }
    meshes = {path for path in written if "/meshes/" in path}
    assert {path for path in written - meshes if "ros1/" not in path} == set(TREE.split())
    assert len({path for path in meshes if "ros2/" in path}) == 14
    assert Path("listing/ros2/paper_listing_gazebo/urdf/paper_listing.urdf").is_file()
    capsys.readouterr()


def test_every_planted_fault_is_planted():
    script = (ROOT / ".ci" / "check_gazebo.sh").read_text("utf-8")
    planted = re.findall(r'refuses "([^"]+)"', script)
    told = PAGE.partition("Each check was tested with a planted error")[2]
    assert re.findall(r"^- (.+)$", told, re.M) == planted
