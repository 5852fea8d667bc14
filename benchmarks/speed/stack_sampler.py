"""The time of a command by part: a thread samples the main thread's stack every millisecond.

    python benchmarks/speed/stack_sampler.py validate --samples 10000

runs the command, discards its report, and prints seconds per part as JSON.  A profiler that counts
calls would slow down the many small calls of the reference engines; sampling slows all parts alike.

A part is the innermost of: an import, or a folder of `_PARTS`.
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

import ur5check

__all__ = ["sampled"]

#: Folder of the package to the name of its work; an inner folder counts before its parent.
_PARTS = {
    "_io": "reading the models",
    "_engines": "reference engines",
    "_dynamics": "recursion",
    "_rules": "rules",
    "_validation": "laws",
    "_comparison": "comparison",
    "_comparison/diagnosis": "known mistakes",
    "_comparison/identifiability": "identifiability",
    "_comparison/plausibility": "plausibility",
    "_comparison/rounding": "rounding",
    "_comparison/worst_case": "worst case",
    "_reports": "report",
}
_IMPORTS, _OTHER = "imports", "other"
_PACKAGE = Path(ur5check.__file__).parent
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
            spent[part] += now - before  # includes time spent waiting for the GIL
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
    """The part a stack belongs to, from the innermost frame outwards."""
    while frame is not None:
        file, name = frame.f_code.co_filename, frame.f_code.co_name
        if file.startswith("<frozen importlib"):
            return _IMPORTS
        if file.startswith(_INSIDE):
            if name == "<module>":
                return _IMPORTS
            top, *rest = Path(file).relative_to(_PACKAGE).parts
            part = _PARTS.get(f"{top}/{rest[0]}" if rest else top) or _PARTS.get(top)
            if part is not None:
                return part
        frame = frame.f_back
    return _OTHER


if __name__ == "__main__":
    print(json.dumps(sampled(sys.argv[1:])))
