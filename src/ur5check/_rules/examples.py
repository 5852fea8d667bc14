"""Small robots for the examples of rules: one link on one joint, with one part exchanged."""

from __future__ import annotations

__all__ = ["joint", "link", "robot"]

_INERTIAL = (
    '<inertial><origin xyz="0 0 0.1"/><mass value="2"/>'
    '<inertia ixx="0.008" ixy="0" ixz="0" iyy="0.008" iyz="0" izz="0.002"/></inertial>'
)


def link(name: str = "arm", inertial: str = _INERTIAL, shapes: str = "", **exchanged: str) -> str:
    """One link; `exchanged` replaces single attributes, such as mass="-1" or ixx="9"."""
    for key, value in exchanged.items():
        attribute = "value" if key == "mass" else key
        before, _, after = inertial.partition(f' {attribute}="')
        inertial = f'{before} {attribute}="{value}"{after[after.index(chr(34)) + 1 :]}'
    return f'<link name="{name}">{inertial}{shapes}</link>'


def joint(
    name: str = "j",
    kind: str = "revolute",
    parent: str = "base",
    child: str = "arm",
    origin: str = '<origin xyz="0 0 0.3"/>',
    axis: str = '<axis xyz="0 1 0"/>',
    limit: str = '<limit lower="-2" upper="2" effort="20" velocity="3"/>',
    more: str = "",
) -> str:
    """A joint."""
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{origin}{ends}{axis}{limit}{more}</joint>'


def robot(*parts: str, name: str = "r") -> str:
    """A robot of a base and these parts; of one arm link on one joint without any."""
    body = "\n".join(('<link name="base"/>', *(parts or (joint(), link()))))
    return f'<robot name="{name}">\n{body}\n</robot>\n'
