"""The first screen of `diff`: at most 24 lines of 80 columns.

Verdict, what is wrong with file and line, the largest torque differences, what they are attributed
to, what else differs, the worst configuration, the tolerance.  The rest is for `--full` and files.
"""

from __future__ import annotations

import textwrap

import numpy as np

from .._comparison.causes import Causes
from .._comparison.difference import SAME_BUT_FOR_DIGITS, SAME_TORQUE, Difference
from .diff_sections.stated_uncertainty import uncertainty_in_words
from .difference_summary import (
    contributions_in_words,
    geometry_in_words,
    others_in_words,
    rounding_in_words,
    verdict_in_words,
)
from .explanation_summary import removed
from .mistake_sentences import details, sentence
from .wording import figures
from .written_numbers import numbers_of_mismatch, numbers_of_mistake

__all__ = ["diff_text"]

_LINES, _WIDTH, _TAG = 24, 80, 12
_LEAST_ROWS = 3
_NAME = 24
_FEW = 3  # unexplained numbers that are shown as they are written
_SHORT = 30  # of a place: a file's name with line and column
_WORTH_A_LINE = 0.01  # of the RMS difference: mistakes that cost less are for --full


def diff_text(
    d: Difference,
    causes: Causes | None,
    *,
    asked_tolerance: bool,
    since_commit: tuple[str, ...] = (),
) -> str:
    """The screen.

    causes : None where none were looked for;  asked_tolerance : whether the user gave it
    since_commit : what else a commit changed, in sentences
    """
    verdict, geometry = verdict_in_words(d), geometry_in_words(d)
    word = "AGREE" if d.agrees else "DIFFER"
    head = textwrap.wrap(f"{word}  {verdict}", _WIDTH, subsequent_indent=" " * (len(word) + 2))
    foot = _foot(d, causes, geometry, asked_tolerance)
    foot += [line for said in since_commit for line in _tagged("commit", said, 2)]
    joints = [] if d.same_torques else _joints(d)
    wrong = _wrong(d, causes)
    left = _LINES - len(head) - len(foot)
    rows = _cut_rows(joints, max(min(len(joints), _LEAST_ROWS + 1), left - len(wrong)), d)
    wrong = _cut(wrong, left - len(rows))
    return "\n".join([*head, *wrong, *rows, *foot]) + "\n"


def _tagged(tag: str, text: str, most: int | None = None) -> list[str]:
    """Lines under each other, `tag` before the first."""
    lines = textwrap.wrap(
        f"{tag:{_TAG}}{text}",
        _WIDTH,
        subsequent_indent=" " * _TAG,
        break_long_words=True,
        break_on_hyphens=False,
    )
    if most is not None and len(lines) > most:
        lines = [*lines[: most - 1], f"{lines[most - 1][: _WIDTH - 2]} …"]
    return lines


def _ending(place: str, most: int) -> str:
    """A long path is cut at its beginning."""
    return place if len(place) <= most else f"…{place[len(place) - most + 1 :]}"


def _cut(lines: list[str], most: int) -> list[str]:
    if len(lines) <= most:
        return lines
    kept = max(most - 1, 0)
    return [*lines[:kept], f"{'':{_TAG}}… {len(lines) - kept} more lines (--full)"][: max(most, 0)]


# --- what is wrong -------------------------------------------------------------------------------


def _wrong(d: Difference, causes: Causes | None) -> list[str]:
    """Why a model cannot exist, then mistakes with the numbers as they are written."""
    lines = []
    for fault in (fault for faults in d.faults.values() for fault in faults):
        at = _ending(str(fault.place), _WIDTH - _TAG - 8)
        lines += _tagged("impossible", f"{at} {fault.rule} {fault.subject}: {fault.message}", 3)
    lines += [line for said in rounding_in_words(d) for line in _tagged("rounded", said, 2)]
    if causes is None or d.same_torques:
        return lines
    diagnosis = causes.diagnosis
    for found in diagnosis.mistakes:
        share = removed(found, diagnosis)
        if share <= _WORTH_A_LINE:
            continue
        said = f"{sentence(found, diagnosis.pair)}; repairing it removes {share:.0%}."
        lines += _tagged("mistake", said, 3)
        lines += _written(numbers_of_mistake(found, d, diagnosis) or details(found))
    unexplained = sorted(diagnosis.unexplained, key=lambda each: -each.gap)
    names = [f"link {each.link + 1}'s {each.quantity.replace('_', ' ')}" for each in unexplained]
    if len(names) > _FEW:
        more = f"{', '.join(names[:_FEW])} and {len(names) - _FEW} more"
        lines += _tagged("unexplained", f"{more}: no known mistake", 2)
    else:
        for mismatch, name in zip(unexplained, names, strict=True):
            lines += _tagged("unexplained", f"{name}: no known mistake", 2)
            lines += _written(numbers_of_mismatch(mismatch, d))
    if diagnosis.unexplained and any(
        removed(found, diagnosis) > _WORTH_A_LINE for found in diagnosis.mistakes
    ):
        left = f"{diagnosis.after:.2g} of {diagnosis.before:.3g} N m RMS after these repairs"
        lines += _tagged("remains", left)
    return lines


