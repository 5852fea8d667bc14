"""Regrouping of the inertial parameters: the same torques with fewer operations.

A factor of zero costs no operation, so unidentifiable parameters are set to zero, or equal to each
other where that saves a product of ω × I ω.  For the UR5, 24 of 60 numbers vanish.  The order of
the target values changes the number of operations by about a tenth; `regroupings` starts from a
good order and searches over others, with a fixed seed.

Regrouped parameters belong to no body: a mass may be negative, or zero with a first moment.  The
recursion accepts them (`LinkConstants.h`), about the origin at the tip of each link.  Origins are
first moved along their joint axes where that shortens the chain: a URDF may contain an offset twice
that a DH table cancels.

References: Khalil & Kleinfinger, "Minimum operations and minimum parameters of the dynamic models
of tree structure robots", IEEE J. Robotics and Automation 3(6), 1987, pp. 517–526.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..._robot.serial_arm import SerialArm
from ..._robot.transforms import Array, Transform
from ..chain_constants import Chain, chain_of
from ..vectors import ZERO, Matrix, Vector
from .target_values import TargetValue, Unseen

__all__ = ["moments_chain", "regroupings", "slid"]

_PARALLEL = 1e-9  # sine of an angle between axes; rounded angles are finer

#: Largest ratio of the cancellation bounds of regrouped and original parameters: two digits lost.
_CANCELLATION = 100.0

#: Largest change of the torques by rounding, as a share of the cancellation bound: ε summed over
#: some hundred terms that are larger by `_CANCELLATION`.
_CHANGED = 1e-12

#: Target values of a link in a good order: moments, first moments, mass, products.
_TARGET_VALUES = (
    ("Ixx",), ("Iyy",), ("Izz",), ("mx",), ("my",), ("mz",), ("m",), ("Ixy",), ("Ixz",), ("Iyz",),
    ("Ixx", "Iyy"), ("Iyy", "Izz"), ("Ixx", "Izz"),
)  # fmt: skip


def regroupings(
    arm: SerialArm,
    cost: Callable[[Chain], int],
    *,
    tries: int,
    less: SerialArm | None = None,
    seed: int = 0,
) -> list[Chain]:
    """Chains with the same torques as the arm, to rounding; the arm's own first, the cheapest last.

    cost : a measure of the operations of a chain
    tries : number of orders of target values to try, beyond the first
    less : an arm of the same geometry; the chains then have the difference of the two's torques
    """
    if less is None:
        found = [chain_of(arm)]
    else:
        arm = arm.with_armature(arm.armature - less.armature)
        found = [moments_chain(arm, Unseen(arm, less).pi)]
    fewest = cost(found[0])
    arm = slid(arm)
    unseen = Unseen(arm, None if less is None else slid(less))
    directions = unseen.null_space.shape[1]
    rng = random.Random(seed)  # noqa: S311 - a search, not cryptography
    best = [
        TargetValue(link, *names) for link in reversed(range(arm.n)) for names in _TARGET_VALUES
    ]
    cancelling = _CANCELLATION * unseen.cancellation_bound(unseen.pi)
    for attempt in range(1 + tries if directions else 0):
        target_values = list(best)
        if attempt > 0:
            target_values.insert(
                rng.randrange(directions), target_values.pop(rng.randrange(len(target_values)))
            )
        pi = unseen.parameters(target_values)
        if unseen.cancellation_bound(pi) > cancelling or unseen.change(pi) > _CHANGED:
            continue
        chain = moments_chain(arm, pi)
        operations = cost(chain)
        if operations < fewest:
            found.append(chain)
        if operations <= fewest:  # equal ones too: plateaus are wide
            fewest, best = operations, target_values
    return found


def moments_chain(arm: SerialArm, pi: Array) -> Chain:
    """The arm's chain with other parameters π, shape (10 n,), each link's about its origin i."""
    chain = chain_of(arm)
    links = []
    for link, p in zip(chain.links, pi.reshape(-1, 10), strict=True):
        m, mx, my, mz, xx, xy, yy, xz, yz, zz = (float(entry) for entry in p)
        tensor = Matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        links.append(replace(link, c=ZERO, m=m, h=Vector(mx, my, mz), I=tensor))
    return replace(chain, links=tuple(links))


def slid(arm: SerialArm) -> SerialArm:
    """The same arm with each origin i moved along joint axis i + 1, close to joint axis i.

    An origin may lie anywhere on the next joint's axis.  The foot of the common normal makes the
    vector from origin to origin shortest, as in a DH table.  Of almost parallel axes it may be far
    away, and parameters about it would cancel: no origin is moved by more than the arm's reach.
    """
    links = list(arm.links)
    reach = sum(float(np.linalg.norm(link.link_tip_frame.p)) for link in links)
    for i, (joint, following) in enumerate(zip(arm.joints, arm.joints[1:], strict=False)):
        if "prismatic" in (joint.kind, following.kind):
            continue  # a prismatic axis has a direction but no position
        P = links[i].link_tip_frame
        u, v = joint.axis, P.R @ following.axis
        along = -float(P.p @ v)
        if np.linalg.norm(np.cross(u, v)) > _PARALLEL:
            foot = float(np.linalg.lstsq(np.column_stack([u, -v]), P.p)[0][1])
            along = foot if abs(foot) <= reach else along
        slide = Transform.translation(following.axis * along)
        back = slide.inverse()
        moved = links[i].inertia.expressed_in(back)
        links[i] = replace(links[i], link_tip_frame=P @ slide, inertia=moved)
        links[i + 1] = replace(links[i + 1], link_tip_frame=back @ links[i + 1].link_tip_frame)
    return replace(arm, links=tuple(links))
