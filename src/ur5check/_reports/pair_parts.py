"""What `diff` and `validate` both show of two arms: alignment, torques, attribution."""

from __future__ import annotations

import math

import numpy as np

from .._comparison.attribution import Attribution, Contribution
from .._comparison.difference import Difference
from .._robot.transforms import Array
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
            sliding = joint.kind == "prismatic"
            by = f"{1e3 * offset:+.4g} mm" if sliding else f"{math.degrees(offset):+.6g}°"
            shifted.append(f"{joint.name} by {by}")
    base = base_in_words(alignment.T_ab)
    parts = [
        f"{a.label} and {b.label} have the same base frame"
        if base == "the same"
        else f"the base of {b.label} is {base} (seen from {a.label})",
        f"reversed: {joined(reversed_joints)}" if reversed_joints else "no joint reversed",
        f"zeros shifted: {joined(shifted)}" if shifted else "no zero shifted",
        f"all {a.n} axes are the same lines in space"
        if alignment.exact
        else "the axes are NOT the same lines in space",
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
    lines += [f"Unknown: {sentence}." for sentence in alignment.unknown]
    lines += [f"Note: {sentence}." for sentence in alignment.notes]
    return tuple(lines)


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
