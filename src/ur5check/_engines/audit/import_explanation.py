"""Does an engine compute what it believes?

Its torques are held against our recursion on the arm that it has read.  Where the two agree to
rounding, its import explains all that it says otherwise.  An adapter may also let through what it
should have repaired: the engine's own gravity instead of the one it was told, its own joint order
instead of the arm's.  Both are tried.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np

from ..._dynamics.recursion import rnea
from ..._robot.states import States
from ..._robot.transforms import Array
from .audit_tolerances import torque_rounding
from .import_audit import Import
from .import_difference import Kind

__all__ = ["Belief", "belief_of"]


@dataclass(frozen=True)
class Belief:
    """explained : whether the engine computes what it believes
    gap : the largest |Δτ| between the two [N m]
    follows : what of its own the engine follows in doing so: "gravity", "order"
    """

    explained: bool
    gap: float
    follows: tuple[Kind, ...] = ()


def belief_of(imported: Import, torque: Array, states: States, gravity: Array) -> Belief:
    """Hold an engine's torques, shape (N, n), against those of the arm that it believes in.

    gravity : what the engine was told, in the arm's base frame [m/s²]
    """
    limit = torque_rounding(imported.arm, torque)
    tried = [
        (float(np.nan_to_num(np.abs(torque - tau), nan=np.inf).max()), follows)
        for follows, tau in _readings(imported, states, gravity)
    ]
    for gap, follows in tried:
        if gap <= limit:
            return Belief(True, gap, follows)
    return Belief(False, tried[0][0])


def _readings(
    imported: Import, states: States, gravity: Array
) -> Iterator[tuple[tuple[Kind, ...], Array]]:
    """What our recursion says of the believed arm, the plain reading first."""
    both: tuple[Kind, ...] = ("gravity", "order")
    own = [kind for kind in both if imported.kinds[kind]]
    for chosen in product((False, True), repeat=len(own)):
        follows = tuple(kind for kind, taken in zip(own, chosen, strict=True) if taken)
        g = imported.imported_model.gravity if "gravity" in follows else gravity
        order = _order(imported) if "order" in follows else list(range(imported.arm.n))
        if order is not None:
            # The engine takes entry k of an array for its own joint k, and answers likewise.
            q, qd, qdd = (array[:, order] for array in (states.q, states.qd, states.qdd))
            yield follows, rnea(imported.imported_arm, q, qd, qdd, g)[:, np.argsort(order)]


def _order(imported: Import) -> list[int] | None:
    """For each of the arm's joints, where the engine has it; None if it lacks one."""
    names = [joint.name for joint in imported.imported_model.joints]
    wanted = imported.arm.joint_names
    return [names.index(name) for name in wanted] if sorted(names) == sorted(wanted) else None
