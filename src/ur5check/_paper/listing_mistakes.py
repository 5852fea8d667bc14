"""The mistakes of the paper's listing, and their effect on each of the nine cases.

The mistakes are not listed here: `diagnosis` finds them between the listing and the controller's
DH, as between any two arms, and returns the listing without them.  Both arms have the listing's
gravity: 9.806 m/s² is a value of its own (standard gravity is 9.80665), not a mistake.
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
from .table_readings import literal_reading

__all__ = ["ListingMistakes", "MistakeEffect", "find_listing_mistakes", "mistake_effect"]

#: A thousand random states give an RMS to a few per cent.
_SAMPLES, _SEED = 1_000, 0


@dataclass(frozen=True, eq=False)
class ListingMistakes:
    """What diagnosis found in the listing, compared with the controller's DH.

    diagnosis : of the listing against the controller's DH
    repaired : the listing without them
    controller : the same masses, centres and tensors on the controller's DH, under the listing's
        gravity
    literal : the same on Table 1 with the appendix's a2 and a3 (`table_readings`)
    samples, seed : of the random states at which the effect of each mistake was measured
    """

    diagnosis: Diagnosis
    repaired: SerialArm
    controller: SerialArm
    literal: SerialArm
    samples: int
    seed: int


@dataclass(frozen=True)
class MistakeEffect:
    """What the mistakes do to the watched torque of a case, all under the listing's gravity.

    printed, repaired, literal, table : its value, with its sign [N m]: as printed, with the
        mistakes repaired, of Table 1 read literally, and of the controller's DH; at the state where
        the last is largest
    gap, left : largest distance from the controller's DH, before and after repairing [N m]
    literal_gap : largest distance of the printed torque from Table 1 read literally [N m]
    literal_peak : largest size of the torque of Table 1 read literally [N m]
    """

    case: int
    joint: int
    printed: float
    repaired: float
    literal: float
    table: float
    gap: float
    left: float
    literal_gap: float
    literal_peak: float

    @property
    def ratio(self) -> float:
        """Printed over what it should be, negative where the sign is wrong."""
        return self.printed / self.table


def find_listing_mistakes(listing: SerialArm, controller: SerialArm) -> ListingMistakes:
    """Run the diagnosis on the listing and the controller's DH.

    controller : the listing's masses, centres and tensors on the controller's DH
    """
    controller = controller.with_gravity(listing.gravity)
    found = diagnose(pair_up(listing, controller), random_states(listing.n, _SAMPLES, _SEED))
    return ListingMistakes(
        found, found.repaired_a, controller, literal_reading(controller), _SAMPLES, _SEED
    )


def mistake_effect(mistakes: ListingMistakes, printed: Run) -> MistakeEffect | None:
    """How much of the printed torque of a case the mistakes explain.

    printed : the case of the listing

    Returns None where the controller's DH has no torque to compare with.
    """
    arms = (mistakes.repaired, mistakes.literal, mistakes.controller)
    torques = [printed.torque, *(gravity_torque(arm, printed.q) for arm in arms)]
    joint = printed.case.watched or int(np.abs(torques[-1]).max(axis=0).argmax()) + 1
    curves = [tau[:, joint - 1] for tau in torques]
    k = int(np.abs(curves[-1]).argmax())
    if abs(curves[-1][k]) <= printed.rounding:
        return None
    as_printed, repaired, literal, right = curves
    return MistakeEffect(
        case=printed.case.number,
        joint=joint,
        printed=float(as_printed[k]),
        repaired=float(repaired[k]),
        literal=float(literal[k]),
        table=float(right[k]),
        gap=float(np.abs(as_printed - right).max()),
        left=float(np.abs(repaired - right).max()),
        literal_gap=float(np.abs(as_printed - literal).max()),
        literal_peak=float(np.abs(literal).max()),
    )
