"""What other validators say of URDF files; run by `bench_peers.py` with their environment's Python.

    PYTHON peers_worker.py simcheck|urdf-validator FOLDER < names of files, one a line

Answers with one line of JSON a file: its name, the exit code, the seconds of processor time it
took, whether it ended within `LIMIT`, and everything reported at least as a warning.  Each tool's
own command runs, in this process: what is imported once is not counted in every file's time.
"""

import contextlib
import io
import json
import signal
import sys
import time
from pathlib import Path

#: Processor time that one file may take [s].
LIMIT = 30.0


class OutOfTime(BaseException):
    """Not an Exception: tools catch those."""


def stop(signum, frame):
    raise OutOfTime


def simcheck(file, folder):
    """Exit code and messages of `simcheck check FILE`, with every engine that is installed."""
    from simcheck.cli import main

    report = folder / "simcheck.json"
    code = main(["check", str(file), "--no-config", "--no-cache", "--json", str(report)])
    said = []
    for result in json.loads(report.read_text())["results"]:
        for finding in result["findings"]:
            if finding["severity"] in ("error", "warning"):
                said.append([finding["severity"], finding["check"], finding["message"]])
    return code, said


def urdf_validator(file, folder):
    """Exit code and messages of `urdf_validate FILE`."""
    from urdf_validator_main.cli import main

    report = folder / f"{file.stem}_validation.json"
    report.unlink(missing_ok=True)
    sys.argv = ["urdf_validate", str(file), "--output-dir", str(folder)]
    code = main()
    said = []
    if report.exists():
        found = json.loads(report.read_text())
        for part in (found, found["schema"] or {}):
            said += [["error", "critical", str(x)] for x in part.get("critical_issues") or ()]
            said += [["warning", "warning", str(x)] for x in part.get("warnings") or ()]
    return code, said


def judged(tool, file, folder):
    """One line's worth: an exception of the tool is a report too."""
    began = time.process_time()
    ended = True
    signal.setitimer(signal.ITIMER_PROF, LIMIT)
    try:
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            code, said = tool(file, folder)
    except SystemExit as end:
        code, said = end.code, []
    except Exception as error:  # noqa: BLE001 - whatever a tool raises
        code, said = 1, [["error", "exception", f"{type(error).__name__}: {error}"]]
    except OutOfTime:
        code, said, ended = 0, [], False
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
    return {
        "file": file.name,
        "ended": ended,
        "code": 0 if code is None else code,
        "seconds": time.process_time() - began,
        "said": said,
    }


if __name__ == "__main__":
    TOOL = {"simcheck": simcheck, "urdf-validator": urdf_validator}[sys.argv[1]]
    FOLDER = Path(sys.argv[2])
    signal.signal(signal.SIGPROF, stop)
    for line in sys.stdin:
        print(json.dumps(judged(TOOL, FOLDER / line.strip(), FOLDER)), flush=True)
