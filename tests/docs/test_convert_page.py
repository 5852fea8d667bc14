"""The commands of docs/convert.md run, one after the other, and its table tells the truth."""

from __future__ import annotations

import re
import shlex
from dataclasses import replace

import pytest

import ur5check
from examples import random_arm
from repository import REPOSITORY
from ur5check._cli.main import main
from ur5check._io.dh.dh_writer import dh_toml_of
from ur5check._io.mjcf.mjcf_writer import mjcf_of
from ur5check._io.urdf.urdf_writer import urdf_of
from ur5check._robot import Limits

PAGE = (REPOSITORY / "docs" / "convert.md").read_text(encoding="utf-8")
WRITERS = ((urdf_of, ".urdf"), (mjcf_of, ".xml"), (dh_toml_of, ".toml"))


def test_commands_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (block,) = re.findall(r"```sh\n(.*?)```", PAGE, re.S)
    for line in block.splitlines():
        program, *words = shlex.split(line)
        assert program == "ur5check"
        assert main(words) == 0, capsys.readouterr().err


def rows():
    for line in PAGE.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 4 and cells[0] and not cells[0].startswith("-"):
            yield cells[0], cells[1:]


CARRIED = {
    "gravity": lambda arm: tuple(arm.gravity),
    "motor inertia (`armature`)": lambda arm: tuple(arm.armature),
    "damping, friction": lambda arm: [(j.damping, j.friction) for j in arm.joints],
    "position limits, effort": lambda arm: [
        (j.limits.lower, j.limits.upper, j.limits.effort) for j in arm.joints
    ],
    "velocity limits": lambda arm: [j.limits.velocity for j in arm.joints],
}


@pytest.mark.parametrize(("row", "cells"), [r for r in rows() if r[0] in CARRIED])
def test_the_table_says_what_each_format_carries(row, cells, tmp_path):
    arm = random_arm(3, seed=3)
    joints = tuple(
        replace(j, limits=Limits(-1.0, 2.0, 3.0, 4.0), armature=0.3, damping=0.2, friction=0.1)
        for j in arm.joints
    )
    arm, of = replace(arm, joints=joints), CARRIED[row]
    for (write, suffix), cell in zip(WRITERS, cells, strict=True):
        path = tmp_path / f"arm{suffix}"
        path.write_text(write(arm), encoding="utf-8")
        carried = of(ur5check.load(path)) == of(arm)
        assert carried == (cell == "yes"), (row, suffix)
        if cell == "a comment":
            assert "cannot carry" in path.read_text(encoding="utf-8")


def test_the_whole_table_was_tried():
    assert {row for row, _ in rows()} >= set(CARRIED)
