"""Rewriting a URDF so that a reader which misreads it reads it rightly.

Each fix changes one thing in the XML tree and no torque: a massless link is *written* massless,
the shape of a massless link is kept from becoming a mass, a limit that stands in one place is said
in another as well.  `known_issues` says which reader needs which.
"""

from __future__ import annotations

from typing import Any

from lxml import etree

from .._errors import ModelError
from .engine_urdf import root_link

__all__ = [
    "NO_LIMIT",
    "fix_root_to_world",
    "give_base_mass",
    "keep_shapes_massless",
    "say_effort_in_transmissions",
    "write_massless_links",
    "write_no_limit",
]

#: SDFormat's own default for a bound that is not given.
NO_LIMIT = "1e16"

_ZERO_TENSOR = dict.fromkeys(("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), "0")

_BALL = """<inertial><mass value="1"/>
  <inertia ixx="0.004" ixy="0" ixz="0" iyy="0.004" iyz="0" izz="0.004"/></inertial>"""


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
    """Hang the root link on a link `world`, which floating-base readers hold still.

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


def give_base_mass(root: Any) -> None:
    """Give what is fixed to the world and weighs nothing a ball of 1 kg and 0.1 m."""
    below: dict[str, list[str]] = {}
    for joint in root.iterchildren("joint"):
        if joint.get("type") == "fixed":
            below.setdefault(joint.find("parent").get("link"), []).append(
                joint.find("child").get("link")
            )
    links = {link.get("name"): link for link in root.iterchildren("link")}
    top = root_link(root)
    for head in below.get(top, []) if top == "world" else [top]:
        welded = [head]
        for link in welded:  # grows while we walk it
            welded += below.get(link, [])
        if not any(_mass(links[link]) > 0.0 for link in welded):
            for inertial in links[head].findall("inertial"):
                links[head].remove(inertial)
            links[head].append(etree.fromstring(_BALL))


def write_no_limit(root: Any) -> None:
    """Write a bound that means "none" as SDFormat does; it cannot read the largest double."""
    for limit in root.iterfind("joint/limit"):
        for key, text in limit.attrib.items():
            if abs(float(text)) > float(NO_LIMIT):
                limit.set(key, f"-{NO_LIMIT}" if float(text) < 0.0 else NO_LIMIT)


def _mass(link: Any) -> float:
    mass = link.find("inertial/mass")
    return 0.0 if mass is None else float(mass.get("value"))
