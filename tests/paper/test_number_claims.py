"""Claims on inertia tensors: a wrong number is refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ur5check._paper import number_claims
from ur5check._paper.evidence import Evidence
from ur5check._robot.inertia import Inertia
from ur5check._robot.serial_arm import SerialArm


def test_a_tensor_of_another_formula_is_refused(evidence: Evidence) -> None:
    honest = tuple(replace(f, across=round(f.honest, 9)) for f in evidence.formulas)
    assert number_claims.across_trial(honest).holds
    spoiled = (*honest[:3], replace(honest[3], across=honest[3].across + 2e-9), *honest[4:])
    assert not number_claims.across_trial(spoiled).holds
    assert number_claims.along_trial(evidence.formulas).holds
    off = tuple(replace(f, along_error=2 * f.half_unit) for f in evidence.formulas)
    assert not number_claims.along_trial(off).holds


def test_a_cylinder_across_its_link_is_refused(evidence: Evidence) -> None:
    appendix = evidence.model("appendix").arm
    assert number_claims.direction_trial(appendix, "appendix", "other").holds
    turned = with_turned_tensor(appendix, 3)
    assert not number_claims.direction_trial(turned, "appendix", "other").holds


def with_turned_tensor(arm: SerialArm, link: int) -> SerialArm:
    """The tensor as it would stand if frame x were frame z."""
    bodies = [body.inertia for body in arm.links]
    R = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
    old = bodies[link - 1]
    bodies[link - 1] = Inertia(old.mass, old.com, R @ old.tensor @ R.T)
    return arm.with_inertias(bodies)
