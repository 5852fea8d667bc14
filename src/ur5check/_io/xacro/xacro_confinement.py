"""What a xacro file from an untrusted source may not do while it is expanded.

xacro's `${…}` is Python, and its own filter looks at the outermost names only: attributes inside a
lambda pass it, and `xacro.load_yaml` reads any file.  So xacro runs in a process of its own
(`xacro_process`), behind three lines:

1. `check_expression` reads each expression before it is evaluated and refuses the attributes by
   which Python code climbs out of its namespace.  Its message is the clearest; it can be tricked.
2. `raise_fence` hears of every file opened, process started, module imported, … (audit events, PEP
   578) and ends the process at the first one that is not on a short list.  It cannot be taken down
   again, but PEP 578 says itself that it is no prison: what has no audit event it does not see.
3. `bounded_process` has the operating system bound time, memory and file size.
"""

from __future__ import annotations

import ast
import os
import sys
from collections.abc import Callable, Sequence
from typing import Any

from ..._errors import ModelError

__all__ = ["check_expression", "raise_fence"]

# Attributes without double underscores that lead to other people's frames, code and attributes.  As
# plain names they lead nowhere: `format` is a property of many descriptions.
_WAYS_OUT = frozenset(
    {
        "vars",
        *("format", "format_map"),  # fields such as {0.__globals__} read what no expression names
        *("gi_frame", "gi_code", "cr_frame", "cr_code", "ag_frame", "ag_code", "tb_frame"),
        *("f_back", "f_globals", "f_locals", "f_builtins", "f_code"),
    }
)

# Events of evaluating an expression; no other is needed once all modules are loaded.
_HARMLESS = frozenset({"compile", "exec", "builtins.id"})
_LISTING = frozenset({"glob.glob", "glob.glob/2", "os.listdir", "os.scandir"})  # include a*.xacro
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND


def check_expression(expression: str) -> None:
    """Refuse an expression that reaches for Python's internals.

    Raises ModelError; leaves an expression that is not Python to xacro, which says so.
    """
    try:
        tree = ast.parse(expression.strip(), mode="eval")
    except (SyntaxError, ValueError):
        return
    for node in ast.walk(tree):
        name, ways_out = "", frozenset({"vars"})
        if isinstance(node, ast.Attribute):
            name, ways_out = node.attr, _WAYS_OUT
        elif isinstance(node, ast.Name):
            name = node.id
        if name.startswith("__") or name in ways_out:
            raise ModelError(
                f"the expression reaches for {name!r}, which describes no robot",
                fix="remove it, and ask who wrote this file",
                element=f"${{{expression}}}",
                rule="XAC103",
            )


def raise_fence(folders: Sequence[str], stop: Callable[[str], Any]) -> None:
    """From now on, this process may read files in these folders, and nothing else.

    stop : called with what was tried, before the process ends
    """
    allowed = tuple(os.path.realpath(folder).rstrip(os.sep) + os.sep for folder in folders)
    real_path, decode, leave = os.path.realpath, os.fsdecode, os._exit

    def is_inside(path: object) -> bool:
        # A number is an open file's, whose path is unknown.
        if not isinstance(path, str | bytes):
            return False
        return (real_path(decode(path)) + os.sep).startswith(allowed)

    def refuse(tried: str) -> None:
        # `stop` can be reached, and so replaced, by code that got this far; this one cannot.
        try:
            stop(tried)
        finally:
            leave(os.EX_NOPERM)

    def hook(event: str, args: tuple[Any, ...]) -> None:
        if event in _HARMLESS:
            return
        if event == "open":
            path, _, flags = args
            writes = flags & _WRITING
            if writes or not is_inside(path):
                refuse(f"{'write' if writes else 'read'} {path!r}")
        elif event in _LISTING:
            if not is_inside(args[0]):
                refuse(f"list {args[0]!r}")
        else:
            refuse(f"{event}({', '.join(map(repr, args))})")

    sys.addaudithook(hook)
