"""What `simulate` shows: the verdict, the torques at the start, and the drift over time."""

from __future__ import annotations

import numpy as np

from .._simulation.static_hold import StaticHold
from .document import Column, Document, Row, Section, Table, Verdict
from .provenance import Provenance, inputs_of
from .simulate_summary import reason, summarize, verdict
from .wording import percent, residue, titled

__all__ = ["simulate_document"]

_ROWS = 10  # of the drift table


def simulate_document(s: StaticHold, *, command: str = "") -> Document:
    """The report of `ur5check simulate`."""
    plant, model = s.pair.a, s.pair.given_b
    return Document(
        f"{titled(plant)} under the torques of {titled(model)}",
        Verdict("STANDS" if s.stands else "MOVES", verdict(s), s.stands),
        tuple(summarize(s)),
        (_torques(s), _drift(s), _mover(s)),
        Provenance(inputs_of((plant, model)), command=command),
    )


def _torques(s: StaticHold) -> Section:
    rows = []
    for i, joint in enumerate(s.pair.a.joints):
        given, needed = float(s.given[i]), float(s.needed[i])
        effort = joint.limits.known_effort
        share = None if not effort else abs(given - needed) / effort
        gap = residue(given - needed)
        rows.append(Row((joint.name, residue(given), residue(needed), gap, percent(share))))
    return Section(
        "The torques at the start",
        tables=(
            Table(
                (
                    Column("joint"),
                    Column("applied [N m]", number=True),
                    Column("needed [N m]", number=True),
                    Column("difference [N m]", number=True),
                    Column("of the limit [%]", number=True),
                ),
                tuple(rows),
                note=f"Applied: holds {s.pair.b.label}. Needed: holds {s.pair.a.label}, the plant.",
            ),
        ),
    )


def _drift(s: StaticHold) -> Section:
    t, last = s.motion.t, len(s.motion.t) - 1
    rows = []
    for k in dict.fromkeys(np.linspace(0, last, _ROWS + 1).round().astype(int).tolist()):
        joints = np.degrees(s.joint_drift[k])
        rows.append(
            Row(
                (
                    f"{t[k]:.3f}",
                    residue(1e3 * float(s.tool_drift[k])),
                    *(residue(float(angle)) for angle in joints),
                    residue(float(s.energy.error[k])),
                )
            )
        )
    joints_of = (Column(f"{i} [°]", number=True) for i in range(1, s.pair.a.n + 1))
    return Section(
        "The drift",
        (reason(s),),
        (
            Table(
                (
                    Column("t [s]", number=True),
                    Column("tool [mm]", number=True),
                    *joints_of,
                    Column("energy [J]", number=True),
                ),
                tuple(rows),
                note="Tool: distance from its start. 1 … : displacement of each joint. "
                "Energy: kinetic and potential energy less the work of the torques; an exact "
                "integrator leaves 0.",
            ),
        ),
    )


def _mover(s: StaticHold) -> Section:
    m = s.mover
    step = "variable step" if m.dt is None else f"steps of {m.dt:g} s"
    lines = [f"{m.name} {m.version}, integrator {m.integrator}, {step}."]
    if m.dt is not None:
        lines.append("The imported model was checked: its bodies are those of the plant.")
    if m.repaired:
        lines.append(
            f"The engine reads the file with errors: {'; '.join(m.repaired)}. The file was "
            "rewritten for it."
        )
    lines.append("Joint stops, friction, damping and contact are not simulated.")
    return Section("Integration", tuple(lines))
