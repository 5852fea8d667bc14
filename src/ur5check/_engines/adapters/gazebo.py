"""Gazebo's reader of URDF (SDFormat): its known issues and repairs.  It has no adapter.

Measured with libsdformat 12, see docs/gazebo.md.
"""

from __future__ import annotations

from typing import Any

from ..._io.xml.safe_xml import parsed_xml
from ..engine_entry import EngineEntry
from ..engine_urdf import root_link
from ..known_issue import KnownIssue
from ..urdf_repairs import fix_root_to_world

__all__ = ["ENTRY", "NO_LIMIT"]

#: SDFormat's own default for a bound that is not given.
NO_LIMIT = "1e16"

_SOLID_SPHERE = """<inertial><mass value="1"/>
  <inertia ixx="0.004" ixy="0" ixz="0" iyy="0.004" iyz="0" izz="0.004"/></inertial>"""


def _give_base_mass(root: Any) -> None:
    """Give a massless base that is fixed to the world the mass of a sphere of 1 kg and 0.1 m."""
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
        for link in welded:  # grows during the loop
            welded += below.get(link, [])
        if not any(_mass(links[link]) > 0.0 for link in welded):
            for inertial in links[head].findall("inertial"):
                links[head].remove(inertial)
            links[head].append(parsed_xml(_SOLID_SPHERE))


def _mass(link: Any) -> float:
    mass = link.find("inertial/mass")
    return 0.0 if mass is None else float(mass.get("value"))


def _write_no_limit(root: Any) -> None:
    """Write a bound that means "none" as SDFormat does; it cannot read the largest double."""
    for limit in root.iterfind("joint/limit"):
        for key, text in limit.attrib.items():
            if abs(float(text)) > float(NO_LIMIT):
                limit.set(key, f"-{NO_LIMIT}" if float(text) < 0.0 else NO_LIMIT)


_KNOWN_ISSUES = (
    KnownIssue(
        id="gazebo-floating-root",
        engine="gazebo",
        measured="libsdformat 12",
        kinds=(),
        harmful=True,
        title="the root falls unless it is fixed to `world`",
        explanation="A model spawned from a URDF is free unless its root is a link named `world`.",
        fix="fix the root to a link `world`; `ur5check expand --for gazebo`",
        rewrite=fix_root_to_world,
    ),
    KnownIssue(
        id="gazebo-massless-base",
        engine="gazebo",
        measured="libsdformat 12",
        kinds=("body-lost",),
        harmful=True,
        title="a base without mass is dropped, and the arm with it",
        explanation="SDFormat leaves out a massless link, unless it is fixed to one with mass, "
        "and all links below it.",
        fix="give the base a mass; fixed to the world, it loads no joint. "
        "`ur5check expand --for gazebo` gives it 1 kg",
        rewrite=_give_base_mass,
    ),
    KnownIssue(
        id="gazebo-no-limit",
        engine="gazebo",
        measured="libsdformat 12",
        kinds=("position-limit", "velocity-limit", "effort-limit"),
        harmful=False,
        title="the largest double is out of range",
        explanation="Written with 16 digits it is more than the largest double, and SDFormat "
        "refuses it.",
        fix="write 1e16, SDFormat's own value for no limit; `ur5check expand --for gazebo`",
        rewrite=_write_no_limit,
    ),
)

ENTRY = EngineEntry(key="gazebo", title="Gazebo", order=60, known_issues=_KNOWN_ISSUES)
