"""`simulate` as ur5check.simulation/1.  Every field is documented in docs/json.md."""

from __future__ import annotations

import numpy as np

from .._simulation.static_hold import STILL, StaticHold
from .json_head import json_head
from .json_values import Report, alignment_value, model_value, strict
from .simulate_summary import reason, summarize, verdict

__all__ = ["simulate_json"]

_INSTANTS = 501  # at most, evenly picked: enough for a plot


def simulate_json(s: StaticHold, *, command: str = "") -> Report:
    """The report of `ur5check simulate`."""
    plant, model, m = s.pair.a, s.pair.given_b, s.mover
    return strict(
        {
            **json_head("simulation", [plant, model], command),
            "verdict": {
                "stands": s.stands,
                "left_after": s.left_after,
                "tool_threshold": STILL,
                "joint_threshold": s.still_angle,
                "reason": reason(s),
            },
            "summary": [verdict(s), *summarize(s)],
            "plant": model_value(plant),
            "torque_model": model_value(model),
            "alignment": alignment_value(s.pair.alignment),
            "mover": {
                "name": m.name,
                "version": m.version,
                "integrator": m.integrator,
                "step": m.dt,
                "repaired": m.repaired,
            },
            "held": s.held,
            "seconds": s.seconds,
            "stopped": s.motion.stopped,
            "start": s.motion.q[0],
            "torques": [
                {
                    "joint": joint.name,
                    "given": s.given[i],
                    "needed": s.needed[i],
                    "effort_limit": joint.limits.known_effort,
                }
                for i, joint in enumerate(plant.joints)
            ],
            "growth_rate": s.growth,
            "energy": {
                "error_max": s.energy.worst,
                "turned_over": s.energy.turned_over,
            },
            "motion": _motion(s),
        }
    )


def _motion(s: StaticHold) -> Report:
    count = len(s.motion.t)
    k = np.unique(np.linspace(0, count - 1, min(count, _INSTANTS)).round().astype(int))
    return {
        "t": s.motion.t[k],
        "q": s.motion.q[k],
        "qd": s.motion.qd[k],
        "tool_drift": s.tool_drift[k],
        "work": s.motion.work[k],
        "energy_error": s.energy.error[k],
    }
