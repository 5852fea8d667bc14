"""`ur5check convert`: what is written reads back, and says where it came from."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

import ur5check as library
from ur5check._io.shipped_models import SHIPPED_MODELS
from ur5check._robot.states import random_states

if TYPE_CHECKING:
    from .conftest import Command

SUFFIX = {"urdf": ".urdf", "mjcf": ".xml", "dh": ".toml"}


@pytest.mark.parametrize("form", SUFFIX)
@pytest.mark.parametrize("name", SHIPPED_MODELS)
def test_what_is_written_is_the_same_arm(
    ur5check: Command, tmp_path: Path, name: str, form: str
) -> None:
    path = tmp_path / f"written{SUFFIX[form]}"
    said = ur5check("convert", name, "-o", path)
    assert (said.code, said.out) == (0, "")
    arm, again = library.load(name), library.load(path)
    if form == "urdf":
        again = again.with_gravity(arm.gravity)
    states = random_states(arm.n, 50, seed=1)
    tau, written = (library.rnea(a, states.q, states.qd, states.qdd) for a in (arm, again))
    assert np.abs(tau - written).max() <= 1e-12 * np.abs(tau).max()
    assert arm.source.inputs[0][1] in path.read_text(encoding="utf-8")


@pytest.mark.parametrize("form", SUFFIX)
def test_converted_again_only_the_comments_change(
    ur5check: Command, tmp_path: Path, form: str
) -> None:
    path = tmp_path / f"written{SUFFIX[form]}"
    assert ur5check("convert", "appendix", "-o", path, "--quiet").code == 0
    again = ur5check("convert", path, "--to", form, "--quiet").out
    assert bare(again) == bare(path.read_text(encoding="utf-8"))
    assert f"Read from {str(path)!r}" in again or f"Read from {path}" in again


def bare(text: str) -> list[str]:
    return [line for line in text.splitlines() if not line.startswith(("<!--", "#"))]


def test_diff_takes_an_mjcf(ur5check: Command, tmp_path: Path) -> None:
    path = tmp_path / "my.xml"
    assert ur5check("convert", "appendix", "-o", path).code == 0
    said = ur5check("diff", path, "appendix", "--samples", 100, "--quick", "--quiet")
    assert said.code == 0, said.out
    path.write_text(path.read_text().replace('mass="8.393"', 'mass="8.493"'))
    said = ur5check("diff", path, "appendix", "--samples", 100, "--quick", "--full")
    assert said.code == 1
    assert "upper_arm_link" in said.out


def test_what_the_format_cannot_carry_is_said_on_stderr(ur5check: Command) -> None:
    said = ur5check("convert", "paper-listing", "--to", "urdf")
    assert "URDF cannot carry gravity" in said.err
    assert said.out.startswith("<?xml")
    assert "velocity limits" in ur5check("convert", "appendix", "--to", "mjcf").err
    assert ur5check("convert", "appendix", "--to", "mjcf", "--quiet").err == ""


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("paper",), "the format is not given; give --to urdf|dh|mjcf, or -o with its suffix"),
        (("paper", "-o", "arm.txt"), "the format is not given"),
        (("paper", "--to", "dh", "-o", "arm.urdf"), "--to dh and -o arm.urdf ask for two formats"),
        (("papr", "--to", "dh"), "did you mean 'paper'?"),
        (("paper", "--to", "sdf"), "invalid choice: 'sdf'"),
    ],
)
def test_bad_usage_writes_nothing(
    ur5check: Command,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    words: tuple[str, ...],
    said: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    result = ur5check("convert", *words)
    assert (result.code, result.out) == (2, "")
    assert said in result.err
    assert not list(tmp_path.iterdir())


def test_an_input_is_not_overwritten(ur5check: Command, tmp_path: Path) -> None:
    path = tmp_path / "arm.xml"
    assert ur5check("convert", "paper", "-o", path).code == 0
    before = path.read_text()
    said = ur5check("convert", path, "-o", path)
    assert said.code == 2
    assert "is one of the inputs" in said.err
    assert path.read_text() == before
