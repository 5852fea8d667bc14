"""Writes docs/diagnosis.md: the text of diagnosis.in.md, the list of mistakes as a table, and what
the
page's examples print.

python docs/generate_catalogue.py
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any

from ur5check._comparison.diagnosis import mistake_search as search
from ur5check._comparison.diagnosis.mistakes import MISTAKES

HERE = Path(__file__).resolve().parent
PAGE = HERE / "diagnosis.md"
TEMPLATE = HERE / "diagnosis.in.md"

SPOILS = {
    "mass": "mass",
    "centre": "centre of mass",
    "tensor": "tensor",
    "reach": "length",
    "turn": "twist",
    "body": "mass, centre and tensor",
}

#: What concerns the whole arm: what it spoils, what happened, how to repair it.
WHOLE_ARM = {
    "dh-convention": (
        "all lengths and twists",
        "the DH table reads by the other convention",
        'say which: `convention = "standard"` or `"modified"`',
    ),
    "joint-reversed": ("nothing: a convention", "joints turn the other way", "compare at −q there"),
    "zero-shifted": (
        "nothing: a convention",
        "joints count from another zero",
        "add the offset when states are exchanged",
    ),
    "base-turned": (
        "nothing: a convention",
        "the base stands another way",
        "turn poses, and gravity, when they are exchanged",
    ),
    "gravity-sign": (
        "gravity",
        "gravity points up in one of the two",
        "give the vector to where things fall",
    ),
    "gravity-value": ("gravity", "9.81 here, 9.806 there", "compare under one gravity"),
    "motor-inertia": (
        "motor inertia",
        "a motor's inertia is in one model only, or differs",
        "reflect it through the gear, n² J, in both models or in neither",
    ),
    "gravity-direction": ("gravity", "gravity points another way", "compare under one gravity"),
}

#: Who met a mistake: a thread as owner/repository#number, or a shipped model.
MET = {
    "body-dropped": ("stack-of-tasks/pinocchio#2677", "ipab-slmc/exotica#676"),
    "centre-other-end": ("ros-industrial/universal_robot#426", "erd-ur5"),
    "centre-other-frame": ("petercorke/robotics-toolbox-python#686",),
    "centre-of-shape": ("ros-industrial/universal_robot#504", "appendix"),
    "tensor-not-rotated": (
        "petercorke/robotics-toolbox-python#686",
        "google-deepmind/mujoco#3559",
        "dartsim/dart#47",
    ),
    "tensor-axes": ("UniversalRobots/Universal_Robots_ROS2_Description#195", "paper"),
    "cylinder-3r-squared": ("paper",),
    "cylinder-radius": ("ros-industrial/universal_robot#426", "erd-ur5"),
    "cylinder-twelfth": ("appendix",),
    "length-sign": ("paper-listing",),
    "rotation-rounded": ("paper-listing",),
    "dh-convention": ("petercorke/robotics-toolbox-python#688",),
    "joint-reversed": ("petercorke/robotics-toolbox-python#290",),
    "zero-shifted": ("petercorke/robotics-toolbox-python#290",),
    "base-turned": (
        "ros-industrial/universal_robot#505",
        "petercorke/robotics-toolbox-python#290",
    ),
    "gravity-sign": ("JuliaRobotics/RigidBodyDynamics.jl#2",),
    "gravity-value": ("paper-listing",),
}

_BLOCK = re.compile(r"```python\n(.*?)```\n", re.S)


def page() -> str:
    """The whole page."""
    text = TEMPLATE.read_text(encoding="utf-8")
    text = re.sub(
        r"«(\w+)»", lambda found: f"{vars(search)[found[1]]:.10f}".rstrip("0").rstrip("."), text
    )
    text = text.replace("[[links]]", table(link_rows())).replace("[[arm]]", table(arm_rows()))
    return with_outputs(text)


def link_rows() -> Iterator[tuple[str, ...]]:
    """A row for each mistake in a link's numbers."""
    for mistake in MISTAKES:
        yield mistake.id, SPOILS[mistake.quantity], mistake.says, mistake.repair, met(mistake.id)


def arm_rows() -> Iterator[tuple[str, ...]]:
    """A row for each mistake, or convention, of the whole arm."""
    for name, words in WHOLE_ARM.items():
        yield name, *words, met(name)


def table(rows: Iterable[tuple[str, ...]]) -> str:
    """Rows of (id, spoils, what happened, how to repair, who met it)."""
    lines = ["| id | spoils | what happened | how to repair it | met by |", "|---|---|---|---|---|"]
    for name, *cells in rows:
        escaped = (cell.replace("|", chr(92) + "|") for cell in cells)
        lines.append(f"| `{name}` | {' | '.join(escaped)} |")
    return "\n".join(lines)


def met(name: str) -> str:
    """Threads as links, models as code."""
    return ", ".join(_cited(source) for source in MET.get(name, ())) or "—"


def _cited(source: str) -> str:
    owner_and_repository, _, number = source.partition("#")
    if not number:
        return f"`{source}`"
    repository = owner_and_repository.partition("/")[2]
    return f"[{repository}#{number}](https://github.com/{owner_and_repository}/issues/{number})"


def with_outputs(text: str) -> str:
    """The text with each Python block followed by what it prints; blocks share their names."""
    names: dict[str, Any] = {}

    def run(block: re.Match[str]) -> str:
        said = StringIO()
        with redirect_stdout(said):
            exec(compile(block[1], TEMPLATE.name, "exec"), names)  # noqa: S102 - our own page
        lines = [line.rstrip() for line in said.getvalue().splitlines()]
        return block[0] + ("\n```text\n" + "\n".join(lines) + "\n```\n" if lines else "")

    return _BLOCK.sub(run, text)


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
