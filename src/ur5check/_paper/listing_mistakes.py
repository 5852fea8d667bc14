"""Where a printed curve comes from the paper's own mistakes: repair them, and see the curve move.

The mistakes are not typed in here.  `diagnosis` finds them between the listing and Table 1, as it
would between any two arms, and hands back the listing without them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._comparison.arm_pair import pair_up
from .._comparison.diagnosis.diagnosis import Diagnosis, diagnose
from .._dynamics.equations import gravity_torque
from .._robot.serial_arm import SerialArm
from .._robot.states import random_states
from .case_runs import Run

__all__ = ["ListingMistakes", "MistakeEffect", "find_listing_mistakes", "mistake_effect"]

#: As evidence for a finding, an RMS over a thousand random states is known to a few per cent.
_SAMPLES, _SEED = 1_000, 0


@dataclass(frozen=True, eq=False)
class ListingMistakes:
    """What diagnosis found in the listing, held against Table 1.

    diagnosis : the mistakes, in the order of repairing
    repaired : the listing less those that are its own, under the gravity of Table 1's arm
    samples, seed : random states at which the effect of each mistake was measured
    """

    diagnosis: Diagnosis
    repaired: SerialArm
    samples: int
    seed: int


@dataclass(frozen=True)
class MistakeEffect:
    """What the mistakes do to the watched torque of a case.

    printed, repaired, table : its value of largest size, with its sign [N m]: as printed, with the
        mistakes repaired, and of Table 1's arm.  All three at the state where Table 1's is largest.
    gap, left : largest distance from Table 1's arm, before and after repairing [N m]
    """

    case: int
    joint: int
    printed: float
    repaired: float
    table: float
    gap: float
    left: float

    @property
    def ratio(self) -> float:
        """Printed over what it should be, negative where the sign is wrong."""
        return self.printed / self.table


def find_listing_mistakes(listing: SerialArm, table_1: SerialArm) -> ListingMistakes:
    """Let diagnosis look."""
    found = diagnose(pair_up(listing, table_1), random_states(listing.n, _SAMPLES, _SEED))
    repaired = found.repaired_a.with_gravity(table_1.gravity)
    return ListingMistakes(found, repaired, _SAMPLES, _SEED)


def mistake_effect(listing_mistakes: ListingMistakes, printed: Run, table: Run) -> MistakeEffect:
    """How far the printed torque of a case is explained by the mistakes.

    printed, table : the same case for the listing and for Table 1's arm
    """
    repaired = gravity_torque(listing_mistakes.repaired, table.q)
    joint = table.case.watched or int(np.abs(table.torque).max(axis=0).argmax()) + 1
    k = int(np.abs(table.torque[:, joint - 1]).argmax())
    curves = (tau[:, joint - 1] for tau in (printed.torque, repaired, table.torque))
    as_printed, without_listing_mistakes, right = curves
    return MistakeEffect(
        table.case.number,
        joint,
        float(as_printed[k]),
        float(without_listing_mistakes[k]),
        float(right[k]),
        float(np.abs(as_printed - right).max()),
        float(np.abs(without_listing_mistakes - right).max()),
    )
