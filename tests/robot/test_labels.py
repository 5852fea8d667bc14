"""Labels: names, then file names, then letters."""

from __future__ import annotations

from dataclasses import replace

import ur5check
from ur5check import SerialArm
from ur5check._robot.labels import labelled
from ur5check._robot.serial_arm import Source

ARM = ur5check.load("paper")


def arm(name: str, file: str = "") -> SerialArm:
    source = Source(inputs=((file, "0" * 64),) if file else ())
    return replace(ARM, name=name, source=source)


def labels(*arms: SerialArm) -> list[str]:
    return [one.label for one in labelled(arms)]


def test_different_names_are_the_labels() -> None:
    assert labels(arm("ur5", "x.urdf"), arm("ur10", "x.urdf")) == ["ur5", "ur10"]


def test_equal_names_give_way_to_file_names() -> None:
    assert labels(arm("ur5", "old/a.urdf"), arm("ur5", "new/b.urdf")) == ["a.urdf", "b.urdf"]


def test_equal_names_and_file_names_give_way_to_letters() -> None:
    assert labels(arm("ur5", "old/a.urdf"), arm("ur5", "new/a.urdf")) == ["A", "B"]


def test_an_arm_without_a_file_gets_a_letter() -> None:
    assert labels(arm("ur5"), arm("ur5", "new/a.urdf")) == ["A", "B"]


def test_only_what_is_equal_is_renamed_and_letters_count_from_the_first_model() -> None:
    arms = arm("ur5", "a.urdf"), arm("ur10", "a.urdf"), arm("ur5", "old/a.urdf")
    assert labels(*arms) == ["A", "ur10", "C"]


def test_a_file_name_that_is_anothers_name_is_not_taken() -> None:
    arms = arm("ur5", "a.urdf"), arm("ur5", "b.urdf"), arm("a.urdf", "c.urdf")
    assert labels(*arms) == ["A", "B", "a.urdf"]


def test_labels_stay_when_they_differ_already() -> None:
    first, _, third = labelled((arm("ur5", "a"), arm("ur5", "x/a"), arm("ur5", "y/a")))
    assert labels(first, third) == ["A", "C"]
    assert (first.name, third.name) == ("ur5", "ur5")


def test_more_models_than_letters() -> None:
    found = labels(*(arm("ur5") for _ in range(28)))
    assert len(set(found)) == 28
    assert found[25:] == ["Z", "model 27", "model 28"]
