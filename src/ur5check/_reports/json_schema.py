"""The JSON schema of all reports, derived from their types.

`python docs/generate_schema.py` writes it to `src/ur5check/schemas/report.schema.json`, which ships
with the package.
"""

from __future__ import annotations

import json
from typing import Any

import msgspec

from .derive_json import DeriveReport
from .diff_json import DiffReport
from .engines_fleet_json import EnginesFleetReport
from .engines_json import EnginesReport
from .engines_list_json import EnginesListReport
from .json_report import Report
from .limbs_json import LimbsReport
from .log_json import LogReport
from .paper_json import PaperReport
from .show_json import ShowReport
from .simulate_json import SimulateReport
from .sweep_json import SweepReport
from .validate_json import ValidateReport

__all__ = ["REPORTS", "schema", "schema_text"]

#: The report of each command.
REPORTS: tuple[type[Report], ...] = (
    ValidateReport,
    DiffReport,
    LimbsReport,
    EnginesReport,
    EnginesFleetReport,
    EnginesListReport,
    LogReport,
    PaperReport,
    DeriveReport,
    SweepReport,
    SimulateReport,
    ShowReport,
)


def schema() -> dict[str, Any]:
    """The schema of a report of any command (JSON Schema, draft 2020-12)."""
    reports, components = msgspec.json.schema_components(REPORTS, ref_template="#/$defs/{name}")
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Reports of ur5check",
        "oneOf": list(reports),
        "$defs": components,
    }


def schema_text() -> str:
    """The file of the schema."""
    return json.dumps(schema(), indent=2, ensure_ascii=False) + "\n"
