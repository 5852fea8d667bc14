"""The numbers of an arm that its dynamics depend on, as one hash."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable

import numpy as np

from ..arm.serial_arm import SerialArm
from ..version import __version__

__all__ = ["fingerprint"]


def fingerprint(arms: Iterable[SerialArm], *words: str) -> str:
    """A hash of the arms' geometry, inertias, motors and gravity, and of `words`.

    Names and limits are no part of it: they change no torque.
    """
    digest = hashlib.sha256("\0".join([__version__, *words]).encode())
    for arm in arms:
        digest.update(f"arm {arm.n}".encode())
        for values in (arm.base.matrix(), arm.gravity, arm.parameters(), arm.armature):
            digest.update(np.ascontiguousarray(values, dtype=np.float64).tobytes())
        for joint, link in zip(arm.joints, arm.links, strict=True):
            digest.update(joint.kind.encode())
            digest.update(np.ascontiguousarray(joint.axis).tobytes())
            digest.update(np.ascontiguousarray(link.far_end.matrix()).tobytes())
    return digest.hexdigest()[:32]
