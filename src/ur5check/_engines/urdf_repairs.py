"""Repairs of a URDF that several readers need; those of one reader stand in its adapter file."""

from __future__ import annotations

from typing import Any

from lxml import etree

from .._errors import ModelError
from .engine_urdf import root_link

__all__ = ["fix_root_to_world"]


def fix_root_to_world(root: Any) -> None:
    """Fix the root link to a link `world`, which floating-base readers take for the ground.

    Raises ModelError if the name is taken by a link or joint that is not the root.
    """
    name = root_link(root)
    if name == "world":
        return
    for node in root.iterchildren("link", "joint"):
        if node.get("name") in ("world", "world_joint"):
            raise ModelError(
                "the name is taken: readers keep it for what the base is fixed to",
                fix="rename it",
                line=node.sourceline,
                element=f"{node.tag} {node.get('name')!r}",
            )
    joint = etree.Element("joint", name="world_joint", type="fixed")
    etree.SubElement(joint, "parent", link="world")
    etree.SubElement(joint, "child", link=name)
    root.insert(0, joint)
    root.insert(0, etree.Element("link", name="world"))
