"""How a ROS package name becomes a folder, without ROS.

Descriptions speak of `$(find ur_description)` and `package://ur_description/meshes/…`.  ROS asks
its index for the folder; here a `PackageMap` answers, from what the user gave (`--package
NAME=DIR`) and what is installed with this program.

A package may have several folders, searched in order: this program's `ur_description` holds the
xacro files, that of `example-robot-data` the meshes.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import metadata
from pathlib import Path
from types import MappingProxyType
from urllib.parse import unquote, urlsplit

from .._errors import ModelError
from .suggestions import did_you_mean

__all__ = ["PackageMap", "default_packages", "example_robot_data", "models_directory"]

_ROBOTS = Path("share", "example-robot-data", "robots")


@dataclass(frozen=True, eq=False)
class PackageMap:
    """Package names and their folders.  Immutable.

    folders : name to one or more existing folders, made absolute; the first one counts first
    """

    folders: Mapping[str, tuple[Path, ...]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        checked = {
            name: tuple(_existing_folder(name, folder) for folder in folders)
            for name, folders in self.folders.items()
        }
        object.__setattr__(self, "folders", MappingProxyType(checked))

    def find(self, name: str) -> Path:
        """The package's first folder: what `$(find name)` stands for.

        Raises ModelError for an unknown package.
        """
        return self._folders_of(name, element=f"package {name!r}")[0]

    def resolve(self, uri: str, relative_to: Path) -> Path:
        """The existing file that a description means.

        uri : `package://NAME/…`, `file://…`, or a path, absolute or seen from `relative_to`
        relative_to : the folder of the file in which it is written

        Raises ModelError if there is no such file, or if a package:// URI leaves its package.
        """
        parts = urlsplit(uri)
        if parts.scheme == "package":
            name, inside = parts.netloc, unquote(parts.path).lstrip("/")
            folders = self._folders_of(name, element=uri)
            if ".." in Path(inside).parts:
                raise ModelError(
                    "the path climbs out of its package",
                    fix="name the package that holds the file",
                    element=uri,
                )
            candidates = [folder / inside for folder in folders]
        elif parts.scheme == "file" and parts.netloc in ("", "localhost"):
            candidates = [Path(unquote(parts.path))]
        elif "://" not in uri:
            candidates = [relative_to / uri]
        else:
            raise ModelError(
                "this kind of address is not supported",
                fix="use package://, file:// or a path",
                element=uri,
            )
        for candidate in candidates:
            if candidate.is_file():
                return candidate
        looked = ", ".join(str(candidate) for candidate in candidates)
        raise ModelError(
            f"no such file (looked at {looked})",
            fix="correct the name, or pass --package NAME=DIR for the folder that has it",
            element=uri,
        )

    def with_packages(
        self, more: Mapping[str, str | os.PathLike[str] | Iterable[str | os.PathLike[str]]]
    ) -> PackageMap:
        """This map with further folders, which are searched before those it has already."""
        folders = dict(self.folders)
        for name, given in more.items():
            new = [given] if isinstance(given, str | os.PathLike) else list(given)
            folders[name] = (*map(Path, new), *folders.get(name, ()))
        return PackageMap(folders)

    def _folders_of(self, name: str, *, element: str) -> tuple[Path, ...]:
        folders = self.folders.get(name)
        if not folders:
            raise ModelError(
                f"package {name!r} is not known",
                fix=f"pass --package {name or 'NAME'}=DIR ({did_you_mean(name, self.folders)})",
                element=element,
            )
        return folders


def default_packages() -> PackageMap:
    """The packages that are known without options.

    `ur_description` of this program (then that of example-robot-data, for the meshes), every robot
    of example-robot-data by the name of its folder, and `example-robot-data` itself.
    """
    folders: dict[str, tuple[Path, ...]] = {
        "ur_description": (models_directory() / "ur_description",)
    }
    share = example_robot_data()
    if share is not None:
        folders[share.name] = (share,)
        for folder in sorted((share / "robots").iterdir()):
            if folder.is_dir():
                folders[folder.name] = (*folders.get(folder.name, ()), folder)
    return PackageMap(folders)


def models_directory() -> Path:
    """The folder `models`: inside the installed package, or at the top of a checkout."""
    here = Path(__file__).resolve()
    candidates = (here.parents[1] / "models", here.parents[3] / "models")
    for candidate in candidates:
        if (candidate / "paper.toml").is_file():
            return candidate
    raise ModelError(
        "the shipped models are missing",
        fix="install ur5check again",
        file=str(candidates[0]),
    )


@cache
def example_robot_data() -> Path | None:
    """`share/example-robot-data` of the installed robots, or None if they are not installed.

    As a wheel they lie under the prefix of cmeel, which packs such libraries, and the wheel's list
    of files knows where.  Installed otherwise (conda, a system's packages) they lie under Python's.
    """
    candidates = [Path(sys.prefix) / _ROBOTS]
    try:
        distribution = metadata.distribution("example-robot-data")
    except metadata.PackageNotFoundError:
        pass
    else:
        marker = f"{_ROBOTS.as_posix()}/"
        for file in distribution.files or ():
            prefix, found, _ = file.as_posix().partition(marker)
            if found:
                candidates.insert(0, Path(str(distribution.locate_file(prefix))) / _ROBOTS)
                break
    for candidate in candidates:
        if candidate.is_dir():
            return candidate.resolve().parent
    return None


def _existing_folder(name: str, folder: Path) -> Path:
    absolute = Path(folder).expanduser().resolve()
    if not absolute.is_dir():
        raise ModelError(
            "the package's folder does not exist",
            fix="correct the folder in --package NAME=DIR",
            element=f"package {name!r}",
            value=str(folder),
        )
    return absolute
