"""`ur5check simulate` as JSON."""

from __future__ import annotations

import msgspec
import numpy as np

from .._simulation.static_hold import STILL, StaticHold
from .json_report import Report, head
from .json_values import (
    AlignmentValue,
    Matrix,
    Model,
    Number,
    Vector,
    alignment_value,
    model_value,
    vector,
)
from .simulate_summary import reason, summarize, verdict

__all__ = ["SimulateReport", "simulate_json"]

_INSTANTS = 501  # at most, evenly picked: enough for a plot


class StandVerdict(msgspec.Struct, frozen=True, kw_only=True):
    """Whether the arm stands, and the thresholds by which that is judged [m], [rad]."""

    stands: bool
    left_after: Number
    tool_threshold: float
    joint_threshold: float
    reason: str


class IntegratorValue(msgspec.Struct, frozen=True, kw_only=True):
    """The engine and integrator of the simulation, its step [s], and the repairs of the model."""

    engine: str
    version: str
    integrator: str
    step: Number
    repaired: list[str]


class JointHold(msgspec.Struct, frozen=True, kw_only=True):
    """Torques at the start: what is applied, what the plant needs to stand [N m]."""

    joint: str
    given: float
    needed: float
    effort_limit: Number


class EnergyValue(msgspec.Struct, frozen=True, kw_only=True):
    """The energy balance of the integration [J]."""

    error_max: float
    exchanged: float


class MotionValue(msgspec.Struct, frozen=True, kw_only=True):
    """The motion at some instants t [s]."""

    t: Vector
    q: Matrix
    qd: Matrix
    tool_drift: Vector
    work: Vector
    energy_error: Vector


class SimulateReport(Report, frozen=True, kw_only=True, tag="ur5check.simulate/2"):
    """One model's arm under the holding torques of another."""

    verdict: StandVerdict
    summary: list[str]
    plant: Model
    torque_model: Model
    alignment: AlignmentValue
    integration: IntegratorValue
    held: bool
    seconds: float
    stopped: bool
    start: Vector
    torques: list[JointHold]
    growth_rate: float
    energy: EnergyValue
    motion: MotionValue


def simulate_json(s: StaticHold, *, command: str = "") -> SimulateReport:
    """The report of `ur5check simulate`."""
    plant, model, m = s.pair.a, s.pair.given_b, s.mover
    return SimulateReport(
        **head([plant, model], command),
        verdict=StandVerdict(
            stands=s.stands,
            left_after=s.left_after,
            tool_threshold=STILL,
            joint_threshold=s.still_angle,
            reason=reason(s),
        ),
        summary=[verdict(s), *summarize(s)],
        plant=model_value(plant),
        torque_model=model_value(model),
        alignment=alignment_value(s.pair.alignment),
        integration=IntegratorValue(
            engine=m.name,
            version=m.version,
            integrator=m.integrator,
            step=m.dt,
            repaired=list(m.repaired),
        ),
        held=s.held,
        seconds=s.seconds,
        stopped=s.motion.stopped,
        start=vector(s.motion.q[0]),
        torques=[
            JointHold(
                joint=joint.name,
                given=float(s.given[i]),
                needed=float(s.needed[i]),
                effort_limit=joint.limits.known_effort,
            )
            for i, joint in enumerate(plant.joints)
        ],
        growth_rate=float(s.growth),
        energy=EnergyValue(error_max=s.energy.worst, exchanged=s.energy.turned_over),
        motion=_motion(s),
    )


def _motion(s: StaticHold) -> MotionValue:
    count = len(s.motion.t)
    k = np.unique(np.linspace(0, count - 1, min(count, _INSTANTS)).round().astype(int))
    return MotionValue(
        t=vector(s.motion.t[k]),
        q=[vector(row) for row in s.motion.q[k]],
        qd=[vector(row) for row in s.motion.qd[k]],
        tool_drift=vector(s.tool_drift[k]),
        work=vector(s.motion.work[k]),
        energy_error=vector(s.energy.error[k]),
    )
