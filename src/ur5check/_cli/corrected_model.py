"""`log --repair`: the model corrected by a recording, as a URDF; one line on each change."""

from __future__ import annotations

from collections.abc import Callable

from .._io.urdf.urdf_writer import urdf_of
from .._logs.comparison import RecordingComparison
from .._logs.correction import Change, corrected
from .._logs.link_causes import without_mistake
from .._reports.log_summary import cause_in_words
from .output import emit

__all__ = ["write_corrected"]

#: Causes that are none of the links' numbers: bodies changed to imitate them would be wrong.
_NOT_THE_LINKS = ("gain-of-all", "gain-of-joint", "gravity-direction", "joint-zero", "joint-sign")


def write_corrected(c: RecordingComparison, file: str, say: Callable[[str], None]) -> None:
    """Write the corrected model, and say what is changed.

    Nothing is written where the recording cannot judge the model, or explains it as it is, or where
    a gain, gravity or a joint is the likeliest cause.  Raises UsageError if the file cannot be
    written.
    """
    if not c.usable or not c.judged:
        say(f"{file} is not written: this recording cannot judge the model")
    elif c.at_floor:
        say(f"{file} is not written: the model explains the recording, nothing is to be repaired")
    elif c.named and c.named[0].id in _NOT_THE_LINKS:
        say(f"{file} is not written: {cause_in_words(c.named[0], c)}; that is not in the links")
    elif c.named and c.named[0].id == "mistake":
        emit(urdf_of(without_mistake(c.arm, c.named[0])), file, option="--repair")
        say(f"repaired: {cause_in_words(c.named[0], c)}")
        say(f"wrote {file}")
    else:
        found = corrected(c.arm, c.normal)
        emit(urdf_of(found.arm), file, option="--repair")
        for change in found.changes:
            say(_line(change))
        for name in found.fixed:
            say(f"{name}: kept, it has no mass or is flat")
        say(
            f"wrote {file}: of all models that explain the recording the nearest; it explains "
            f"{found.explained:.1%} of what free parameters explain"
        )


def _line(change: Change) -> str:
    before, after, width = change.before, change.after, change.half_width
    centre = ", ".join(f"{x:.4f} ± {w:.4f}" for x, w in zip(after[1:4], width[1:4], strict=True))
    return (
        f"{change.link}: mass {before[0]:.4g} to {after[0]:.4g} ± {width[0]:.2g} kg, centre to "
        f"({centre}) m"
    )
