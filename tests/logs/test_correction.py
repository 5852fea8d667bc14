"""Base parameters with intervals, and the nearest feasible model that explains a recording."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from logs.recorded import Motion, changed, heavier, write
from ur5check import Inertia, SerialArm, compare_recording
from ur5check._logs.correction import corrected
from ur5check._robot.inertia import pseudo_inertia


def test_base_parameters_differ_where_the_model_does(
    arm: SerialArm, motion: Motion, file: Path
) -> None:
    write(motion, file)
    right = compare_recording(arm, file)
    wrong = compare_recording(heavier(arm, 1, 1.4), file)
    assert not any(parameter.differs for parameter in right.parameters)
    differing = {parameter.name for parameter in wrong.parameters if parameter.differs}
    assert differing
    assert all(name[-1] in "12" for name in differing)  # none of the hand's own
    # The sum of the model's value and the change does not depend on the model.
    for a, b in zip(right.parameters, wrong.parameters, strict=True):
        assert abs(a.given + a.change - b.given - b.change) < a.half_width + b.half_width
        assert a.combination.startswith(a.name)


def test_the_corrected_model_explains_the_recording_and_can_exist(
    arm: SerialArm, motion: Motion, file: Path
) -> None:
    wrong = heavier(arm, 1, 1.4)
    found = corrected(wrong, compare_recording(wrong, write(motion, file)).normal)
    assert found.explained > 0.99
    assert found.fixed == ()
    assert compare_recording(found.arm, file).at_floor
    for change, link in zip(found.changes, found.arm.links, strict=True):
        inertia = link.inertia
        assert inertia.mass > 0.0
        assert inertia.triangle_margin() > 0.0
        assert change.link == link.name
        assert abs(change.after[0] - inertia.mass) < 1e-12
    # Only combinations are determined; none runs away from the given model.
    before = np.array([change.before[0] for change in found.changes])
    after = np.array([change.after[0] for change in found.changes])
    assert (np.abs(after / before - 1.0) < 0.5).all()


def test_the_given_model_is_kept_where_it_is_right(
    arm: SerialArm, motion: Motion, file: Path
) -> None:
    found = corrected(arm, compare_recording(arm, write(motion, file)).normal)
    for change in found.changes:
        assert (np.abs(change.after - change.before) <= change.half_width).all()


def test_a_flat_body_stays_as_it_is(arm: SerialArm, motion: Motion, file: Path) -> None:
    body = arm.links[1].inertia
    flat = changed(heavier(arm, 2, 1.3), 1, replace(body, tensor=0.0 * np.eye(3)))
    found = corrected(flat, compare_recording(flat, write(motion, file)).normal)
    assert found.fixed == (arm.links[1].name,)
    assert found.arm.links[1].inertia.parameters().tolist() == (
        flat.links[1].inertia.parameters().tolist()
    )


def test_pseudo_inertia_and_parameters_are_one_another() -> None:
    body = Inertia(2.0, [0.1, -0.2, 0.3], np.diag([0.02, 0.03, 0.04]))
    J = pseudo_inertia(body.parameters())
    assert J[3, 3] == 2.0
    assert np.linalg.eigvalsh(J).min() > 0.0
