"""ROS packages around a file, found without options.

In this order: the package that the file itself stands in (`package.xml` above it) and its siblings
in the same source folder, in the repository around it, or in the same colcon workspace; then what
ROS's own variables name
(ROS_PACKAGE_PATH, and `share` of each prefix in AMENT_PREFIX_PATH).  Only names are listed here;
nothing is read but `package.xml`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from itertools import chain, islice
from pathlib import Path

from .ros_packages import PackageMap, default_packages

__all__ = ["known_packages", "packages_around", "with_linked_sources"]

_NAME = re.compile(rb"<name>\s*([A-Za-z0-9_.-]+)\s*</name>")
#: A source folder with more entries is not searched for siblings: a home folder, say.
_MOST_SIBLINGS = 2000
_MOST_INNER = 100
#: A repository's top is looked for this many folders above a package.
_HIGHEST_TOP = 4


def known_packages(file: Path, given: Mapping[str, str | Path] | None = None) -> PackageMap:
    """The packages given, then those around the file, then those installed with this program."""
    around = {name: str(folder) for name, folder in packages_around(file).items()}
    return default_packages().with_packages(around).with_packages(given or {})


def packages_around(file: Path) -> dict[str, Path]:
    """Package names and their folders, the nearer first where two bear one name."""
    found: dict[str, Path] = {}
    # A link, as colcon installs it, and the file that it leads to stand in different packages.
    for here in dict.fromkeys((file.absolute(), file.resolve())):
        folder = _package_above(here)
        if folder is None:
            continue
        _add(found, folder)
        for sibling in _folders(folder.parent):
            _add(found, sibling)
        for above in _up_to_repository(folder.parent):
            for other in _folders(above):
                _add(found, other)
        if folder.parent.name == "share":  # install/NAME/share/NAME
            for prefix in _folders(folder.parents[2]):
                _add(found, prefix / "share" / prefix.name)
    for variable in ("ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH"):
        for entry in os.environ.get(variable, "").split(os.pathsep):
            if entry:
                top = Path(entry) / "share" if variable == "AMENT_PREFIX_PATH" else Path(entry)
                _add(found, top)
                for folder in _folders(top):
                    _add(found, folder)
    return found


def with_linked_sources(packages: PackageMap) -> PackageMap:
    """The map with the source folders to which the links in installed packages lead.

    `colcon build --symlink-install` fills a package's share folder with links into its sources.
    Followed are only links to files of a package of the same name.
    """
    folders = {}
    for name, known in packages.folders.items():
        sources = (source for folder in known for source in _linked_sources(name, folder))
        folders[name] = tuple(dict.fromkeys((*known, *sources)))
    return PackageMap(folders)


def _linked_sources(name: str, folder: Path) -> Iterator[Path]:
    manifest = folder / "package.xml"
    if manifest.is_symlink():
        links: Iterator[Path] = iter([manifest])
    else:
        links = islice(chain(folder.glob("*"), folder.glob("*/*")), _MOST_SIBLINGS)
    for link in links:
        source = _package_above(link.resolve()) if link.is_symlink() else None
        if source is not None:
            found: dict[str, Path] = {}
            _add(found, source)
            if name in found:
                yield source
                return


def _up_to_repository(folder: Path) -> list[Path]:
    """The folders above one, up to the top of the repository in which it lies; none outside one."""
    above = list(islice(folder.parents, _HIGHEST_TOP))
    tops = [k for k, each in enumerate(above) if (each / ".git").exists()]
    return above[: tops[0] + 1] if tops and not (folder / ".git").exists() else []


def _package_above(file: Path) -> Path | None:
    return next((each for each in file.parents if (each / "package.xml").is_file()), None)


def _folders(top: Path) -> Iterator[Path]:
    entries = _inside(top)
    if len(entries) <= _MOST_SIBLINGS:
        yield from entries
        for entry in entries:  # repositories hold their packages one level deeper
            if not (entry / "package.xml").is_file() and not entry.name.startswith("."):
                inner = _inside(entry)
                if len(inner) <= _MOST_INNER:
                    yield from inner


def _inside(folder: Path) -> list[Path]:
    """The folders in a folder, sorted; none where it cannot be read."""
    try:
        with os.scandir(folder) as entries:
            return [folder / name for name in sorted(x.name for x in entries if x.is_dir())]
    except OSError:
        return []


def _add(found: dict[str, Path], folder: Path) -> None:
    manifest = folder / "package.xml"
    try:
        text = manifest.read_bytes()[:100_000] if manifest.is_file() else b""
    except OSError:
        return
    name = _NAME.search(text)
    if name:
        found.setdefault(name[1].decode("ascii"), folder)
