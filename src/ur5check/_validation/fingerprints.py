"""What a finding is known by from one run to the next: rule, subject and file, not lines.

Adding a line above a finding, or another digit to a wrong number, leaves its fingerprint as it is.
"""

from __future__ import annotations

import hashlib
import os
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

from .._finding import Finding

__all__ = ["Fingerprint", "fingerprints", "path_from"]

#: Hexadecimal digits.
Fingerprint = str

_DIGITS = 32


def fingerprints(
    findings: Iterable[Finding], file: str, folder: Path | None = None
) -> list[Fingerprint]:
    """One for each finding of a judged file, in order.

    file : that was judged: a macro that two robots include is judged with each of them
    folder : from which paths are counted (default: the current one)

    Several findings of one rule, subject and file are counted in their order.
    """
    seen: Counter[tuple[str, ...]] = Counter()
    made = []
    for finding in findings:
        place = finding.place.file or file
        key = (finding.rule, finding.subject, path_from(folder, file), path_from(folder, place))
        seen[key] += 1
        text = "\0".join((*key, str(seen[key])))
        made.append(hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()[:_DIGITS])
    return made


def path_from(folder: Path | None, file: str) -> str:
    """A file's path as seen from a folder (default: the current one), with forward slashes.

    Files outside the folder, and names that are no path, stay as they are.
    """
    start = (folder or Path.cwd()).resolve()
    if not os.path.lexists(file):
        return file
    # Not resolved: a file is where its name says, not where a link leads.
    path = Path(os.path.abspath(file))  # noqa: PTH100 - Path.absolute keeps ".."
    return path.relative_to(start).as_posix() if path.is_relative_to(start) else file
