"""A difference in a few sentences, the verdict first."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._arguments import instance
from .._comparison.alignment import SAME_ANGLE, SAME_LENGTH
from .._comparison.attribution import Contribution
from .._robot.transforms import Transform
from .diff_sections.stated_uncertainty import uncertainty_in_words
from .rounding_sentences import constant_in_words
from .wording import joined

if TYPE_CHECKING:
    from .._comparison.difference import Difference

__all__ = [
    "base_in_words",
    "contribution_in_words",
    "contributions_in_words",
    "geometry_in_words",
    "rounding_in_words",
    "summarize",
    "verdict_in_words",
]

_WORTH_A_WORD = 0.02  # of the mean square difference: smaller contributions are in the table only
_STANDS_OUT = 3.0  # principal moments further apart than this are named


def summarize(difference: Difference) -> tuple[str, ...]:
    """Three to six sentences: verdict, geometry, gravity, attribution, outliers, residual."""
    sentences = [
        verdict_in_words(difference),
        *rounding_in_words(difference),
        geometry_in_words(difference),
    ]
    if not difference.same_torques:
        sentences += [
            _gravity(difference),
            contributions_in_words(difference),
            _outliers(difference),
        ]
    if difference.band is not None:
        sentences.append(uncertainty_in_words(difference, difference.band))
    sentences.append(others_in_words(difference))
    sentences += faults_in_words(difference)
    sentences.append(_residual(difference))
    return tuple(sentence for sentence in sentences if sentence)


def base_in_words(T: Transform) -> str:
    """A base transform as "turned by 180° about z and shifted by (0, 0, 100) mm"."""
    parts = []
    if T.angle() > SAME_ANGLE:
        parts.append(f"turned by {np.degrees(T.angle()):.4g}° about {_axis_in_words(T)}")
    if np.abs(T.p).max() > SAME_LENGTH:
        parts.append(f"shifted by ({', '.join(f'{1e3 * x:.4g}' for x in T.p + 0.0)}) mm")
    return " and ".join(parts) or "the same"


def contribution_in_words(contribution: Contribution) -> str:
    """A contribution as "link 2, centre of mass".

    Parameters
    ----------
    contribution : Contribution
        See `ur5check.results.Attribution`.

    Returns
    -------
    str

    Raises
    ------
    UsageError
        For another type.

    Examples
    --------
    >>> import ur5check
    >>> from ur5check.results import Contribution
    >>> ur5check.contribution_in_words(Contribution("mass", 2))
    'link 2, mass'
    """
    instance("contribution", contribution, Contribution, "see Attribution.contributions")
    return (
        contribution.kind
        if contribution.link is None
        else f"link {contribution.link}, {contribution.kind}"
    )


def verdict_in_words(d: Difference) -> str:
    """The first sentence."""
    a, b = d.pair.a.label, d.pair.b.label
    what, kind = "dynamics", "torques"
    if d.gravity_only:
        what, kind = "gravity torques (tensors are unknown)", "gravity torques"
    worst = int(d.torques.maximum.argmax())
    size = f"{d.torques.maximum[worst]:.3g} N m"
    joint = f"joint {worst + 1}, {d.pair.a.joints[worst].name}"
    if d.rounding_explains:
        within = "agree within" if d.same_torques else "are apart by up to"
        return f"{a} and {b} {within} {size} ({joint}): rounded digits explain the difference."
    if d.same_torques:
        same = f"no torque differs by more than {size}."
        if not d.others:
            return f"{a} and {b} have the same {what}: {same}"
        return f"{a} and {b} need the same torques, but are not the same: {same}"
    effort = d.torques.effort[worst]
    share = "" if np.isnan(effort) else f", {d.torques.share_of_effort()[worst]:.0%} of its limit"
    return f"{a} and {b} need different {kind}: up to {size} apart ({joint}{share})."


def rounding_in_words(d: Difference) -> tuple[str, ...]:
    """The constants that were written with few digits, where they explain the difference."""
    if not d.rounding_explains:
        return ()
    names = {"a": d.pair.a.label, "b": d.pair.b.label}
    return tuple(
        f"Rounded digits in {names[each.side]}: {constant_in_words(each.cause)}."
        for each in d.pair.corrections
    )


def geometry_in_words(d: Difference) -> str:
    """Whether the axes coincide, and how b was brought there."""
    alignment = d.pair.alignment
    if not alignment.exact:
        return f"Different geometry: {_unequal_reach(d)}."
    joints = []
    for joint, sign, offset in zip(
        d.pair.a.joints, alignment.signs, alignment.offsets, strict=True
    ):
        if sign < 0:
            joints.append(f"{joint.name} reversed")
        if offset:
            unit, value = ("°", np.degrees(offset)) if joint.kind == "revolute" else (" m", offset)
            joints.append(f"{joint.name} shifted by {value:+.4g}{unit}")
    angles = ", ".join(joints) or "joint angles unchanged"
    base = base_in_words(alignment.T_ab)
    return (
        f"Same axes in space{_but_for(d)}: {d.pair.b.label}'s base is {base}, {angles}; "
        f"tools agree to {d.tool.position:.1g} m."
    )


def _but_for(d: Difference) -> str:
    tilt = float(d.pair.alignment.axis_angle.max())
    return f" but for rounded digits ({tilt:.1e} rad)" if tilt > SAME_ANGLE else ""


def _unequal_reach(d: Difference) -> str:
    opposite, other = [], []
    for link in d.parameters:
        gap = np.abs(link.reach_a - link.reach_b).max()
        if gap <= SAME_LENGTH:
            continue
        # A sign is lost where the vectors are each other's opposite, to the digits.
        if np.abs(link.reach_a + link.reach_b).max() <= max(SAME_LENGTH, 1e-3 * gap):
            opposite.append(f"{link.link} ({np.linalg.norm(link.reach_a):.4g} m)")
        else:
            other.append(f"{link.link} (by {1e3 * gap:.3g} mm)")
    parts = []
    if opposite:
        parts.append(
            f"link{'s' if len(opposite) > 1 else ''} {joined(opposite)} "
            f"reach{'' if len(opposite) > 1 else 'es'} the opposite way, as if a sign were lost"
        )
    if other:
        parts.append(f"the reach of link{'s' if len(other) > 1 else ''} {joined(other)} differs")
    tilt = float(d.pair.alignment.axis_angle.max())
    if tilt > SAME_ANGLE:
        parts.append(f"axes tilt by up to {tilt:.2g} rad")
    return "; ".join(parts) or "the axes cannot be made to coincide"


def _gravity(d: Difference) -> str:
    g_a, g_b = d.pair.a.gravity, d.pair.b.gravity
    if np.abs(g_a - g_b).max() <= 1e-9 * np.linalg.norm(g_a):
        return ""
    if np.linalg.norm(np.cross(g_a, g_b)) < 1e-9 * np.linalg.norm(g_a) * np.linalg.norm(g_b):
        sizes = f"{np.linalg.norm(g_a):.6g} against {np.linalg.norm(g_b):.6g} m/s²"
        return f"Different gravity: {sizes}."
    return f"Different gravity: {g_a.tolist()} against {g_b.tolist()} m/s²."


def others_in_words(d: Difference) -> str:
    """Which numbers beside geometry and inertias differ, each with its joints."""
    where: dict[str, list[str]] = {}
    for other in d.others:
        where.setdefault(other.quantity, []).append(other.joint)
    named = [
        quantity
        if joints == [""]
        else f"{quantity} ({', '.join(joints[:3])}"
        f"{f' and {len(joints) - 3} more' if joints[3:] else ''})"
        for quantity, joints in where.items()
    ]
    return f"Also different: {'; '.join(named)}." if named else ""


def faults_in_words(d: Difference) -> tuple[str, ...]:
    """Why either arm cannot exist, a sentence each."""
    labels = {"a": d.pair.a.label, "b": d.pair.b.label}
    return tuple(
        f"{labels[side]} cannot exist: {fault.subject}: {fault.message} "
        f"({', '.join(part for part in (fault.rule, str(fault.place)) if part)})."
        for side, faults in d.faults.items()
        for fault in faults
    )


def contributions_in_words(d: Difference) -> str:
    """What most of the difference is attributed to."""
    share = d.attribution.share()
    order = np.argsort(-share)
    named = [
        f"{contribution_in_words(d.attribution.contributions[k])} {share[k]:.0%}"
        for k in order[:4]
        if share[k] > _WORTH_A_WORD
    ]
    return f"Attributed to {'; '.join(named)} of the mean square difference."


def _outliers(d: Difference) -> str:
    """Masses and principal moments that differ by more than any two measurements would."""
    found = []
    for link in d.parameters:
        ratio = link.moment_ratio()
        if ratio > _STANDS_OUT:
            found.append(f"principal moments of link {link.link} are {ratio:.3g} times apart")
        masses = sorted([link.a.mass, link.b.mass])
        if masses[0] <= 0.0 or masses[1] / masses[0] > _STANDS_OUT:
            found.append(f"link {link.link} has {link.a.mass:.4g} kg against {link.b.mass:.4g} kg")
    return f"Outliers: {'; '.join(found)}." if found else ""


def _residual(d: Difference) -> str:
    residual = float(np.abs(d.attribution.remainder).max())
    return f"The attribution is complete: its residual is {residual:.1g} N m."


def _axis_in_words(T: Transform) -> str:
    """The rotation axis of T, by name where it has one."""
    # R + Rᵀ − (tr R − 1) 1 = 2 (1 − cos) u uᵀ: fine up to half a turn, where R − Rᵀ vanishes.
    outer = T.R + T.R.T - (np.trace(T.R) - 1.0) * np.eye(3)
    u = outer[:, int(np.abs(np.diag(outer)).argmax())]
    u = u / np.linalg.norm(u)
    rotation = np.array([T.R[2, 1] - T.R[1, 2], T.R[0, 2] - T.R[2, 0], T.R[1, 0] - T.R[0, 1]])
    if u @ rotation < 0.0 or (abs(u @ rotation) < 1e-12 and u[np.abs(u).argmax()] < 0.0):
        u = -u
    for k, name in enumerate("xyz"):
        if abs(abs(u[k]) - 1.0) < SAME_ANGLE:
            return name if u[k] > 0 else f"−{name}"
    return f"({', '.join(f'{x:.3g}' for x in u)})"
