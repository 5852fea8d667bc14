"""ur5check: find the wrong numbers in a robot arm's dynamics model.

    import ur5check
    tau = ur5check.rnea("paper", q, qd, qdd, gravity=(0, 0, -9.81))
    print(ur5check.explain(ur5check.diff("a.urdf", "b.urdf")).to_text())

Everything public is here, in `ur5check.results` (the types of results), `ur5check.strategies`
(Hypothesis strategies) and `ur5check.testing` (the conformance suite for engines); docs/api.md says
what that promises.  Names are imported when they are first used: `import ur5check` loads no engine.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._version import __version__

if TYPE_CHECKING:
    from ._comparison.arm_pair import pair_up
    from ._comparison.attribution import attribute
    from ._comparison.attribution_detail import by_parameter as attribute_by_parameter
    from ._comparison.attribution_detail import by_term as attribute_by_term
    from ._comparison.diagnosis.diagnosis import diagnose
    from ._comparison.difference import diff
    from ._comparison.explanation import explain
    from ._comparison.identifiability.equivalence import equivalence
    from ._comparison.identifiability.identifiability import identify
    from ._comparison.plausibility.plausibility import plausibility
    from ._comparison.rounding.error_budget import budget as error_budget
    from ._comparison.worst_case.worst_case import worst_cases
    from ._dynamics.compiled.jax_function import jax_rnea
    from ._dynamics.compiled.kernel import (
        compile,  # noqa: A004 - the usual word
        compile_difference,
    )
    from ._dynamics.equations import (
        coriolis_matrix,
        forward_dynamics,
        gravity_torque,
        kinetic_energy,
        mass_matrix,
        potential_energy,
    )
    from ._dynamics.kinematics import forward_kinematics, link_frames
    from ._dynamics.recursion import rnea
    from ._dynamics.regressor import torque_regressor
    from ._dynamics.symbolic.derivation import derive
    from ._dynamics.symbolic.to_python import to_python
    from ._dynamics.symbolic.to_sympy import expressions as sympy_matrix
    from ._dynamics.symbolic.trace import trace
    from ._engines.audit.engine_comparison import compare_engines
    from ._engines.audit.fleet_comparison import compare_fleet
    from ._engines.known_issues import known_issues_of, repaired_text
    from ._engines.registry import installed as installed_engines
    from ._engines.registry import make_engine, steppers
    from ._errors import EngineError, InputError, ModelError, StateError, Ur5checkError, UsageError
    from ._finding import Finding, Place
    from ._io.example_robots import FLEET as EXAMPLE_ROBOTS
    from ._io.loading import load
    from ._io.robot_loading import load_robot
    from ._logs.comparison import compare_recording
    from ._logs.friction import FrictionModel
    from ._logs.options import RecordingOptions
    from ._paper.cases import case as paper_case
    from ._paper.figures.case_figure import draw_case
    from ._paper.figures.case_overview import draw_overview
    from ._paper.reproduction import reproduce
    from ._reports.difference_summary import contribution_in_words
    from ._reports.explanation_summary import equivalence_in_words
    from ._reports.mistake_sentences import advice as mistake_advice
    from ._reports.mistake_sentences import details as mistake_details
    from ._reports.mistake_sentences import remark as mismatch_sentence
    from ._reports.mistake_sentences import sentence as mistake_sentence
    from ._reports.rounding_sentences import rounding_in_words
    from ._robot.inertia import PARAMETERS, Inertia
    from ._robot.robot import Robot
    from ._robot.robot_tree import RobotTree
    from ._robot.serial_arm import Joint, Limits, Link, SerialArm
    from ._robot.states import States, random_states
    from ._robot.transforms import Transform
    from ._simulation.control.computed_torque import ComputedTorque, effort_limits
    from ._simulation.control.error_dynamics import poles
    from ._simulation.control.feedback_law import FeedbackLaw
    from ._simulation.control.gains import Gains
    from ._simulation.control.tracking import track
    from ._simulation.control.trajectory import Quintic
    from ._simulation.convergence import convergence
    from ._simulation.static_hold import stand as static_hold
    from ._sweep.sweep import sweep
    from ._validation.judgement import judge
    from ._validation.validation import validate

#: Where each public name is defined: the module, and the name there if it is another.
_DEFINED_IN = {
    "ComputedTorque": "._simulation.control.computed_torque",
    "EXAMPLE_ROBOTS": "._io.example_robots:FLEET",
    "EngineError": "._errors",
    "FrictionModel": "._logs.friction",
    "FeedbackLaw": "._simulation.control.feedback_law",
    "Finding": "._finding",
    "Gains": "._simulation.control.gains",
    "Inertia": "._robot.inertia",
    "InputError": "._errors",
    "Joint": "._robot.serial_arm",
    "Limits": "._robot.serial_arm",
    "Link": "._robot.serial_arm",
    "ModelError": "._errors",
    "RecordingOptions": "._logs.options",
    "PARAMETERS": "._robot.inertia",
    "Place": "._finding",
    "Quintic": "._simulation.control.trajectory",
    "Robot": "._robot.robot",
    "RobotTree": "._robot.robot_tree",
    "SerialArm": "._robot.serial_arm",
    "StateError": "._errors",
    "States": "._robot.states",
    "Transform": "._robot.transforms",
    "Ur5checkError": "._errors",
    "UsageError": "._errors",
    "attribute": "._comparison.attribution",
    "attribute_by_parameter": "._comparison.attribution_detail:by_parameter",
    "attribute_by_term": "._comparison.attribution_detail:by_term",
    "compare_engines": "._engines.audit.engine_comparison",
    "compare_fleet": "._engines.audit.fleet_comparison",
    "compare_recording": "._logs.comparison",
    "compile": "._dynamics.compiled.kernel",
    "compile_difference": "._dynamics.compiled.kernel",
    "contribution_in_words": "._reports.difference_summary",
    "convergence": "._simulation.convergence",
    "coriolis_matrix": "._dynamics.equations",
    "derive": "._dynamics.symbolic.derivation",
    "diagnose": "._comparison.diagnosis.diagnosis",
    "diff": "._comparison.difference",
    "draw_case": "._paper.figures.case_figure",
    "draw_overview": "._paper.figures.case_overview",
    "effort_limits": "._simulation.control.computed_torque",
    "equivalence": "._comparison.identifiability.equivalence",
    "equivalence_in_words": "._reports.explanation_summary",
    "error_budget": "._comparison.rounding.error_budget:budget",
    "explain": "._comparison.explanation",
    "forward_dynamics": "._dynamics.equations",
    "forward_kinematics": "._dynamics.kinematics",
    "gravity_torque": "._dynamics.equations",
    "identify": "._comparison.identifiability.identifiability",
    "installed_engines": "._engines.registry:installed",
    "jax_rnea": "._dynamics.compiled.jax_function",
    "kinetic_energy": "._dynamics.equations",
    "known_issues_of": "._engines.known_issues",
    "link_frames": "._dynamics.kinematics",
    "judge": "._validation.judgement",
    "load": "._io.loading",
    "load_robot": "._io.robot_loading",
    "make_engine": "._engines.registry",
    "mass_matrix": "._dynamics.equations",
    "mismatch_sentence": "._reports.mistake_sentences:remark",
    "mistake_advice": "._reports.mistake_sentences:advice",
    "mistake_details": "._reports.mistake_sentences:details",
    "mistake_sentence": "._reports.mistake_sentences:sentence",
    "pair_up": "._comparison.arm_pair",
    "paper_case": "._paper.cases:case",
    "plausibility": "._comparison.plausibility.plausibility",
    "poles": "._simulation.control.error_dynamics",
    "potential_energy": "._dynamics.equations",
    "random_states": "._robot.states",
    "repaired_text": "._engines.known_issues",
    "reproduce": "._paper.reproduction",
    "rnea": "._dynamics.recursion",
    "rounding_in_words": "._reports.rounding_sentences",
    "static_hold": "._simulation.static_hold:stand",
    "steppers": "._engines.registry",
    "sweep": "._sweep.sweep",
    "sympy_matrix": "._dynamics.symbolic.to_sympy:expressions",
    "to_python": "._dynamics.symbolic.to_python",
    "torque_regressor": "._dynamics.regressor",
    "trace": "._dynamics.symbolic.trace",
    "track": "._simulation.control.tracking",
    "validate": "._validation.validation",
    "worst_cases": "._comparison.worst_case.worst_case",
}

__all__ = [
    "EXAMPLE_ROBOTS",
    "PARAMETERS",
    "ComputedTorque",
    "EngineError",
    "FeedbackLaw",
    "Finding",
    "FrictionModel",
    "Gains",
    "Inertia",
    "InputError",
    "Joint",
    "Limits",
    "Link",
    "ModelError",
    "Place",
    "Quintic",
    "RecordingOptions",
    "Robot",
    "RobotTree",
    "SerialArm",
    "StateError",
    "States",
    "Transform",
    "Ur5checkError",
    "UsageError",
    "__version__",
    "attribute",
    "attribute_by_parameter",
    "attribute_by_term",
    "compare_engines",
    "compare_fleet",
    "compare_recording",
    "compile",
    "compile_difference",
    "contribution_in_words",
    "convergence",
    "coriolis_matrix",
    "derive",
    "diagnose",
    "diff",
    "draw_case",
    "draw_overview",
    "effort_limits",
    "equivalence",
    "equivalence_in_words",
    "error_budget",
    "explain",
    "forward_dynamics",
    "forward_kinematics",
    "gravity_torque",
    "identify",
    "installed_engines",
    "jax_rnea",
    "judge",
    "kinetic_energy",
    "known_issues_of",
    "link_frames",
    "load",
    "load_robot",
    "make_engine",
    "mass_matrix",
    "mismatch_sentence",
    "mistake_advice",
    "mistake_details",
    "mistake_sentence",
    "pair_up",
    "paper_case",
    "plausibility",
    "poles",
    "potential_energy",
    "random_states",
    "repaired_text",
    "reproduce",
    "rnea",
    "rounding_in_words",
    "static_hold",
    "steppers",
    "sweep",
    "sympy_matrix",
    "to_python",
    "torque_regressor",
    "trace",
    "track",
    "validate",
    "worst_cases",
]


def __getattr__(name: str) -> Any:
    if name not in _DEFINED_IN:
        raise AttributeError(f"module 'ur5check' has no attribute {name!r}")
    module, _, other = _DEFINED_IN[name].partition(":")
    value = getattr(import_module(module, __name__), other or name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*__all__, *globals()])
