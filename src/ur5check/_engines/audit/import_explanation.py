"""Whether an engine's import explains its torques.

They are compared with those of the recursion for the imported arm.  Where the two agree to
rounding, the import explains every difference from the arm as written.  An adapter may also pass
on what it should have converted: the engine's default gravity instead of the given one, its own
joint order instead of the arm's.  Both are tried.
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
from .import_audit import ImportAudit
from .import_difference import Kind

__all__ = ["ImportExplanation", "explain_import"]


@dataclass(frozen=True)
class ImportExplanation:
    """explained : whether the engine's torques are those of the imported arm
    gap : the largest |Δτ| between the two [N m]
    follows : which of its defaults the engine uses in doing so: "gravity", "order"
    """

    explained: bool
    gap: float
    follows: tuple[Kind, ...] = ()


def explain_import(
    imported: ImportAudit, torque: Array, states: States, gravity: Array
) -> ImportExplanation:
    """Compare an engine's torques, shape (N, n), with those of the imported arm.

    gravity : the given one, in the arm's base frame [m/s²]
    """
    limit = torque_rounding(imported.arm, torque)
    tried = [
        (float(np.nan_to_num(np.abs(torque - tau), nan=np.inf).max()), follows)
        for follows, tau in _readings(imported, states, gravity)
    ]
    for gap, follows in tried:
        if gap <= limit:
            return ImportExplanation(True, gap, follows)
    return ImportExplanation(False, tried[0][0])


def _readings(
    imported: ImportAudit, states: States, gravity: Array
) -> Iterator[tuple[tuple[Kind, ...], Array]]:
    """Torques of the recursion for the imported arm, first without the engine's defaults."""
    both: tuple[Kind, ...] = ("gravity", "order")
    present = [kind for kind in both if imported.kinds[kind]]
    for chosen in product((False, True), repeat=len(present)):
        follows = tuple(kind for kind, taken in zip(present, chosen, strict=True) if taken)
        g = imported.imported_model.gravity if "gravity" in follows else gravity
        order = _order(imported) if "order" in follows else list(range(imported.arm.n))
        if order is not None:
            # Entry k of an array is the engine's own joint k, in arguments and answers.
            q, qd, qdd = (array[:, order] for array in (states.q, states.qd, states.qdd))
            yield follows, rnea(imported.imported_arm, q, qd, qdd, g)[:, np.argsort(order)]


def _order(imported: ImportAudit) -> list[int] | None:
    """For each of the arm's joints, where the engine has it; None if it lacks one."""
    names = [joint.name for joint in imported.imported_model.joints]
    wanted = imported.arm.joint_names
    return [names.index(name) for name in wanted] if sorted(names) == sorted(wanted) else None
