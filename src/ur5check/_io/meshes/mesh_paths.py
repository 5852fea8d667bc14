"""Mesh addresses of a URDF, written as paths, for readers that know no ROS packages."""

from __future__ import annotations

from pathlib import Path

from lxml import etree

from ..._errors import ModelError
from ..ros_packages import PackageMap
from ..xml.safe_xml import parsed_xml

__all__ = ["with_mesh_paths"]


def with_mesh_paths(urdf: str, packages: PackageMap, folder: Path) -> tuple[str, tuple[str, ...]]:
    """The URDF's text with every mesh found, and what is said of those that were not.

    Shapes whose mesh is nowhere are left out, for a reader would refuse the whole file; a shape is
    no part of the dynamics.

    folder : where the file lies, for relative addresses
    """
    root = parsed_xml(urdf)
    lost = []
    for mesh in root.findall("link/*/geometry/mesh"):
        address = mesh.get("filename", "")
        try:
            mesh.set("filename", str(packages.resolve(address, folder).resolve()))
        except ModelError as error:
            shape = mesh.getparent().getparent()
            shape.getparent().remove(shape)
            lost.append(f"a shape is left out: {error}")
    return str(etree.tostring(root, encoding="unicode")) + "\n", tuple(dict.fromkeys(lost))
