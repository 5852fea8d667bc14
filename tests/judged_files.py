"""Two judged files with all that a report of findings may have to say."""

from __future__ import annotations

from pathlib import Path

from ur5check._rules.examples import joint, link, robot
from ur5check._validation.configuration import Configuration, read_configuration
from ur5check._validation.verdict import Request, Verdict, VerdictSet, compare_verdicts, verdicts

#: An error, a warning that is accepted, and a name with characters to escape.
SPOILED = robot(
    joint(limit='<limit lower="-2" upper="2" effort="0" velocity="3"/>'), link(mass="-1")
)
SPOILED_NAME = "50% of, a: b.urdf"
GOOD = robot(name="good")
ACCEPTED = """\
[[accepted]]
rule = "JNT103"
subject = "joint 'j'"
file = "50*"
reason = "a <passive> joint"

[[accepted]]
rule = "JNT103"
file = "good.urdf"
reason = "long gone"
"""


def judged(folder: Path, spoiled: str = SPOILED) -> tuple[VerdictSet, Configuration]:
    """The verdicts on a spoiled and a good file in the folder, which is the current one."""
    (folder / SPOILED_NAME).write_text(spoiled)
    (folder / "good.urdf").write_text(GOOD)
    (folder / "ur5check.toml").write_text(ACCEPTED)
    configuration = read_configuration(folder / "ur5check.toml")
    requests = [Request(name, samples=5) for name in (SPOILED_NAME, "good.urdf")]
    found: list[Verdict] = list(verdicts(requests, configuration, "error"))
    return compare_verdicts(found, None, configuration), configuration
