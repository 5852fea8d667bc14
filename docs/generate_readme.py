"""Write the outputs that README.md shows, from a fresh run: python docs/generate_readme.py"""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import tempfile
from pathlib import Path

from ur5check._cli.main import main

README = Path(__file__).resolve().parents[1] / "README.md"
BLOCK = re.compile(r"(<!-- output: ur5check (.+?) -->\n```text\n)(.*?)(```\n)", re.DOTALL)


def write_example_files(folder: Path) -> None:
    """vendor.urdf and my_arm.urdf: the UR5; mine.urdf: its upper arm's centre of mass mirrored;
    draft.urdf: the upper arm's tensor in kg mm², a limit in degrees.
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
