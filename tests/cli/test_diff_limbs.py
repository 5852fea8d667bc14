"""`diff` of robots with several chains: limbs are matched by name and compared one by one."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from report_schema import read_report
from ur5check._rules.examples import joint, link, robot

if TYPE_CHECKING:
    from .conftest import Command

FEW = ("--samples", 20)


def limb(side: str, hand_mass: str = "1", end: str = "hand") -> list[str]:
    """Two joints and two links."""
    return [
        joint(f"{side}_shoulder", parent="base", child=f"{side}_arm"),
        link(f"{side}_arm"),
        joint(f"{side}_elbow", parent=f"{side}_arm", child=f"{side}_{end}"),
        link(f"{side}_{end}", mass=hand_mass),
    ]


@pytest.fixture
def two_arms(tmp_path: Path) -> Path:
    path = tmp_path / "two_arms.urdf"
    path.write_text(robot(*limb("left"), *limb("right")))
    return path


def beside(two_arms: Path, *limbs: list[str]) -> Path:
    path = two_arms.with_name("other.urdf")
    path.write_text(robot(*(part for parts in limbs for part in parts)))
    return path


def limbs_of(ur5check: Command, a: Path, b: Path) -> dict[tuple[str | None, str | None], bool]:
    report = read_report(ur5check("diff", a, b, *FEW, "--format", "json").out)
    assert report["schema"] == "ur5check.diff-limbs/2"
    return {(x["a"], x["b"]): x["agrees"] for x in report["limbs"]}


def test_equal_robots_agree(ur5check: Command, two_arms: Path) -> None:
    said = ur5check("diff", two_arms, two_arms, *FEW)
    assert said.code == 0
    assert said.out.startswith("AGREE  ")


def test_one_limb_differs_whatever_the_order_of_the_file(ur5check: Command, two_arms: Path) -> None:
    other = beside(two_arms, limb("right"), limb("left", "1.2"))
    said = ur5check("diff", two_arms, other, *FEW)
    assert said.code == 1
    lines = said.out.splitlines()
    assert len(lines) <= 24
    assert max(map(len, lines)) <= 80
    assert limbs_of(ur5check, two_arms, other) == {
        ("left_hand", "left_hand"): False,
        ("right_hand", "right_hand"): True,
    }


def test_limbs_of_other_last_links_are_matched_by_what_they_are_called(
    ur5check: Command, two_arms: Path
) -> None:
    other = beside(two_arms, limb("left", end="hand_link"), limb("right", end="hand_link"))
    assert limbs_of(ur5check, two_arms, other) == {
        ("left_hand", "left_hand_link"): True,
        ("right_hand", "right_hand_link"): True,
    }


def test_a_limb_in_one_file_only_is_a_difference(ur5check: Command, two_arms: Path) -> None:
    third = beside(two_arms, limb("left"), limb("right"), limb("tail"))
    for pair, extra in (
        ((two_arms, third), (None, "tail_hand")),
        ((third, two_arms), ("tail_hand", None)),
    ):
        said = ur5check("diff", *pair, *FEW)
        assert said.code == 1
        assert f"only in the {'first' if pair[0] == third else 'second'} file" in said.out
        assert limbs_of(ur5check, *pair)[extra] is False


def test_a_limb_that_cannot_exist_is_compared(ur5check: Command, two_arms: Path) -> None:
    other = beside(two_arms, limb("left", "-1"), limb("right"))
    found = limbs_of(ur5check, two_arms, other)
    assert found["left_hand", "left_hand"] is False
    assert found["right_hand", "right_hand"] is True


def test_the_whole_report_has_the_limb_that_differs(ur5check: Command, two_arms: Path) -> None:
    other = beside(two_arms, limb("left", "1.2"), limb("right"))
    for options in (("--full",), ("--format", "markdown")):
        out = ur5check("diff", two_arms, other, *FEW, *options).out.replace("\\_", "_")
        assert "left_hand" in out
        assert "left_elbow" in out


def test_options_for_one_arm(ur5check: Command, two_arms: Path) -> None:
    repaired = two_arms.with_name("repaired.urdf")
    assert ur5check("diff", two_arms, two_arms, *FEW, "--repair", repaired).code == 2
    chosen = ("--tip-a", "left_hand", "--tip-b", "right_hand")
    assert "limbs" not in ur5check("diff", two_arms, two_arms, *FEW, *chosen).out
    single = two_arms.with_name("single.urdf")
    single.write_text(robot(*limb("left")))
    assert ur5check("diff", two_arms, single, *FEW).code == 2
