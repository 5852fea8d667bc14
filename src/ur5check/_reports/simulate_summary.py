"""The result of a static hold in sentences, the verdict first."""

from __future__ import annotations

import numpy as np

from .._simulation.static_hold import STILL, StaticHold

__all__ = ["reason", "summarize", "verdict"]


def verdict(s: StaticHold) -> str:
    """Stands or moves, in one sentence."""
    plant, model = s.pair.a.label, s.pair.b.label
    how = "held constant" if s.held else "recomputed at every step"
    torques = f"the torques that hold {model}, {how}"
    if s.stands:
        return f"{plant} stands for {s.seconds:g} s under {torques}."
    return f"{plant} moves under {torques}: {_left(s)}."


def summarize(s: StaticHold) -> list[str]:
    """Main results, one sentence each."""
    return [
        line for line in (_torque(s), _drift(s), _ended(s), _instability(s), _energy(s)) if line
    ]


def reason(s: StaticHold) -> str:
    """The reason of the thresholds."""
    return (
        f"It stands if the tool stays within {1e3 * STILL:g} mm, the repeatability on a UR5's data "
        f"sheet, and each joint within {np.degrees(s.still_angle):.2g}°, which moves the tool of "
        "the stretched arm by as much."
    )


def _left(s: StaticHold) -> str:
    if s.tool_left_after is not None:
        return f"its tool has moved by {1e3 * STILL:g} mm after {_time(s.tool_left_after)}"
    angle = f"{np.degrees(s.still_angle):.2g}°"
    return f"a joint has turned by more than {angle} after {_time(s.left_after or 0.0)}"


def _time(seconds: float) -> str:
    return f"{1e3 * seconds:.1f} ms" if seconds < 1.0 else f"{seconds:.2f} s"


def _torque(s: StaticHold) -> str:
    gap = s.given - s.needed
    worst = int(np.abs(gap).argmax())
    if s.stands and np.abs(gap).max() <= 1e-9 * max(1.0, np.abs(s.needed).max()):
        return "At the start the applied torques are those needed, to rounding."
    turned = ", the wrong sign" if s.given[worst] * s.needed[worst] < 0.0 else ""
    return (
        f"At the start joint {worst + 1} is given {s.given[worst]:+.2f} N m and needs "
        f"{s.needed[worst]:+.2f} N m{turned}."
    ).replace("-", "−")


def _drift(s: StaticHold) -> str:
    joints = np.degrees(np.abs(s.joint_drift[-1]))
    worst = int(joints.argmax())
    return (
        f"At {s.motion.t[-1]:.3g} s the tool is {_millimetres(s.tool_drift[-1])} from its "
        f"start, and joint {worst + 1} has turned by {joints[worst]:.3g}°."
    )


def _ended(s: StaticHold) -> str:
    if not s.motion.stopped:
        return ""
    limits = [joint.limits for joint in s.pair.a.joints]
    ends = [
        min(
            np.inf if limit.lower is None else abs(q - limit.lower),
            np.inf if limit.upper is None else abs(q - limit.upper),
        )
        for q, limit in zip(s.motion.q[-1], limits, strict=True)
    ]
    where = int(np.argmin(ends))
    what = "its limit" if np.isfinite(ends[where]) else "a full turn"
    return (
        f"Then joint {where + 1} has reached {what}, and the simulation ends: a real arm would "
        "have met its stop."
    )


def _instability(s: StaticHold) -> str:
    if not s.held or s.growth == 0.0:
        return ""
    return (
        "Under constant torques this posture is an unstable equilibrium: any error grows by a "
        f"factor e every {1.0 / s.growth:.2f} s."
    )


def _energy(s: StaticHold) -> str:
    part = "" if s.stands else f" ({s.energy.relative:.0e} of the energy exchanged)"
    return (
        f"Energy error: at most {s.energy.worst:.2g} J{part}, the error of "
        f"{s.mover.name}'s integrator."
    )


def _millimetres(metres: float) -> str:
    return f"{1e3 * metres:.3g} mm"
