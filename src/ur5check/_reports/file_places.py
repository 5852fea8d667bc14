"""Places of findings as a code host wants them: in files of the project, seen from its folder."""

from __future__ import annotations

import os
from dataclasses import replace

from .._finding import Finding, Place
from .._validation.fingerprints import path_from

__all__ = ["first_place", "other_places"]


def first_place(finding: Finding, file: str) -> Place:
    """Where a finding is shown: its first place in a file that is there, else the judged file.

    file : that was judged.  The place's file is seen from the current folder
    """
    found = _places(finding, file)
    return found[0] if found else Place(path_from(None, file))


def other_places(finding: Finding, file: str) -> list[Place]:
    """The other places, and the macro calls that led there, in files that are there."""
    return _places(finding, file)[1:]


def _places(finding: Finding, file: str) -> list[Place]:
    """Of the text that xacro expanded there is no file, so that its places are left out."""
    return [
        replace(place, file=path_from(None, place.file or file), via=())
        for place in finding.places
        if place.file in ("", file) or os.path.lexists(place.file)
    ]
