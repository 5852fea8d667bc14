"""Write the outputs that README.md shows, from a fresh run: python docs/generate_readme.py"""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import tempfile
from pathlib import Path

import numpy as np

import ur5check
from ur5check._cli.main import main

README = Path(__file__).resolve().parents[1] / "README.md"
BLOCK = re.compile(r"(<!-- output: ur5check (.+?) -->\n```text\n)(.*?)(```\n)", re.DOTALL)


def write_example_files(folder: Path) -> None:
    """vendor.urdf and my_arm.urdf: the UR5; mine.urdf: its upper arm's centre of mass mirrored;
    draft.urdf: the upper arm's tensor in kg mm², a limit in degrees; run.csv: a motion of the UR5.
    """
    main(["expand", "appendix", "--quiet", "-o", str(folder / "vendor.urdf")])
    vendor = (folder / "vendor.urdf").read_text("utf-8")
    (folder / "my_arm.urdf").write_text(vendor, "utf-8")
    draft = vendor.replace('ixx="0.22689067591036005"', 'ixx="226890.67591036005"')
    draft = draft.replace(
        'lower="-6.283185307179586" upper="6.283185307179586"', 'lower="-360" upper="360"', 1
    )
    (folder / "draft.urdf").write_text(draft, "utf-8")
    mine = vendor.replace('xyz="0.0 0.0 0.28"', 'xyz="0.0 0.0 -0.28"')
    (folder / "mine.urdf").write_text(mine, "utf-8")
    _write_recording(folder / "run.csv")


def _write_recording(file: Path) -> None:
    """20 s of sines at 100 Hz, with friction and 1 % of noise."""
    arm, t = ur5check.load("appendix"), np.arange(0.0, 20.0, 0.01)
    w = 2.0 * np.pi * np.array([0.10, 0.13, 0.17, 0.19, 0.23, 0.29])
    q, qd = np.sin(np.outer(t, w)), w * np.cos(np.outer(t, w))
    tau = ur5check.rnea(arm, q, qd, -(w**2) * q)
    tau += 3.0 * qd + 2.0 * np.tanh(qd / 0.02)
    tau += 0.01 * tau.std(axis=0) * np.random.default_rng(0).standard_normal(tau.shape)
    names = [f"{word}{i}" for word in ("q", "qd", "tau") for i in range(1, 7)]
    header = ",".join(["t", *names])
    np.savetxt(file, np.column_stack([t, q, qd, tau]), delimiter=",", header=header, comments="")


def summary_of(arguments: list[str]) -> str:
    """What a command prints above its first table or fact, run in the current folder."""
    output = io.StringIO()
    with contextlib.redirect_stdout(output):
        main([*arguments, "--quiet"])
    text = output.getvalue().partition("\n── ")[0].partition("\nrobot  ")[0]
    lines = text.strip().splitlines()
    return "".join(f"{line.rstrip()}\n" for line in lines)


def with_fresh_outputs(text: str) -> str:
    """The README's text with each shown output replaced by that of a fresh run."""
    return BLOCK.sub(
        lambda match: match[1] + summary_of(shlex.split(match[2])) + match[4],
        text,
    )


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        write_example_files(Path(folder))
        os.chdir(folder)
        README.write_text(with_fresh_outputs(README.read_text("utf-8")), "utf-8")
