"""Write the JSON schema of the reports: `python docs/generate_schema.py`."""

from __future__ import annotations

from pathlib import Path

import ur5check
from ur5check._reports.json_schema import schema_text

SCHEMA = Path(ur5check.__file__).parent / "schemas" / "report.schema.json"

if __name__ == "__main__":
    SCHEMA.parent.mkdir(exist_ok=True)
    SCHEMA.write_text(schema_text(), encoding="utf-8")
