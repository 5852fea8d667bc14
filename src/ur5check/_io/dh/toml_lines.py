"""Line of a value in a TOML text (tomllib keeps no lines)."""

from __future__ import annotations

import re

__all__ = ["line_of"]

_ROW = re.compile(r"\s*\[\[\s*joint\s*\]\]")
_TABLE = re.compile(r"\s*\[\s*([\w.\"'-]+)\s*\]\s*(#.*)?$")


def line_of(text: str, row: int | None, key: str | None) -> int | None:
    """The line, from 1, on which `key` is set; of the row itself where the key is not found.

    row : which [[joint]], from 0; None for the keys above them
    key : None asks for the row's own header

    Finds keys that stand on lines of their own; with several on one line, the row's header line may
    be
    returned instead.
    """
    lines = text.splitlines()
    headers = [number for number, line in enumerate(lines) if _ROW.match(line)]
    if row is None:
        start, end, fallback = 0, headers[0] if headers else len(lines), None
    elif row < len(headers):
        start = headers[row]
        end = headers[row + 1] if row + 1 < len(headers) else len(lines)
        fallback = start + 1
    else:
        return None
    if key is None:
        return fallback
    sets_key = re.compile(rf"""\s*["']?{re.escape(key)}["']?\s*[=.]""")
    opens_key = re.compile(rf"\s*\[\s*joint\s*\.\s*{re.escape(key)}\s*\]")
    in_table = False
    for number in range(start, end):
        line = lines[number]
        if opens_key.match(line):
            return number + 1
        in_table = in_table or bool(_TABLE.match(line))
        if not in_table and sets_key.match(line):
            return number + 1
    return fallback
