"""The paper's claim on its simulation: torques were published, and the arm stood (test 9).

The plant is the appendix's arm, as in the paper, moved by our own integrator; for MuJoCo and DART,
see `ur5check simulate --engine` (docs/simulation.md).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._dynamics.kinematics import link_frames
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .._simulation.static_hold import STILL, stand
from .cases import case
from .claim import Claim, ClaimOutcome, Trial, judged
from .evidence import Evidence
from .paper_models import PRINTED, REPAIRED, Form

__all__ = ["clear_trial", "posture_is_clear", "static_hold_trial", "the_arm_stands"]

_SECONDS = 5.0
_SPAWNED = 0.1  # m above the ground, where the paper's launch file puts the base


def the_arm_stands(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Test 9: under the torques that were published, the arm stands."""
    claim = Claim(
        "case-9-stands",
        "Case 9: under the torques sent to its joints, the appendix's arm stands",
        "displacement of the tool in 5 s, or until a joint meets its limit: at most 0.1 mm, the "
        "repeatability of a UR5's data sheet",
        "test case 9, simulation",
        "mm",
    )
    plant = evidence.model("appendix").arm
    models: tuple[tuple[str, Form], ...] = (
        (PRINTED, "printed"),
        (REPAIRED, "repaired"),
        ("appendix", "other"),
    )
    trials = []
    for name, form in models:
        evidence.say(f"simulating test 9 with the torques of {name}")
        trials.append(static_hold_trial(name, form, plant, evidence.model(name).arm))
    yield from judged(claim, trials)


def static_hold_trial(name: str, form: Form, plant: SerialArm, model: SerialArm) -> Trial:
    """The plant under the torques that hold a model."""
    s = stand(plant, model, case(9).joint_angles()[0], seconds=_SECONDS)
    joint = int(np.abs(s.given - s.needed).argmax())
    why = f"stands for {_SECONDS:g} s"
    if (left := s.tool_left_after) is not None:
        why = (
            f"joint {joint + 1} is given {s.given[joint]:+.2f} N m and needs "
            f"{s.needed[joint]:+.2f} N m; the tool has moved 0.1 mm after {1e3 * left:.1f} ms"
        )
    return Trial(name, form, 1e3 * float(s.tool_drift.max()), 1e3 * STILL, why)


def posture_is_clear(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Test 9 tests torques only if nothing else supports the arm."""
    claim = Claim(
        "case-9-clear",
        "Case 9: the arm is free of the ground in the paper's world",
        "height of the lowest joint of the appendix's arm, its base 0.1 m above the ground: above "
        "0, or the ground supports the arm",
        "test case 9, launch file",
        "m",
    )
    arm = evidence.model("appendix").arm
    yield from judged(claim, [clear_trial("appendix", "printed", arm, case(9).joint_angles()[0])])


def clear_trial(name: str, form: Form, arm: SerialArm, q: Array) -> Trial:
    """The lowest joint (the tip frame of a link) of a posture."""
    heights = _SPAWNED + link_frames(arm, q)[:, 2, 3]
    lowest = int(heights.argmin())
    why = f"the end of {arm.links[lowest].name} lies {'below' if heights[lowest] < 0 else 'above'}"
    return Trial(name, form, float(heights[lowest]), 0.0, f"{why} the ground", "above")
