"""The tables of a sweep's report."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from .._sweep.magnitude_histogram import bin_edges
from .._sweep.reach_map import HEIGHTS, RADII
from .._sweep.sweep_result import QUANTILES, Sweep
from .document import Column, Row, Table
from .wording import MISSING, figures, percent, posture

__all__ = [
    "decade_table",
    "joint_table",
    "limit_table",
    "motion_table",
    "reach_table",
    "worst_table",
]

_COARSE = 4  # cells of the reach map, each way, in one of the printed table
_DECADES = 6  # columns of the table of sizes, the last one for what is larger


def joint_table(s: Sweep) -> Table:
    """|Δτ| joint by joint."""
    quantiles = [s.quantile(share) for share in QUANTILES]
    share = s.share_of_effort()
    return Table(
        (
            Column("joint"),
            Column("RMS", number=True),
            *(Column(f"{p:.4g}".replace("0.", "."), number=True) for p in QUANTILES),
            Column("max", number=True),
            Column("max of limit [%]", number=True),
        ),
        tuple(
            Row(
                (
                    joint.name,
                    figures(s.rms[j]),
                    *(figures(sizes[j]) for sizes in quantiles),
                    figures(s.maximum[j]),
                    percent(share[j]),
                )
            )
            for j, joint in enumerate(s.pair.a.joints)
        ),
        title=f"Torque difference: {s.pair.a.label} − {s.pair.b.label} [{_unit(s)}]",
        note=f"{', '.join(f'{p:.4g}'.replace('0.', '.') for p in QUANTILES)}: the size that this "
        "share of the states does not exceed.",
    )


def worst_table(s: Sweep) -> Table:
    """The state of each joint's maximum."""
    joints = s.pair.a.joints
    return Table(
        (Column("joint"), Column("state", number=True), Column("posture [°]")),
        tuple(
            Row((joint.name, f"{s.statistics.worst[j]:,}", posture(s.worst_state(j)["q"], joints)))
            for j, joint in enumerate(joints)
        ),
        title="States of the maxima",
    )


def motion_table(s: Sweep) -> Table:
    """How the joints move in those states."""
    joints = s.pair.a.joints
    rows = []
    for j, joint in enumerate(joints):
        state = s.worst_state(j)
        motion = (posture(state[part], joints) for part in ("qd", "qdd"))
        rows.append(Row((joint.name, *motion)))
    return Table(
        (Column("joint"), Column("velocities [°/s]"), Column("accelerations [°/s²]")),
        tuple(rows),
        title="Velocities and accelerations of these states",
    )


def limit_table(s: Sweep) -> Table:
    """Share of the states that exceed the limit."""
    share, limits = s.share_over(), s.plan.tolerance
    if share is None or limits is None:
        raise ValueError("the sweep has no limit")
    return Table(
        (
            Column("joint"),
            Column(f"limit [{_unit(s)}]", number=True),
            Column("states over it", number=True),
            Column("share [%]", number=True),
        ),
        tuple(
            Row(
                (
                    joint.name,
                    figures(limits[j]),
                    f"{int(s.statistics.above_tolerance[j]):,}",
                    percent(share[j]),
                )
            )
            for j, joint in enumerate(s.pair.a.joints)
        ),
        title="States above the tolerance",
    )


def decade_table(s: Sweep) -> Table:
    """Share of the states whose difference falls into each decade."""
    top = int(np.ceil(np.log10(max(float(s.maximum.max()), 1e-9))))
    decades = 10.0 ** np.arange(top - _DECADES, top + 1)
    # A bin belongs to the decade of its middle; a decade's edge is off by half a bin at most.
    edges = bin_edges()
    middle = np.append(0.5 * (edges[1:-1] + edges[:-2]), edges[-2])
    place = np.digitize(middle, decades)
    names = [f"below {decades[0]:.4g}", *(f"to {edge:.4g}" for edge in decades[1:])]
    rows = []
    for joint, counts in zip(s.pair.a.joints, s.statistics.bins, strict=True):
        share = np.bincount(place, weights=counts, minlength=len(names) + 1) / s.count
        share[len(names) - 1] += share[len(names)]
        rows.append(Row((joint.name, *(_share(x) for x in share[: len(names)]))))
    return Table(
        (Column("joint"), *(Column(name, number=True) for name in names)),
        tuple(rows),
        title=f"Share of the states [%] by size of the difference [{_unit(s)}]",
    )


def reach_table(s: Sweep) -> Table:
    """The reach map, coarsely: heights from above, radii from the axis outwards."""
    shape = (RADII // _COARSE, _COARSE, HEIGHTS // _COARSE, _COARSE)
    seen = s.statistics.visits.reshape(shape).sum(axis=(1, 3))
    largest = s.statistics.reach.max(axis=0).reshape(shape).max(axis=(1, 3))
    radii, heights = s.plan.grid.radii()[::_COARSE], s.plan.grid.heights()[::_COARSE]
    rows = [
        Row(
            (
                f"{heights[row]:+.2f} … {heights[row + 1]:+.2f}",
                *(
                    figures(largest[column, row]) if seen[column, row] else MISSING
                    for column in range(len(seen))
                ),
            )
        )
        for row in reversed(range(seen.shape[1]))
        if seen[:, row].any()
    ]
    columns = (Column(f"{a:.2f} … {b:.2f}", number=True) for a, b in pairwise(radii))
    return Table(
        (Column("height [m]"), *columns),
        tuple(rows),
        title=f"Largest difference [{_unit(s)}] by height and radius [m]",
    )


def _share(share: float) -> str:
    return MISSING if share == 0.0 else f"{100.0 * share:.3g}"


def _unit(s: Sweep) -> str:
    sliding = any(joint.kind == "prismatic" for joint in s.pair.a.joints)
    return "N m or N" if sliding else "N m"
