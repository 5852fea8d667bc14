"""What the paper says of the robot's geometry: Table 1, eq. (1) and the vectors between origins."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._comparison.rounded_constants.decimals import half_units
from .._dynamics.kinematics import forward_kinematics
from .._io.loading import load
from .._robot.serial_arm import SerialArm
from .._robot.states import random_states
from .._robot.transforms import Array
from .claim import Claim, ClaimOutcome, Trial, judged
from .evidence import Evidence
from .paper_models import PRINTED, REPAIRED, Form
from .table_readings import eq_1_as_printed, literal_reading

__all__ = ["eq_1_is_the_transform", "table_1_is_the_robot", "vectors_from_dh"]

_POSTURES, _SEED = 200, 0

#: The appendix and the controller write lengths to 1e-6 m; postures and frames are exact to 1e-9.
_SAME_PLACE = 1e-6

LITERAL = "Table 1 with the appendix's a2 = −0.425 m"
POSITIVE = "Table 1 with a2 > 0, the controller's DH"


def table_1_is_the_robot(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Table 1 describes the robot that the appendix describes."""
    claim = Claim(
        "table-1",
        "Table 1 holds the DH parameters of the appendix's UR5",
        f"largest distance between the tool of the table's arm and of the appendix's (base to "
        f"tool0) over {_POSTURES} random postures: at most {_SAME_PLACE:g} m",
        "Table 1; values from the appendix",
        "m",
    )
    controller, robot = evidence.model(REPAIRED).arm, _robot()
    yield from judged(
        claim,
        (
            tool_trial(
                LITERAL, "printed", literal_reading(controller), robot,
                "read literally, −a2 is +0.425 m",
            ),
            tool_trial(POSITIVE, "repaired", controller, robot),
        ),
    )  # fmt: skip


def eq_1_is_the_transform(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Eq. (1) takes the DH parameters to the robot's frames."""
    claim = Claim(
        "eq-1",
        "Eq. (1) is the transform of the standard DH convention",
        "the same distance, with the controller's DH parameters in the equation",
        "eq. (1)",
        "m",
    )
    controller, robot = evidence.model(REPAIRED).arm, _robot()
    yield from judged(
        claim,
        (
            tool_trial(
                "eq. (1), Trans_z,a", "printed", eq_1_as_printed(controller), robot,
                "a is printed along z",
            ),
            tool_trial("eq. (1) with Trans_x,a", "repaired", controller, robot),
        ),
    )  # fmt: skip


def tool_trial(name: str, form: Form, arm: SerialArm, robot: SerialArm, why: str = "") -> Trial:
    """Where the tool of an arm is, against where the robot's is."""
    q = random_states(robot.n, _POSTURES, _SEED).q
    tools = (forward_kinematics(one, q)[:, :3, 3] for one in (arm, robot))
    apart = np.linalg.norm(np.subtract(*tools), axis=1).max()
    return Trial(name, form, float(apart), _SAME_PLACE, why)


def vectors_from_dh(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """The vectors between origins follow from the DH table, in either reading."""
    claim = Claim(
        "vectors",
        "The vectors between link origins follow from Table 1",
        "largest distance from R_iᵀ p_i of the table: half a unit of the last digit printed",
        "listing, r of links 1 to 6",
        "m",
    )
    controller = evidence.model(REPAIRED).arm
    listing = evidence.model(PRINTED).arm
    yield from judged(
        claim,
        (
            vector_trial(PRINTED, listing, controller, POSITIVE),
            vector_trial(PRINTED, listing, literal_reading(controller), LITERAL),
            Trial(
                REPAIRED,
                "repaired",
                *_apart(evidence.listing_mistakes.repaired, controller),
                "mistakes repaired",
            ),
        ),
    )


def vector_trial(name: str, listing: SerialArm, table: SerialArm, reading: str) -> Trial:
    """The listing's vectors against those of a reading of Table 1."""
    value, limit = _apart(listing, table)
    wrong = np.flatnonzero(np.abs(_vectors(listing) - _vectors(table)).max(axis=1) > limit) + 1
    links = ", ".join(map(str, wrong))
    found = f"links {links} are opposite" if len(wrong) > 1 else f"link {links} is opposite"
    return Trial(name, "printed", value, limit, f"{reading}: {found if links else 'all agree'}")


def _apart(arm: SerialArm, table: SerialArm) -> tuple[float, float]:
    """Largest distance of the vectors between origins, and half a unit of their last digit [m]."""
    vectors = _vectors(table)
    return float(np.abs(_vectors(arm) - vectors).max()), max(half_units(vectors.ravel().tolist()))


def _vectors(arm: SerialArm) -> Array:
    """r_{i−1,i} in frame i, shape (n, 3) [m]."""
    return np.array([link.link_tip_frame.R.T @ link.link_tip_frame.p for link in arm.links])


def _robot() -> SerialArm:
    """The appendix's arm in the controller's base frame."""
    return load("appendix", base="base", tip="tool0")
