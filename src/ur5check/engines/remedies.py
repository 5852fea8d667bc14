"""Rewriting a URDF so that a reader which misreads it reads it rightly.

Each remedy changes one thing in the XML tree and invents no number: a massless link is *written*
massless, the shape of a massless link is kept from becoming a mass, a limit that stands in one
place is said in another as well.  `habits` says which reader needs which.
"""

from __future__ import annotations

from typing import Any

from lxml import etree

from .urdf_text import root_link

__all__ = [
    "fix_root_to_world",
    "keep_shapes_massless",
    "say_effort_in_transmissions",
    "write_massless_links",
]

_ZERO_TENSOR = dict.fromkeys(("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), "0")


def write_massless_links(root: Any) -> None:
    """Give every link without `<inertial>` one of mass zero."""
    for link in root.iterchildren("link"):
        if link.find("inertial") is None and link.get("name") != "world":
            inertial = etree.SubElement(link, "inertial")
            etree.SubElement(inertial, "mass", value="0")
            etree.SubElement(inertial, "inertia", _ZERO_TENSOR)


def keep_shapes_massless(root: Any) -> None:
    """Tell MuJoCo's compiler to take masses from `<inertial>` only."""
    settings = root.find("mujoco")
    if settings is None:
        settings = etree.SubElement(root, "mujoco")
    compiler = settings.find("compiler")
    if compiler is None:
        compiler = etree.SubElement(settings, "compiler")
    compiler.set("inertiafromgeom", "false")


def say_effort_in_transmissions(root: Any) -> None:
    """Give every moving joint with an effort limit an actuator, where it has none."""
    driven = {joint.get("name") for joint in root.findall("transmission/joint")}
    for joint in root.findall("joint"):
        limit, name = joint.find("limit"), joint.get("name")
        moves = joint.get("type") in ("revolute", "continuous", "prismatic")
        if not moves or name in driven or limit is None or limit.get("effort") is None:
            continue
        transmission = etree.SubElement(root, "transmission", name=f"{name}_transmission")
        kind = etree.SubElement(transmission, "type")
        kind.text = "transmission_interface/SimpleTransmission"
        etree.SubElement(transmission, "joint", name=name)
        etree.SubElement(transmission, "actuator", name=f"{name}_motor")


def fix_root_to_world(root: Any) -> None:
    """Hang the root link on a link `world`, which floating-base readers hold still."""
    name = root_link(root)
    if name == "world":
        return
    joints = {joint.get("name") for joint in root.iterchildren("joint")}
    joint_name = "world_fixed_joint"
    while joint_name in joints:
        joint_name += "_"
    first = next(root.iterchildren("link"))
    first.addprevious(etree.Element("link", name="world"))
    joint = etree.Element("joint", name=joint_name, type="fixed")
    etree.SubElement(joint, "parent", link="world")
    etree.SubElement(joint, "child", link=name)
    first.addprevious(joint)
