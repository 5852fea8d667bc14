"""Somebody else's parser on a stranger's file: in a process of its own, with bounds.

The parser may run without end, take all memory, or crash; that ends its process, not this one.

The child calls `limit_resources` before it reads the request, and writes its answer to stdout: a
file, whose size the system bounds.
"""

from __future__ import annotations

import math
import os
import resource
import signal
import subprocess
import sys
import tempfile
from contextlib import suppress
from pathlib import Path

__all__ = ["EndedError", "answer_of", "limit_resources"]

_START = (
    "import sys; sys.path[:] = sys.argv[2:]; "
    "from importlib import import_module; import_module(sys.argv[1]).main()"
)
#: A Python that is linked to shared libraries needs the first to start; the threads of a linear
#: algebra library would reserve memory for themselves.
_KEPT, _SET = ("LD_LIBRARY_PATH",), {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


class EndedError(Exception):
    """The process came to no answer.  output : what it wrote until then"""

    def __init__(self, problem: str, output: bytes) -> None:
        super().__init__(problem)
        self.problem = problem
        self.output = output


def answer_of(module: str, request: bytes, *, what: str, folder: Path, seconds: float) -> bytes:
    """All that `main()` of a module of ur5check writes to stdout, with `request` on its stdin.

    what : the work, for messages ("the expansion");  folder : in which the process works
    seconds : of wall-clock time [s], several times what the process may use of the processor

    Raises EndedError where the process ended early, by its limits, its time or a crash.
    """
    # Isolated (-I) and without site (-S): the child finds modules where this process does, and
    # nowhere else.  A relative entry would mean its own folder there: a stranger's modules.
    home = Path(__file__).resolve().parents[2]
    places = [str(Path(entry).absolute()) for entry in sys.path if entry]
    command = [sys.executable, "-I", "-S", "-X", "utf8", "-c", _START, module, *places, str(home)]
    environment = _SET | {key: os.environ[key] for key in _KEPT if key in os.environ}
    with tempfile.TemporaryFile() as output:
        problem = ""
        try:
            status = subprocess.run(  # noqa: S603 - our own interpreter, our own module
                command,
                input=request,
                stdout=output,
                stderr=subprocess.DEVNULL,
                timeout=seconds,
                env=environment,
                cwd=folder,
                check=False,
            ).returncode
            if status == -signal.SIGXCPU:
                problem = f"{what} took all the processor time that it may have"
            elif status:
                problem = f"{what} ended without an answer (status {status})"
        except subprocess.TimeoutExpired:
            problem = f"{what} took longer than {seconds:g} s"
        output.seek(0)
        data = output.read()
    if problem:
        raise EndedError(problem, data)
    return data


def limit_resources(*, seconds: float, memory: int, file_size: int) -> None:
    """Have the system bound this process: time [s], memory [byte], size of a file [byte].

    seconds : of processor time, which does not depend on what else the machine is doing
    """
    for kind, value in (
        (resource.RLIMIT_CPU, math.ceil(seconds)),
        (resource.RLIMIT_AS, memory),
        (resource.RLIMIT_FSIZE, file_size),
        (resource.RLIMIT_CORE, 0),
    ):
        # macOS knows RLIMIT_AS but does not take it; the wall clock still ends a memory bomb there.
        with suppress(ValueError, OSError):
            # At the lower of the two the process is told why it ends.
            resource.setrlimit(kind, (value, value + (kind == resource.RLIMIT_CPU)))
