"""Checks that joints and links form one tree: one root, and one parent for every other link."""

from __future__ import annotations

from ..suggestions import did_you_mean
from ..xml.xml_numbers import Element, ElementReader

__all__ = ["check_tree"]


def check_tree(
    links: dict[str, Element], joints: dict[str, Element], reader: ElementReader
) -> None:
    """Raise ModelError for an unknown parent or child, two parents, a cycle, or a second root."""
    parent_of: dict[str, str] = {}
    joint_to: dict[str, str] = {}
    for name, joint in joints.items():
        parent = _end(name, joint, "parent", links, reader)
        child = _end(name, joint, "child", links, reader)
        if child in joint_to:
            problem = f"link {child!r} has two parents: joint {joint_to[child]!r} moves it already"
            fix = "a link hangs on one joint; remove one, or name another child"
            reader.fail(joint, f"joint {name!r}", problem, fix)
        parent_of[child], joint_to[child] = parent, name
    _refuse_cycles(parent_of, joint_to, joints, reader)
    roots = [name for name in links if name not in parent_of]
    if len(roots) > 1:
        shown = ", ".join(repr(root) for root in roots[:6])
        problem = f"links {shown} hang on no joint: the file holds {len(roots)} separate trees"
        fix = "join them with joints, or remove what does not belong"
        reader.fail(links[roots[1]], f"link {roots[1]!r}", problem, fix)


def _end(
    name: str, joint: Element, tag: str, links: dict[str, Element], reader: ElementReader
) -> str:
    subject = f"joint {name!r} {tag}"
    element = reader.child(joint, tag, f"joint {name!r}")
    if element is None or element.get("link") is None:
        reader.fail(joint, subject, "is missing", f'write <{tag} link="…"/>')
    link = str(element.get("link"))
    if link not in links:
        reader.fail(element, subject, "is no link of this file", did_you_mean(link, links), link)
    return link


def _refuse_cycles(
    parent_of: dict[str, str],
    joint_to: dict[str, str],
    joints: dict[str, Element],
    reader: ElementReader,
) -> None:
    settled: set[str] = set()
    for start in parent_of:
        climbed: list[str] = []
        link = start
        while link in parent_of and link not in settled:
            if link in climbed:
                ring = " → ".join(reversed([*climbed[climbed.index(link) :], link]))
                name = joint_to[link]
                fix = "URDF describes trees only: cut the loop at one joint"
                reader.fail(joints[name], f"joint {name!r}", "closes a cycle of links", fix, ring)
            climbed.append(link)
            link = parent_of[link]
        settled.update(climbed)
