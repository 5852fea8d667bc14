"""What `diff` and `validate` both show of two arms: alignment, torques, attribution."""

from __future__ import annotations

import numpy as np

from .._comparison.alignment import SAME_ANGLE
from .._comparison.attribution import Attribution, Contribution
from .._comparison.difference import Difference
from .._robot.transforms import Array
from .alignment_sentences import (
    alignment_in_words,
    nearest_in_words,
    offset_in_words,
    unknown_in_words,
)
from .difference_summary import base_in_words
from .document import Column, Row, Table
from .wording import figures, joined, link_label, percent, posture, residue

__all__ = ["alignment_lines", "contribution_rows", "contribution_table", "torque_table"]

_WORTH_A_ROW = 5e-3  # of the sizes of all contributions; a smaller one gets no row


def alignment_lines(d: Difference) -> tuple[str, ...]:
    """How b was aligned with a, in sentences."""
    a, b, alignment = d.pair.a, d.pair.b, d.pair.alignment
    reversed_joints, shifted = [], []
    for joint, sign, offset in zip(a.joints, alignment.signs, alignment.offsets, strict=True):
        if sign < 0:
            reversed_joints.append(joint.name)
        if offset:
            shifted.append(f"{joint.name} by {offset_in_words(joint, offset)}")
    base = base_in_words(alignment.T_ab)
    parts = [
        f"{a.label} and {b.label} have the same base frame"
        if base == "the same"
        else f"the base of {b.label} is {base} (seen from {a.label})",
        f"reversed: {joined(reversed_joints)}" if reversed_joints else "no joint reversed",
        f"zeros shifted: {joined(shifted)}" if shifted else "no zero shifted",
        _axes(d),
    ]
    lines = [f"Alignment found: {'; '.join(parts)}."]
    tools = "Tools" if base_in_words(alignment.tool) == "the same" else "Tools, their poses aside,"
    position, angle = residue(d.tool.position), residue(d.tool.angle)
    if alignment.exact:
        lines.append(f"{tools} agree to {position} m and {angle} rad over all states.")
    else:
        position = figures(d.tool.position)
        at = posture(d.states[d.tool.worst]["q"], a.joints)
        lines.append(
            f"Tools are up to {position} m and {angle} rad apart; furthest at q = "
            f"({', '.join(at.split())})°."
        )
    if alignment.others:
        lines.append(_others(d))
    lines += [f"Unknown: {unknown_in_words(each, a)}." for each in alignment.unknown]
    if alignment.nearest is not None:
        lines.append(f"Note: {nearest_in_words(alignment.nearest, a)}.")
    return tuple(lines)


def _axes(d: Difference) -> str:
    alignment = d.pair.alignment
    if not alignment.exact:
        return "the axes are NOT the same lines in space"
    tilt = float(alignment.axis_angle.max())
    but = "" if tilt <= SAME_ANGLE else f", but for rounded digits ({tilt:.1e} rad)"
    return f"all {d.pair.a.n} axes are the same lines in space{but}"


def _others(d: Difference) -> str:
    """How many alignments there are, and what the next would cost."""
    alignment = d.pair.alignment
    count, best = len(alignment.others), alignment.others[0]
    found = (
        f"{alignment_in_words(best, d.pair.a)}: torques up to {figures(best.torque_difference)} "
        "N m apart"
    )
    if not alignment.exact:
        also = f"; {count - 1} more with larger ones" if count > 1 else ""
        return (
            f"The axes would coincide with {found}{also}. Number by number the inertias agree far "
            "better, so joint angles are compared as they are written."
        )
    return (
        f"{count + 1} alignments make the axes coincide. This one leaves torques up to "
        f"{residue(alignment.torque_difference)} N m apart; the next, with {found}."
    )


def torque_table(d: Difference) -> Table:
    """The torque difference joint by joint, with the posture at which it is largest."""
    torques, joints = d.torques, d.pair.a.joints
    rows = [
        Row(
            (
                joint.name,
                figures(torques.scale[i]),
                figures(torques.rms[i]),
                figures(torques.maximum[i]),
                percent(torques.share_of_effort()[i]),
                posture(d.states[int(torques.worst[i])]["q"], joints),
            )
        )
        for i, joint in enumerate(joints)
    ]
    sliding = any(joint.kind == "prismatic" for joint in joints)
    unit = "N m or N" if sliding else "N m"
    return Table(
        (
            Column("joint"),
            Column(f"RMS of {d.pair.a.label} [{unit}]", number=True),
            Column(f"Δ RMS [{unit}]", number=True),
            Column(f"Δ max [{unit}]", number=True),
            Column("max of limit [%]", number=True),
            Column("posture of the maximum [°]"),
        ),
        tuple(rows),
        title=f"Torque difference: {d.pair.a.label} − {d.pair.b.label}",
    )


def contribution_table(d: Difference) -> Table:
    """The attribution of the difference, the largest contribution first."""
    rows, note = contribution_rows(d, d.attribution)
    return Table(
        (
            Column("contribution"),
            Column("weight [%]", number=True),
            Column("share [%]", number=True),
            Column("RMS [N m]", number=True),
            Column("most at joint"),
        ),
        rows,
        title="By parameter group",
        note=note,
    )


def contribution_rows(d: Difference, attribution: Attribution) -> tuple[tuple[Row, ...], str]:
    """Contributions by size, and a note on how to read them."""
    weight, share, rms = attribution.weight(), attribution.share(), attribution.rms()
    order = np.argsort(-weight, kind="stable")
    shown = [int(k) for k in order if weight[k] >= _WORTH_A_ROW]
    rows = tuple(
        Row(
            (
                _contribution_label(d, attribution.contributions[k]),
                f"{100 * weight[k]:.1f}",
                f"{round(100 * share[k], 1) + 0.0:.1f}",
                figures(rms[k].max()),
                _strongest(d, rms[k]),
            )
        )
        for k in shown
    )
    note = (
        "Weight: of the sizes of all contributions. Share: of the mean square difference; "
        "negative: against the "
        "others."
    )
    rest = int((weight > 0.0).sum()) - len(shown)
    if rest:
        note += f" {rest} more of less than {_WORTH_A_ROW:.1%} weight."
    return rows, note


def _contribution_label(d: Difference, contribution: Contribution) -> str:
    if contribution.link is None:
        return contribution.kind
    link = d.parameters[contribution.link - 1]
    return f"{contribution.kind} of {link_label(link.name_a, link.name_b)}"


def _strongest(d: Difference, rms: Array) -> str:
    return d.pair.a.joints[int(rms.argmax())].name
