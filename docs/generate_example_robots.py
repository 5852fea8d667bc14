"""Write docs/example-robots.md: the verdict on every URDF of example-robot-data.

    python docs/generate_example_robots.py

Meshes are read; on two cores it takes about a minute.
"""

from __future__ import annotations

import os
from importlib import metadata
from pathlib import Path

from ur5check._io.ros_packages import example_robot_data
from ur5check._validation.configuration import Configuration
from ur5check._validation.verdict import Request, Verdict, verdicts

PAGE = Path(__file__).resolve().parent / "example-robots.md"

HEAD = """\
# What the rules find in example-robot-data

Every URDF of example-robot-data {version}, judged by `ur5check validate` without any option;
written by `python docs/generate_example_robots.py`. Warnings and notes are counted, errors are
named. Each [rule](rules.md) has its page.

An error says that the numbers as written are impossible: for any body (`INE102`, `INE103`), or
for a body of the shape that the package ships (`INE108`, `GEO101`). Every error that needs no
mesh was recomputed with code of another origin. Which of tensor, centre and mesh is wrong, the
rule cannot know: Panda's tensors were identified from torques, which do not determine them; others
are placeholders.

| file | links | mass [kg] | arm | errors | warnings | notes | which errors |
|---|---|---|---|---|---|---|---|
"""


def page() -> str:
    """The whole page."""
    share = example_robot_data()
    assert share is not None  # noqa: S101 - a dependency of ur5check
    robots = share / "robots"
    files = sorted(robots.rglob("*.urdf"))
    requests = [Request(str(file), samples=20) for file in files]
    rows = [
        _row(v, Path(request.model).relative_to(robots))
        for v, request in zip(
            verdicts(requests, Configuration(), "error", jobs=os.cpu_count() or 1),
            requests,
            strict=True,
        )
    ]
    return HEAD.format(version=metadata.version("example-robot-data")) + "\n".join(rows) + "\n"


def _row(v: Verdict, file: Path) -> str:
    j = v.judgement
    found = v.findings.open
    counts = [sum(f.severity == word for f in found) for word in ("error", "warning", "note")]
    links: dict[str, list[str]] = {}
    for finding in found:
        if finding.severity == "error":
            name = finding.subject.split("'")[1] if "'" in finding.subject else finding.subject
            links.setdefault(finding.rule, []).append(name)
    which = "; ".join(
        f"`{rule}` {', '.join(names[:3])}{f' and {len(names) - 3} more' if len(names) > 3 else ''}"
        for rule, names in links.items()
    )
    robot = j.robot
    cells = (
        f"`{file}`",
        str(0 if robot is None else len(robot.links)),
        f"{0.0 if robot is None else robot.mass:.4g}",
        "several chains" if j.arm is None else f"{j.arm.n} joints",
        *map(str, counts),
        which,
    )
    return "| " + " | ".join(cells) + " |"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
