"""Where a command's time goes: a thread looks at the main thread's stack every millisecond.

    python -m ur5check._benchmarking.sampled validate --samples 10000

runs the command with its report thrown away, and prints seconds per part as JSON.  A profiler that
counts calls would slow down the reference engines' many small calls and nothing else; looking on
from outside costs all parts alike.

A part is the innermost of: an import, or a room of ours that has work of its own (`_ROOMS`).
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import runpy
import sys
import threading
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from time import perf_counter
from types import FrameType

__all__ = ["sampled"]

#: Rooms by what a user would call their work; the rooms that only put others together have none.
_ROOMS = {
    "sources": "reading the models",
    "engines": "the reference engines",
    "dynamics": "our recursion",
    "checks": "laws held against each other",
    "comparison": "comparison and account",
    "digits": "what digits cost",
    "diagnosis": "known mistakes",
    "identifiability": "what torque cannot see",
    "plausibility": "plausible bodies",
    "worst_case": "climbing to the worst case",
    "reports": "the report",
}
_IMPORTS, _OTHER = "imports", "other"
_PACKAGE = Path(__file__).parents[1]
_INSIDE = f"{_PACKAGE}{os.sep}"
_EVERY = 1e-3  # [s]


def sampled(arguments: Sequence[str]) -> dict[str, float]:
    """Seconds per part of one command, in this process; the whole under "whole".

    Raises SystemExit with the command's code if it is neither 0 nor 1.
    """
    spent: defaultdict[str, float] = defaultdict(float)
    done = threading.Event()
    main_thread = threading.main_thread().ident or 0

    def watch() -> None:
        before = perf_counter()
        while not done.wait(_EVERY):
            part = _part(sys._current_frames().get(main_thread))
            now = perf_counter()
            spent[part] += now - before  # code that held Python's lock kept us waiting: it counts
            before = now

    interval = sys.getswitchinterval()
    sys.setswitchinterval(_EVERY / 2)
    watcher = threading.Thread(target=watch, daemon=True)
    began = perf_counter()
    watcher.start()
    try:
        _run(arguments)
    finally:
        done.set()
        watcher.join()
        sys.setswitchinterval(interval)
    return {"whole": perf_counter() - began, **spent}


def _run(arguments: Sequence[str]) -> None:
    """The command, as `python -m ur5check` runs it."""
    before, sys.argv = sys.argv, ["ur5check", *arguments, "--quiet"]
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            runpy.run_module("ur5check", run_name="__main__")
    except SystemExit as end:
        if end.code not in (0, 1):
            raise
    finally:
        sys.argv = before


def _part(frame: FrameType | None) -> str:
    """What this stack is busy with, from the innermost frame outwards."""
    while frame is not None:
        file, name = frame.f_code.co_filename, frame.f_code.co_name
        if file.startswith("<frozen importlib"):
            return _IMPORTS
        if file.startswith(_INSIDE):
            if name == "<module>":
                return _IMPORTS
            room = Path(file).relative_to(_PACKAGE).parts[0]
            if room in _ROOMS:
                return _ROOMS[room]
        frame = frame.f_back
    return _OTHER


if __name__ == "__main__":
    print(json.dumps(sampled(sys.argv[1:])))  # noqa: T201
