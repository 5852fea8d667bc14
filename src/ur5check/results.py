"""The types of the results that ur5check's functions return, for annotations and `isinstance`.

Those with a report (`Difference`, `Explanation`, `Validation`, `EngineReport`, `FleetReport`,
`Sweep`, `Reproduction`, `StaticHold`, `RecordingComparison`) have `verdict`, `summary()`,
`to_text()` and `to_json()`, and show themselves in a notebook.
"""

from ._comparison.alignment import Alignment
from ._comparison.arm_pair import Pair
from ._comparison.attribution import Attribution, Contribution
from ._comparison.attribution_detail import TermAttribution
from ._comparison.diagnosis.diagnosis import Diagnosis
from ._comparison.difference import Difference
from ._comparison.explanation import Explanation
from ._comparison.identifiability.equivalence import Equivalence
from ._comparison.identifiability.identifiability import Identifiability
from ._comparison.motion_difference import ToolError, TorqueError
from ._comparison.other_numbers import OtherNumber
from ._comparison.parameter_table import LinkParameters
from ._comparison.rounding.error_budget import ErrorBudget
from ._comparison.torque_band import TorqueBand
from ._comparison.worst_case.worst_case import WorstCase
from ._dynamics.compiled.kernel import DifferenceKernel, Kernel
from ._dynamics.symbolic.derivation import Derivation
from ._dynamics.symbolic.program import Program
from ._engines.audit.engine_comparison import EngineReport, Stage
from ._engines.audit.engine_reading import Reading
from ._engines.audit.fleet_comparison import FleetReport
from ._engines.engine import Engine, ReferenceEngine, Stepper
from ._logs.comparison import RecordingComparison
from ._paper.reproduction import Reproduction
from ._result import Result
from ._robot.robot import Robot
from ._robot.serial_arm import Source
from ._simulation.control.tracking import Tracking
from ._simulation.convergence import Convergence
from ._simulation.static_hold import StaticHold
from ._sweep.sweep_result import Sweep
from ._validation.judgement import Judgement
from ._validation.law import Outcome
from ._validation.validation import ModelValidation, PairValidation, Validation

__all__ = [
    "Alignment",
    "Attribution",
    "Contribution",
    "Convergence",
    "Derivation",
    "Diagnosis",
    "Difference",
    "DifferenceKernel",
    "Engine",
    "EngineReport",
    "Equivalence",
    "ErrorBudget",
    "Explanation",
    "FleetReport",
    "Identifiability",
    "Judgement",
    "Kernel",
    "LinkParameters",
    "ModelValidation",
    "OtherNumber",
    "Outcome",
    "Pair",
    "PairValidation",
    "Program",
    "Reading",
    "RecordingComparison",
    "ReferenceEngine",
    "Reproduction",
    "Result",
    "Robot",
    "Source",
    "Stage",
    "StaticHold",
    "Stepper",
    "Sweep",
    "TermAttribution",
    "ToolError",
    "TorqueBand",
    "TorqueError",
    "Tracking",
    "Validation",
    "WorstCase",
]
