"""Strict checks of a URDF, before any value is read.

Readers of URDF are lenient in different ways: Pinocchio drops an `<inertial>` that it cannot read,
yourdfpy turns a missing `ixx` into 1.0, both accept a negative mass.  A file that passes here is
read alike by all of them.

Whether the file describes an arm is not checked here: which joints form a chain, and whether each
moving link has a mass, depends on base and tip (`urdf_chain`, `chain_assembly`).
"""

from __future__ import annotations

from lxml import etree

from ..inertia_checks import Place, check_inertia, printed_tensor
from ..suggestions import did_you_mean
from ..xml.safe_xml import parsed_xml
from ..xml.xml_numbers import Element, ElementReader
from .urdf_tree import check_tree

__all__ = ["ENTRIES", "JOINT_TYPES", "check_urdf"]

JOINT_TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
ENTRIES = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")

_WITH_AXIS = ("revolute", "continuous", "prismatic", "planar")
_OTHER_FORMATS = {
    "sdf": "this is an SDFormat file: name it .sdf",
    "mujoco": "this is a MuJoCo model: name it .xml",
    "COLLADA": "this is a mesh: give the robot's description",
}


def check_urdf(data: bytes, file: str) -> Element:
    """The root element of a URDF in which nothing is wrong, as lxml reads it.

    data : well-formed XML (see `checked_xml`)
    file : what errors call it

    Raises ModelError for the first fault, in this order: the root; what is not expanded; names,
    types, parents and children; the tree; then the numbers, in document order.
    """
    reader = ElementReader(file)
    root = parsed_xml(data)
    _check_root(root, reader)
    _check_expanded(root, reader)
    reader.name(root)
    links = _named(root, "link", reader)
    if not links:
        reader.fail(root, "<robot>", "has no link", "a robot needs links, and joints between them")
    joints = _named(root, "joint", reader)
    for name, joint in joints.items():
        _check_type(name, joint, reader)
    check_tree(links, joints, reader)
    for element in root.iterchildren("link", "joint"):
        name = element.get("name")
        if element.tag == "link":
            _check_link(name, element, reader)
        else:
            _check_joint(name, element, joints, reader)
    return root


def _check_root(root: Element, reader: ElementReader) -> None:
    tag = etree.QName(root)
    if tag.localname == "robot" and tag.namespace is None:
        return
    fix = "a URDF's root is <robot>"
    if tag.localname in _OTHER_FORMATS:
        fix = _OTHER_FORMATS[tag.localname]
    elif tag.localname == "robot":
        fix = "remove the default namespace, xmlns=…: URDF has none"
    reader.fail(root, f"<{tag.localname}>", "the root element is not a URDF's", fix, root.tag)


def _check_expanded(root: Element, reader: ElementReader) -> None:
    """No xacro is unexpanded.  (A mere xmlns:xacro is fine: xacro leaves it in what it writes.)"""
    fix = "this is a xacro file: name it .xacro, or expand it first (ur5check expand)"
    for element in root.iter(etree.Element):
        tag = etree.QName(element)
        if "xacro" in (tag.namespace or ""):
            problem = "is a xacro instruction, not yet expanded"
            reader.fail(element, f"<{element.prefix}:{tag.localname}>", problem, fix)
    for element in root.iterchildren("link", "joint"):
        for part in element.iter(etree.Element):
            for key, text in part.attrib.items():
                if "${" in text or "$(" in text:
                    where = f"<{part.tag}> {key}"
                    reader.fail(part, where, "is an unexpanded xacro expression", fix, text)


def _named(root: Element, tag: str, reader: ElementReader) -> dict[str, Element]:
    """The root's children of this tag by name, each name once."""
    named: dict[str, Element] = {}
    for element in root.iterchildren(tag):
        name = reader.name(element)
        if name in named:
            problem = f"appears twice, first in line {named[name].sourceline}"
            reader.fail(element, f"{tag} {name!r}", problem, "give each its own name")
        named[name] = element
    return named


def _check_type(name: str, joint: Element, reader: ElementReader) -> None:
    kind = joint.get("type")
    if kind is None:
        reader.fail(
            joint, f"joint {name!r}", "has no type", f"use one of: {', '.join(JOINT_TYPES)}"
        )
    if kind not in JOINT_TYPES:
        fix = did_you_mean(kind, JOINT_TYPES)
        reader.fail(joint, f"joint {name!r} type", "is no joint type of URDF", fix, kind)


