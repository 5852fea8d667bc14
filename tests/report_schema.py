"""The schema of JSON reports that ships with the package, and reading a report by it."""

from __future__ import annotations

import json
from typing import Any

import jsonschema
import msgspec

from repository import REPOSITORY
from ur5check._reports.json_schema import REPORTS

FILE = REPOSITORY / "src" / "ur5check" / "schemas" / "report.schema.json"
SCHEMA = json.loads(FILE.read_text(encoding="utf-8"))
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def read_report(text: str) -> dict[str, Any]:
    """A report from its text.

    Raises an error for what strict JSON does not have, what the schema does not allow, and what is
    not of the report's type.
    """

    def refuse(name: str) -> None:
        raise AssertionError(f"{name} is not JSON")

    value = json.loads(text, parse_constant=refuse)
    VALIDATOR.validate(value)
    names = {report.__struct_config__.tag: report for report in REPORTS}
    msgspec.json.decode(text, type=names[value["schema"]])
    return dict(value)
