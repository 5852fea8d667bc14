"""Causes in the numbers of one link: its mass, centre or tensor, or a known mistake in them.

Torques see combinations of parameters.  So each of these is a statement about the link with all
other numbers kept: "with its centre and tensor as they are, the mass would be …".  A known mistake
has no free coefficient: undone, it gives one other model, which explains the recording or not.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._comparison.diagnosis.link_numbers import LinkPair, body_of, with_body
from .._comparison.diagnosis.mistake import LinkMistake, changed
from .._comparison.diagnosis.mistakes import LINK_MISTAKES
from .._robot.inertia import Inertia
from .._robot.pseudo_inertia import DigitBounds, judge_body
from .._robot.serial_arm import SerialArm
from .._robot.transforms import Array
from .cause import Cause
from .joint_residuals import model_torque
from .weighted_problem import WeightedProblem

__all__ = ["link_causes", "mistake_causes", "without_mistake"]

_ROUNDS = 5
_INERTIAL = ("mass", "centre", "tensor", "body")

#: Mistakes that are reported; the others are counted.
_REPORTED = 8


def link_causes(problem: WeightedProblem) -> Iterator[Cause]:
    """For each link its mass, its centre, its tensor: each with the other two kept.

    A mass or a tensor that no body can have is no explanation.
    """
    for i, link in enumerate(problem.arm.links):
        if link.inertia.mass > 0.0:
            yield from _mass(problem, i)
            yield _centre(problem, i)
        yield from _tensor(problem, i)


def _mass(problem: WeightedProblem, i: int) -> Iterator[Cause]:
    body = problem.arm.links[i].inertia
    heavier = Inertia(body.mass + 1.0, body.com, body.tensor)
    direction = _placed(problem, i, heavier.parameters() - body.parameters())
    found = problem.fitted_parameters(np.zeros_like(direction), direction[:, None])
    if body.mass + found.value[0] + found.half_width[0] <= 0.0:
        return
    yield problem.cause(
        "link-mass", i + 1, (("mass", "kg"),), found.residual, body.mass + found.value,
        found.half_width, alternatives=problem.n,
    )  # fmt: skip


def _centre(problem: WeightedProblem, i: int) -> Cause:
    """By iteration: the tensor about the frame's origin has the square of the centre."""
    body = problem.arm.links[i].inertia
    centre = body.com.copy()
    for _ in range(_ROUNDS):
        now = Inertia(body.mass, centre, body.tensor)
        step = 1e-6
        slopes = [
            (
                Inertia(body.mass, centre + step * axis, body.tensor).parameters()
                - Inertia(body.mass, centre - step * axis, body.tensor).parameters()
            )
            / (2.0 * step)  # exact of a quadratic function
            for axis in np.eye(3)
        ]
        directions = np.stack([_placed(problem, i, slope) for slope in slopes], axis=1)
        change = _placed(problem, i, now.parameters() - body.parameters())
        found = problem.fitted_parameters(change, directions)
        moved = centre + found.value
        if not np.isfinite(moved).all() or np.linalg.norm(moved - body.com) > 1e2:
            break
        centre = moved
    R = problem.arm.links[i].source_frame.R.T
    labels = tuple((f"centre {axis}", "m") for axis in "xyz")
    width = found.quantile * np.sqrt(np.diag(R @ found.covariance @ R.T))
    value = _in_source(problem.arm, i, centre)
    return problem.cause(
        "link-centre", i + 1, labels, found.residual, value, width, alternatives=problem.n
    )


def _in_source(arm: SerialArm, i: int, centre: Array) -> Array:
    """A centre in the link's own frame i, in the frame of the source."""
    T = arm.links[i].source_frame.inverse()
    return np.asarray(T.R @ centre + T.p)


