"""Where a printed curve comes from the paper's own slips: mend them, and see the curve move.

The slips are not typed in here.  `diagnosis` finds them between the listing and Table 1, as it
would between any two arms, and hands back the listing without them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._comparison.arm_pair import pair_up
from .._comparison.diagnosis.diagnosis import Finding, diagnose
from .._dynamics.equations import gravity_torque
from .._robot.serial_arm import SerialArm
from .._robot.states import random_states
from .case_runs import Run

__all__ = ["SlipEffect", "Slips", "find_slips", "slip_effect"]

#: As evidence for a finding, an RMS over a thousand random states is known to a few per cent.
_SAMPLES, _SEED = 1_000, 0


@dataclass(frozen=True, eq=False)
class Slips:
    """What diagnosis found in the listing, held against Table 1.

    findings : the mistakes, in the order of mending
    mended : the listing less those that are its own, under the gravity of Table 1's arm
    samples, seed : random states by which a finding's worth was measured
    """

    findings: tuple[Finding, ...]
    mended: SerialArm
    samples: int
    seed: int


@dataclass(frozen=True)
class SlipEffect:
    """What the slips do to the watched torque of a case.

    printed, mended, table : its value of largest size, with its sign [N m]: as printed, with the
        slips mended, and of Table 1's arm.  All three at the state where Table 1's is largest.
    gap, left : largest distance from Table 1's arm, before and after mending [N m]
    """

    case: int
    joint: int
    printed: float
    mended: float
    table: float
    gap: float
    left: float

    @property
    def ratio(self) -> float:
        """Printed over what it should be, negative where the sign is wrong."""
        return self.printed / self.table


def find_slips(listing: SerialArm, table_1: SerialArm) -> Slips:
    """Let diagnosis look."""
    found = diagnose(pair_up(listing, table_1), random_states(listing.n, _SAMPLES, _SEED))
    mended = found.mended_a.with_gravity(table_1.gravity)
    return Slips(found.findings, mended, _SAMPLES, _SEED)


def slip_effect(slips: Slips, printed: Run, table: Run) -> SlipEffect:
    """How far the printed torque of a case is explained by the slips.

    printed, table : the same case for the listing and for Table 1's arm
    """
    mended = gravity_torque(slips.mended, table.q)
    joint = table.case.watched or int(np.abs(table.torque).max(axis=0).argmax()) + 1
    k = int(np.abs(table.torque[:, joint - 1]).argmax())
    curves = (tau[:, joint - 1] for tau in (printed.torque, mended, table.torque))
    as_printed, less_slips, right = curves
    return SlipEffect(
        table.case.number,
        joint,
        float(as_printed[k]),
        float(less_slips[k]),
        float(right[k]),
        float(np.abs(as_printed - right).max()),
        float(np.abs(less_slips - right).max()),
    )
