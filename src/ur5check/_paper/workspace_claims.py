"""Figure 3's workspace: a sphere of 1.7 m that the tool reaches, a cylinder of 0.3 m it does not.

Distances from the shoulder (the point where axes 1 and 2 meet) depend on joints 3 to 5 only, and
those from axis 1 on joints 2 to 5.  The extreme is found on a grid that is halved around its best
point until it no longer moves.  Joints turn freely, as their limits allow; collisions are not
considered, but the postures near axis 1 hold the tool well above the shoulder.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from .._dynamics.kinematics import forward_kinematics, link_frames
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .claim import Claim, ClaimOutcome, Trial, judged
from .evidence import Evidence
from .paper_models import REPAIRED, Form

__all__ = [
    "cylinder_is_unreachable",
    "cylinder_trial",
    "inner_diameter",
    "outer_diameter",
    "sphere_is_the_reach",
    "sphere_trial",
]

SPHERE, CYLINDER = 1.7, 0.3  # [m], as printed
_HALF_UNIT = 0.05  # [m], of both

#: Height of the tool above the shoulder below which a posture near axis 1 could meet the arm [m].
_CLEAR = 0.3

_STEPS, _HALVINGS = 10, 32


def sphere_is_the_reach(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """The reach is a sphere of 1.7 m."""
    claim = Claim(
        "workspace-sphere",
        "The tool reaches as far as a sphere of 1.7 m diameter",
        "distance of twice the largest distance of the tool from the shoulder from 1.7 m: at most "
        "half a unit of the digit printed",
        "figure 3",
        "m",
    )
    yield from judged(claim, (sphere_trial(*which) for which in _arms(evidence)))


def sphere_trial(name: str, form: Form, arm: SerialArm, diameter: float = SPHERE) -> Trial:
    """The reach of an arm's tool against a sphere."""
    found = outer_diameter(arm)
    return Trial(
        name, form, abs(found - diameter), _HALF_UNIT, f"the reach is a sphere of {found:.3f} m"
    )


def cylinder_is_unreachable(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Around the base's axis, the tool cannot come nearer than 0.15 m."""
    claim = Claim(
        "workspace-cylinder",
        "The tool cannot enter a cylinder of 0.3 m diameter about axis 1",
        "twice the smallest distance of the tool from axis 1, at least 0.3 m above the shoulder: "
        "at least 0.3 m, less half a unit of the digit printed",
        "figure 3",
        "m",
    )
    yield from judged(claim, (cylinder_trial(*which) for which in _arms(evidence)))


def cylinder_trial(name: str, form: Form, arm: SerialArm, diameter: float = CYLINDER) -> Trial:
    """How near an arm's tool comes to axis 1 against a cylinder."""
    found = inner_diameter(arm)
    why = f"the tool comes within {found / 2.0:.3f} m of axis 1"
    return Trial(name, form, found, diameter - _HALF_UNIT, why, "at least")


def outer_diameter(arm: SerialArm) -> float:
    """Twice the largest distance of the tool from the shoulder [m]."""
    shoulder = _shoulder(arm)

    def distance(q: Array) -> Array:
        tool = forward_kinematics(arm, q)[:, :3, 3]
        return np.asarray(np.linalg.norm(tool - shoulder, axis=1))

    return 2.0 * _largest(distance, arm.n, (3, 4, 5))


def inner_diameter(arm: SerialArm) -> float:
    """Twice the smallest distance of the tool from axis 1, well above the shoulder [m]."""
    shoulder = _shoulder(arm)

    def closeness(q: Array) -> Array:
        x, y, z = (forward_kinematics(arm, q)[:, :3, 3] - shoulder).T
        return np.where(z >= _CLEAR, -np.hypot(x, y), -np.inf)

    return -2.0 * _largest(closeness, arm.n, (2, 3, 4, 5))


def _largest(score: Callable[[Array], Array], n: int, joints: Sequence[int]) -> float:
    """The largest score over these joints (from 1), each over one turn."""
    centre, width, best = np.zeros(len(joints)), np.pi, -np.inf
    columns = [joint - 1 for joint in joints]
    for _ in range(_HALVINGS):
        axes = [np.linspace(c - width, c + width, _STEPS + 1) for c in centre]
        q = np.zeros(((_STEPS + 1) ** len(joints), n))
        q[:, columns] = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, len(joints))
        scores = score(q)
        k = int(scores.argmax())
        centre, width, best = q[k, columns], width / 2.0, max(best, float(scores[k]))
    return best


def _shoulder(arm: SerialArm) -> Array:
    """Where axes 1 and 2 meet: the first link's tip, in the base frame [m]."""
    return np.asarray(link_frames(arm, np.zeros(arm.n))[0, :3, 3])


def _arms(evidence: Evidence) -> Iterator[tuple[str, Form, SerialArm]]:
    """The controller's DH is the robot that the figure shows."""
    yield "controller's DH", "printed", evidence.model(REPAIRED).arm