def _tensor(problem: WeightedProblem, i: int) -> Iterator[Cause]:
    own = body_of(problem.arm, i).tensor
    R = problem.arm.links[i].source_frame.R
    directions = []
    for row, column in ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)):
        unit = np.zeros((3, 3))
        unit[row, column] = unit[column, row] = 1.0
        turned = R @ unit @ R.T
        entries = turned[[0, 0, 1, 0, 1, 2], [0, 1, 1, 2, 2, 2]]
        directions.append(_placed(problem, i, np.concatenate([np.zeros(4), entries])))
    X = np.stack(directions, axis=1)
    found = problem.fitted_parameters(np.zeros(len(X)), X)
    value = own[[0, 0, 1, 0, 1, 2], [0, 1, 1, 2, 2, 2]] + found.value
    tensor = value[[[0, 1, 3], [1, 2, 4], [3, 4, 5]]]
    interval = DigitBounds.of(np.full((3, 3), found.half_width.max()))
    if not judge_body(problem.arm.links[i].inertia.mass, tensor, interval).triangle:
        return
    names = ("Ixx", "Ixy", "Iyy", "Ixz", "Iyz", "Izz")
    yield problem.cause(
        "link-tensor", i + 1, tuple((name, "kg m²") for name in names), found.residual, value,
        found.half_width, alternatives=problem.n, coefficients=found.rank,
    )  # fmt: skip


def _placed(problem: WeightedProblem, i: int, parameters: Array) -> Array:
    """Ten parameters of one link among all of the arm's."""
    full = np.zeros(10 * problem.n)
    full[10 * i : 10 * i + 10] = parameters
    return full


def mistake_causes(problem: WeightedProblem) -> list[Cause]:
    """Every known mistake undone in every link, the likeliest first."""
    arm = problem.arm
    tried = list(_repairs(arm))
    inertial = [k for k, (mistake, *_) in enumerate(tried) if mistake.quantity in _INERTIAL]
    rests = np.full(len(tried), np.inf)
    if inertial:
        own = arm.parameters()
        changes = np.stack([tried[k][3].parameters() - own for k in inertial])
        rests[inertial] = problem.normal.rest(changes)
    coarse = problem.coarse()
    scale = problem.signals.count / coarse.signals.count
    for k, (mistake, _, _, repaired) in enumerate(tried):
        if mistake.quantity not in _INERTIAL:
            torque = model_torque(repaired, coarse.signals)
            rests[k] = scale * (coarse.weighted(coarse.signals.tau - torque) ** 2).sum()
    causes: list[Cause] = []
    seen: list[float] = []
    # Of those that leave the same, to rounding, the earlier in the list of mistakes first.
    for k in sorted(range(len(tried)), key=lambda k: (float(f"{rests[k]:.8e}"), k)):
        mistake, how, i, repaired = tried[k]
        residual = problem.weighted(problem.signals.tau - model_torque(repaired, problem.signals))
        rest = float(residual @ residual)
        # Two mistakes that give the same torques are one observation: the likelier is named.
        if any(abs(rest - other) <= 1e-9 * other for other in seen):
            continue
        seen.append(rest)
        causes.append(
            problem.cause(
                "mistake", i + 1, (), residual, np.zeros(0), np.zeros(0),
                alternatives=len(tried), mistake=mistake.id, how=how,
            )
        )  # fmt: skip
        if len(causes) == _REPORTED:
            break
    return causes


def _repairs(arm: SerialArm) -> Iterator[tuple[LinkMistake, str, int, SerialArm]]:
    """Every mistake, how it was made, in which link (from 0), and the arm without it."""
    bodies = tuple(body_of(arm, i) for i in range(arm.n))
    # There is no second model: what a link should be, the recording says.
    pair = LinkPair("b", bodies, bodies)
    for mistake in LINK_MISTAKES:
        for i in range(arm.n):
            for how, value in mistake.repairs(pair, i):
                yield (
                    mistake,
                    how,
                    i,
                    with_body(arm, i, changed(bodies[i], mistake.quantity, value)),
                )


def without_mistake(arm: SerialArm, cause: Cause) -> SerialArm:
    """The arm with the mistake of a cause undone."""
    return next(
        repaired
        for mistake, how, i, repaired in _repairs(arm)
        if (mistake.id, how, i + 1) == (cause.mistake, cause.how, cause.joint)
    )