def _written(numbers: tuple[str, ...]) -> list[str]:
    """The first of them."""
    lines = []
    for number in numbers[:2]:
        place, _, said = number.partition(": ")
        left = _WIDTH - _TAG - len(said) - 2
        lines += _tagged("", f"{_ending(place, max(left, _SHORT))}: {said}", 2)
    if len(numbers) > 2:
        lines[-1] = f"{lines[-1]}; {len(numbers) - 2} more"
        lines[-1] = lines[-1] if len(lines[-1]) <= _WIDTH else f"{lines[-1][: _WIDTH - 1]}…"
    return lines


# --- torques -------------------------------------------------------------------------------------


def _joints(d: Difference) -> list[str]:
    """A heading, and a row a joint."""
    sliding = any(joint.kind == "prismatic" for joint in d.pair.a.joints)
    unit = "N m or N" if sliding else "N m"
    rows = [f"{f'largest differences [{unit}]':{_NAME + 8}}{'Δτ':>9}{'RMS':>10}{'of limit':>10}"]
    share, torques = d.torques.share_of_effort(), d.torques
    for i, joint in enumerate(d.pair.a.joints):
        label = f"{i + 1} {joint.name}"
        label = label if len(label) <= _NAME + 6 else f"{label[: _NAME + 5]}…"
        part = "" if np.isnan(share[i]) else f"{share[i]:.1%}"
        rows.append(
            f"  {label:{_NAME + 6}}{figures(torques.maximum[i]):>9}{figures(torques.rms[i]):>10}"
            f"{part:>10}"
        )
    return [row.rstrip() for row in rows]


def _cut_rows(rows: list[str], most: int, d: Difference) -> list[str]:
    """The rows of the joints with the largest differences, in the order of the joints."""
    if len(rows) <= most:
        return rows
    kept = sorted(np.argsort(-d.torques.maximum, kind="stable")[: max(most - 2, 1)].tolist())
    left = len(rows) - 1 - len(kept)
    return [rows[0], *(rows[i + 1] for i in kept), f"  … {left} more joints (--full)"]


# --- the rest ------------------------------------------------------------------------------------


def _foot(d: Difference, causes: Causes | None, geometry: str, asked_tolerance: bool) -> list[str]:
    lines = _tagged("geometry", geometry, 3)
    if not d.same_torques:
        lines += _tagged("attribution", contributions_in_words(d).removeprefix("Attributed to "), 3)
    others = others_in_words(d).removeprefix("Also different: ")
    if others:
        lines += _tagged("also", others, 3)
    if d.band is not None:
        lines += _tagged("uncertainty", uncertainty_in_words(d, d.band), 2)
    if causes is not None and causes.worst is not None:
        lines += _worst(d, causes)
    lines += _tagged("agreement", _tolerance(d, asked_tolerance), 2)
    return lines


def _worst(d: Difference, causes: Causes) -> list[str]:
    worst = causes.worst
    if worst is None or worst.joint is None:
        return []
    joint = d.pair.a.joints[worst.joint - 1]
    share = "" if worst.effort_share is None else f", {worst.effort_share:.0%} of its limit"
    parts = []
    for value, each in zip(worst.state["q"], d.pair.a.joints, strict=True):
        slides = each.kind == "prismatic"
        parts.append(f"{1e3 * value:.0f}mm" if slides else f"{np.degrees(value):.0f}°")
    said = (
        f"at least {figures(worst.value)} {worst.unit} at joint {worst.joint} ({joint.name})"
        f"{share} ({worst.reached} of {worst.starts} starts), q = ({' '.join(parts)})"
    )
    return _tagged("worst", said, 3)


def _tolerance(d: Difference, asked: bool) -> str:
    bounds = sorted({figures(float(value)) for value in d.tolerance}, key=float)
    within = bounds[0] if len(bounds) == 1 else f"{bounds[0]} to {bounds[-1]}"
    part = SAME_BUT_FOR_DIGITS if d.rounding_explains else SAME_TORQUE
    why = "as asked" if asked else f"{part:.0e} of the largest torque".replace("e-0", "e-")
    return (
        f"within {within} N m ({why}), over {len(d.states):,} random states; "
        "--full shows all tables"
    )
