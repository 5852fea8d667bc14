"""A robot as a tree: which links move, which are merged, which coordinate a joint follows."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from ur5check import Inertia, ModelError, RobotTree, Transform, UsageError, load_robot
from ur5check._robot.robot import Mimic, Robot, RobotJoint, RobotLink

X = np.array([1.0, 0.0, 0.0])


def robot(*joints, links=()):
    """A robot of these joints; a joint is (name, kind, parent, child) and perhaps a Mimic."""
    made = tuple(
        RobotJoint(
            name,
            kind,
            parent,
            child,
            Transform.translation((0.1, 0.0, 0.0)),
            X,
            X,
            mimic=mimic[0] if mimic else None,
        )
        for name, kind, parent, child, *mimic in joints
    )
    names = dict.fromkeys([*links, *(end for j in made for end in (j.parent, j.child))])
    bodies = tuple(RobotLink(name, None) for name in names)
    return Robot("drawn", bodies, made, "urdf", "drawn.urdf", np.array([0.0, 0.0, -9.81]))


BRANCHED = (
    ("a", "revolute", "root", "arm"),
    ("b", "fixed", "arm", "palm"),
    ("c", "prismatic", "palm", "left"),
    ("d", "continuous", "palm", "right"),
    ("e", "fixed", "root", "post"),
    ("f", "revolute", "post", "head"),
)


def test_links_stand_after_their_parents_and_fixed_ones_are_merged():
    tree = RobotTree.of(robot(*BRANCHED))
    assert tree.joint_names == ("a", "c", "d", "f")
    assert [link.parent for link in tree.links] == [-1, 0, 0, -1]
    assert tree.placements["palm"][0] == 0
    assert tree.placements["post"][0] == -1
    # The joint stands on the fixed link: the fixed joint's origin comes first.
    assert tree.links[1].origin.p.tolist() == [0.2, 0.0, 0.0]


def test_mass_fixed_to_a_moving_link_moves_and_mass_fixed_to_the_root_does_not():
    whole = load_robot("erd-ur5")
    moving = RobotTree.of(whole)
    still = [link for link, (index, _) in moving.placements.items() if index < 0]
    bodies = [whole.link[name].inertial for name in still]
    fixed = sum(inertial.mass for inertial in bodies if inertial is not None)
    assert fixed > 0.0
    assert sum(link.link.inertia.mass for link in moving.links) == pytest.approx(whole.mass - fixed)


@pytest.mark.parametrize("change", [{"parent": 2}, {"parent": -2}, {"coordinate": 4}])
def test_a_link_before_its_parent_or_without_a_coordinate_is_refused(change):
    tree = RobotTree.of(robot(*BRANCHED))
    links = (*tree.links[:2], replace(tree.links[2], **change), tree.links[3])
    with pytest.raises(ModelError) as caught:
        replace(tree, links=links)
    assert caught.value.element == "link 'right'"


def test_a_mimic_of_a_mimic_follows_the_first_joint():
    tree = RobotTree.of(
        robot(
            ("a", "revolute", "root", "one", Mimic("b", -2.0, 0.5)),
            ("b", "revolute", "one", "two", Mimic("c", 3.0, 0.1)),
            ("c", "revolute", "two", "three"),
        )
    )
    assert tree.joint_names == ("c",)
    q = tree.all_joints(np.array([[0.7]]))
    np.testing.assert_allclose(q[:, 0], [-2.0 * (3.0 * 0.7 + 0.1) + 0.5, 3.0 * 0.7 + 0.1, 0.7])
    np.testing.assert_allclose(tree.all_rates(np.array([[0.7]]))[:, 0], [-4.2, 2.1, 0.7])


@pytest.mark.parametrize(
    ("joints", "element"),
    [
        ([("a", "floating", "root", "one")], "joint 'a'"),
        ([("a", "planar", "root", "one")], "joint 'a'"),
        ([("a", "ball", "root", "one")], "joint 'a'"),
        (
            [
                ("b", "revolute", "root", "one"),
                ("a", "revolute", "one", "two", Mimic("absent")),
            ],
            "joint 'a'",
        ),
        (
            [
                ("c", "revolute", "root", "one"),
                ("a", "revolute", "one", "two", Mimic("b")),
                ("b", "revolute", "two", "three", Mimic("a")),
            ],
            "joint 'a'",
        ),
        (
            [
                ("c", "revolute", "root", "one"),
                ("b", "fixed", "one", "two"),
                ("a", "revolute", "two", "three", Mimic("b")),
            ],
            "joint 'a'",
        ),
        ([("a", "fixed", "root", "one")], None),
        ([("a", "revolute", "one", "two"), ("b", "revolute", "two", "one")], None),
        ([("a", "revolute", "root", "one"), ("b", "revolute", "other", "two")], None),
    ],
)
def test_what_is_no_tree_on_a_fixed_base_is_refused(joints, element):
    with pytest.raises(ModelError) as caught:
        RobotTree.of(robot(*joints))
    assert (caught.value.file, caught.value.element) == (
        ("drawn.urdf", None) if element is None else ("", element)
    )


def test_other_numbers_must_fit_the_tree():
    tree = RobotTree.of(robot(*BRANCHED))
    rod = Inertia(1.0, np.zeros(3), 0.01 * np.eye(3))
    heavier = tree.with_inertias([rod] * 4).with_armature([0.1, 0.2, 0.3, 0.4])
    assert [link.link.inertia.mass for link in heavier.links] == [1.0] * 4
    assert [link.joint.armature for link in heavier.links] == [0.1, 0.2, 0.3, 0.4]
    for inertias in ([rod], [rod] * 5, [1.0, 2.0, 3.0, 4.0]):
        with pytest.raises(UsageError):
            tree.with_inertias(inertias)
    for armature in ([0.1], [0.1] * 5, [0.1, 0.2, 0.3, float("nan")]):
        with pytest.raises(ModelError):
            tree.with_armature(armature)