def _check_link(name: str, link: Element, reader: ElementReader) -> None:
    subject = f"link {name!r}"
    inertial = reader.child(link, "inertial", subject)
    if inertial is None:
        return
    subject += " inertial"
    reader.origin(inertial, subject)
    parts: dict[str, Element] = {
        tag: reader.child(inertial, tag, subject) for tag in ("mass", "inertia")
    }
    for tag, part in parts.items():
        if part is None:
            fix = f"write <{tag}>, or leave the whole <inertial> out for a massless frame"
            reader.fail(inertial, subject, f"has no <{tag}>", fix)
    mass = reader.number(parts["mass"], "value", f"{subject}/mass")
    entries = {e: reader.number(parts["inertia"], e, f"{subject}/inertia") for e in ENTRIES}
    place = Place(reader.file, f"{subject}/", parts["mass"].sourceline, parts["inertia"].sourceline)
    tensor, rounding = printed_tensor(dict(entries))
    # A point mass is the limit of small bodies: welded to a link it is as good as any other, and
    # force sensors are often written so.  One that moves alone is refused once links are merged.
    check_inertia(mass, tensor, place, rounding=rounding, point_mass=True)


def _check_joint(
    name: str, joint: Element, joints: dict[str, Element], reader: ElementReader
) -> None:
    subject = f"joint {name!r}"
    kind = joint.get("type")
    reader.origin(joint, subject)
    axis = reader.child(joint, "axis", subject)
    if axis is not None:
        direction = reader.triple(axis, "xyz", f"{subject} axis", None)
        # Exporters write a zero axis into fixed joints, where it means nothing.
        if kind in _WITH_AXIS and not any(direction):
            fix = "write the direction in the joint's frame, such as 0 0 1"
            reader.fail(axis, f"{subject} axis", "is zero", fix, axis.get("xyz"))
    _check_limit(subject, kind, joint, reader)
    _check_losses(subject, joint, reader)
    mimic = reader.child(joint, "mimic", subject)
    if mimic is not None:
        followed = mimic.get("joint")
        if followed not in joints or followed == name:
            problem = "names no other joint of this file"
            fix = did_you_mean(followed or "", set(joints) - {name})
            reader.fail(mimic, f"{subject} mimic", problem, fix, followed)
        for attribute in ("multiplier", "offset"):
            reader.optional_number(mimic, attribute, f"{subject} mimic")


def _check_losses(subject: str, joint: Element, reader: ElementReader) -> None:
    losses = reader.child(joint, "dynamics", subject)
    if losses is None:
        return
    for key in ("damping", "friction"):
        value = reader.optional_number(losses, key, f"{subject} dynamics")
        if value is not None and value < 0.0:
            fix = "a bearing takes energy, it gives none: write it positive"
            reader.fail(losses, f"{subject} dynamics {key}", "is negative", fix, losses.get(key))


def _check_limit(subject: str, kind: str, joint: Element, reader: ElementReader) -> None:
    limit = reader.child(joint, "limit", subject)
    subject += " limit"
    needed = kind in ("revolute", "prismatic")
    if limit is None:
        if needed:
            fix = "write <limit lower upper effort velocity>, or type='continuous'"
            reader.fail(joint, subject, f"is missing, which a {kind} joint must have", fix)
        return
    names = ("lower", "upper", "effort", "velocity")
    values = {key: reader.optional_number(limit, key, subject) for key in names}
    if needed:
        for key in ("effort", "velocity"):
            reader.number(limit, key, subject)
        if values["lower"] is None and values["upper"] is None:
            fix = "write lower and upper: left out they are 0, and the joint could not move"
            reader.fail(limit, subject, "lower and upper are missing", fix)
    for key in ("effort", "velocity"):
        value = values[key]
        if value is not None and value < 0.0:
            fix = "it bounds a magnitude: write it positive"
            reader.fail(limit, f"{subject} {key}", "is negative", fix, limit.get(key))
    lower, upper = values["lower"] or 0.0, values["upper"] or 0.0
    if needed and lower > upper:
        shown = f"lower={limit.get('lower')} upper={limit.get('upper')}"
        reader.fail(limit, subject, "lower exceeds upper", "swap them", shown)
