"""The head of every JSON report: what it is, who made it, from what."""

from __future__ import annotations

from collections.abc import Iterable

from .._robot.serial_arm import SerialArm
from .json_values import Report
from .provenance import Provenance, inputs_of

__all__ = ["json_head"]


def json_head(
    kind: str,
    arms: Iterable[SerialArm],
    command: str,
    seed: int | None = None,
    samples: int | None = None,
) -> Report:
    """What every report begins with: the fields of docs/json.md, "In every report".

    kind : "difference" for ur5check.difference/1;  arms : whose files were read
    seed, samples : of the random states; left out where there were none
    """
    made = Provenance(inputs_of(arms), seed, samples, command)
    head: Report = {
        "schema": f"ur5check.{kind}/1",
        "tool": {"name": "ur5check", "version": made.version, "libraries": made.libraries},
        "command": made.command or None,
        "inputs": [{"name": name, "sha256": digest} for name, digest in made.inputs],
    }
    return head if samples is None else {**head, "seed": seed, "samples": samples}
