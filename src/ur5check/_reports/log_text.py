"""The first screen of `log`: at most 24 lines of 80 columns."""

from __future__ import annotations

import textwrap

from .._finding import worst_first
from .._logs.comparison import RecordingComparison
from .log_summary import summarize_log, verdict_of_log, word_of_log
from .wording import MISSING, figures

__all__ = ["log_text"]

_LINES, _WIDTH = 24, 80
_NAME = 16


def log_text(c: RecordingComparison) -> str:
    """Verdict, joints, what would explain the residual, what is wrong with the recording."""
    word = word_of_log(c)
    head = textwrap.wrap(f"{word}  {verdict_of_log(c)}", _WIDTH, subsequent_indent="      ")
    r, s = c.recording, c.signals
    foot = [
        f"recording  {r.count:,} of {c.rows:,} rows, {r.duration:.4g} s at {r.rate:.4g} Hz, "
        f"low-pass {s.cutoff:.3g} Hz"
    ]
    foot += [
        line
        for f in worst_first(c.findings)[:3]
        for line in textwrap.wrap(
            f"{f.severity:7} {f.rule}  {f.subject} {f.message}", _WIDTH, subsequent_indent="    "
        )[:2]
    ]
    said = [
        line
        for sentence in summarize_log(c)
        for line in textwrap.wrap(sentence, _WIDTH, subsequent_indent="  ")
    ]
    left = _LINES - len(head) - len(foot)
    table = _table(c, max(3, left - len(said)))
    free = left - len(table)
    if len(said) > free:
        said = [*said[: max(0, free - 1)], "… (--full)"]
    return "\n".join([*head, *table, *said, *foot]) + "\n"


def _table(c: RecordingComparison, lines: int) -> list[str]:
    columns = ("measured", "model", "residual", "floor", "÷ floor")
    head = f"{'N m':{_NAME}}" + "".join(f"{name:>10}" for name in columns) + f"{'scale':>12}"
    rows = [head]
    for joint in c.joints[: lines - 1]:
        name = joint.name if len(joint.name) <= _NAME else f"{joint.name[: _NAME - 1]}…"
        numbers = [figures(x) for x in (joint.measured, joint.model, joint.with_rotor, joint.floor)]
        judged = joint.stands_out
        numbers.append(f"{joint.above_floor:.2f}" if judged else MISSING)
        scale = f"{joint.scale:.3f}±{joint.scale_half_width:.3f}" if judged else MISSING
        rows.append(f"{name:{_NAME}}" + "".join(f"{x:>10}" for x in numbers) + f"{scale:>13}")
    return rows
