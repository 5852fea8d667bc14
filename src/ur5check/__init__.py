"""ur5check: which number of an arm's dynamics model is wrong, and by how many newton metres.

    import ur5check
    arm = ur5check.load("paper")
    tau = ur5check.rnea(arm, q, qd, qdd, gravity=(0, 0, -9.81))

Names are found when they are first used: `import ur5check` costs nothing and loads no engine.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._version import __version__

if TYPE_CHECKING:
    from ._comparison.difference import diff
    from ._comparison.explanation import explain
    from ._dynamics.compiled.kernel import compile  # noqa: A004 - the word for it
    from ._dynamics.equations import (
        coriolis_matrix,
        forward_dynamics,
        gravity_torque,
        kinetic_energy,
        mass_matrix,
        potential_energy,
    )
    from ._dynamics.kinematics import forward_kinematics
    from ._dynamics.recursion import rnea
    from ._dynamics.regressor import torque_regressor
    from ._engines.audit.engine_comparison import compare_engines
    from ._io.loading import load
    from ._robot.serial_arm import SerialArm
    from ._sweep.sweep import sweep
    from ._validation.validation import validate

_HOMES = {
    "SerialArm": "._robot.serial_arm",
    "compare_engines": "._engines.audit.engine_comparison",
    "compile": "._dynamics.compiled.kernel",
    "coriolis_matrix": "._dynamics.equations",
    "diff": "._comparison.difference",
    "explain": "._comparison.explanation",
    "forward_dynamics": "._dynamics.equations",
    "forward_kinematics": "._dynamics.kinematics",
    "gravity_torque": "._dynamics.equations",
    "kinetic_energy": "._dynamics.equations",
    "load": "._io.loading",
    "mass_matrix": "._dynamics.equations",
    "potential_energy": "._dynamics.equations",
    "rnea": "._dynamics.recursion",
    "sweep": "._sweep.sweep",
    "torque_regressor": "._dynamics.regressor",
    "validate": "._validation.validation",
}

__all__ = [
    "SerialArm",
    "__version__",
    "compare_engines",
    "compile",
    "coriolis_matrix",
    "diff",
    "explain",
    "forward_dynamics",
    "forward_kinematics",
    "gravity_torque",
    "kinetic_energy",
    "load",
    "mass_matrix",
    "potential_energy",
    "rnea",
    "sweep",
    "torque_regressor",
    "validate",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'ur5check' has no attribute {name!r}")
    value = getattr(import_module(_HOMES[name], __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*__all__, *globals()])
