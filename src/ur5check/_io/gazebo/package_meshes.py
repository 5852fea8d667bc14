"""Copying of meshes into a package, so that it does not depend on files elsewhere.

Each visual or collision mesh is copied to `meshes/visual` or `meshes/collision`, and the URDF names
it by
`package://` of the new package. A mesh that is not found is omitted, with a note: it has no effect
on
torques. Files that a mesh itself names (textures) are not copied.
"""

from __future__ import annotations

from pathlib import Path, PurePosixPath

from ..._errors import ModelError
from ..ros_packages import PackageMap
from ..xml.xml_numbers import Element

__all__ = ["take_meshes"]


def take_meshes(
    root: Element, *, package: str, packages: PackageMap, folder: Path
) -> tuple[dict[str, Path], list[str]]:
    """Rename the meshes in `root`; returns the files by their path inside the package, and notes.

    folder : where relative names are seen from
    """
    taken: dict[str, Path] = {}
    notes = []
    for link in root.iterchildren("link"):
        for shape in link.findall("visual") + link.findall("collision"):
            mesh = shape.find("geometry/mesh")
            if mesh is None:
                continue
            try:
                file = packages.resolve(mesh.get("filename") or "", folder)
            except ModelError as error:
                link.remove(shape)
                notes.append(f"Link {link.get('name')!r} has no {shape.tag} here: {error}.")
                continue
            inside = _place(taken, f"meshes/{shape.tag}/{file.name}", file)
            taken[inside] = file
            mesh.set("filename", f"package://{package}/{inside}")
    return taken, list(dict.fromkeys(notes))


def _place(taken: dict[str, Path], wanted: str, file: Path) -> str:
    """Where the file goes: at the wanted path, or beside the other file of that name."""
    path, place, number = PurePosixPath(wanted), wanted, 1
    while taken.get(place, file) != file:
        number += 1
        place = str(path.with_stem(f"{path.stem}_{number}"))
    return place
