"""Mistakes in a link's mass, centre and tensor at once."""

from __future__ import annotations

from collections.abc import Iterator

from ..._robot.inertia import Inertia
from .link_numbers import LinkPair
from .mistake import LinkMistake, Repair

__all__ = ["BODY_MISTAKES"]


def _child_dropped(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    for name, part in link_pair.truth[i].welded:
        yield name, link_pair.bodies[i].whole + part


def _child_twice(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    body = link_pair.bodies[i]
    for name, part in (*body.welded, *link_pair.truth[i].welded):
        rest = body.whole.parameters() - part.parameters()
        if rest[0] > 0.0:
            yield name, Inertia.from_parameters(rest)


#: The likelier first.
BODY_MISTAKES: tuple[LinkMistake, ...] = (
    LinkMistake(
        id="body-dropped",
        rule_id="CMP101",
        quantity="body",
        says="the inertial of a body fixed to the link is left out",
        repair="add it to the link, or keep it on its own link",
        bad="a flange fixed to link 6 is merged into it without its inertial",
        good="link 6 has the flange's mass, centre and tensor too",
        repairs=_child_dropped,
        sources=(
            "stack-of-tasks/pinocchio#2677",
            "ipab-slmc/exotica#676",
        ),
        alone=True,
    ),
    LinkMistake(
        id="body-twice",
        rule_id="CMP102",
        quantity="body",
        says="the inertial of a body fixed to the link is counted twice",
        repair="count it in the link or in its own, not in both",
        bad="link 6 contains the gripper, and the gripper's own link has its inertial again",
        good="the gripper's inertial stands in one place",
        repairs=_child_twice,
        alone=True,
    ),
)
