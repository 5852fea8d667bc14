"""A hash of everything generated code depends on: the arm's numbers and the generating code."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from functools import cache
from pathlib import Path

import numpy as np

from ..._robot.serial_arm import SerialArm
from ..._version import __version__

__all__ = ["fingerprint"]


def fingerprint(arms: Iterable[SerialArm], *words: str) -> str:
    """A hash of the arms' geometry, inertias, motors and gravity, and of `words`.

    Without names and limits, which change no torque.
    """
    digest = hashlib.sha256("\0".join([__version__, _generator_hash(), *words]).encode())
    for arm in arms:
        digest.update(f"arm {arm.n}".encode())
        for values in (arm.base.matrix(), arm.gravity, arm.parameters(), arm.armature):
            digest.update(np.ascontiguousarray(values, dtype=np.float64).tobytes())
        for joint, link in zip(arm.joints, arm.links, strict=True):
            digest.update(joint.kind.encode())
            digest.update(np.ascontiguousarray(joint.axis).tobytes())
            digest.update(np.ascontiguousarray(link.link_tip_frame.matrix()).tobytes())
    return digest.hexdigest()[:32]


@cache
def _generator_hash() -> str:
    """A hash of the generating code, which changes between releases while the version does not."""
    digest = hashlib.sha256()
    for file in sorted(Path(__file__).parents[1].rglob("*.py")):
        digest.update(file.read_bytes())
    return digest.hexdigest()
