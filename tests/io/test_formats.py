"""The list of formats: every record leads to what it promises, and the pages follow the list."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

import ur5check
from repository import REPOSITORY
from ur5check._io.formats import FORMATS, SUFFIXES, WRITABLE, format_by_suffix


def test_every_folder_with_a_reader_is_in_the_list() -> None:
    folder = REPOSITORY / "src" / "ur5check" / "_io"
    declared = {
        path.parent.name
        for path in folder.glob("*/__init__.py")
        if "FORMAT = ModelFormat(" in path.read_text(encoding="utf-8")
    }
    assert declared == set(FORMATS)


def test_no_suffix_stands_for_two_formats() -> None:
    assert len(set(SUFFIXES)) == len(SUFFIXES)
    for form in FORMATS.values():
        for suffix in form.suffixes:
            assert format_by_suffix(f"arm{suffix.upper()}") is form
    assert format_by_suffix("arm.step") is None


@pytest.mark.parametrize("kind", WRITABLE)
def test_what_a_format_writes_it_reads_under_each_suffix(kind: str, tmp_path: Path) -> None:
    form, arm = FORMATS[kind], ur5check.load("paper")
    for suffix in form.suffixes:
        file = tmp_path / f"arm{suffix}"
        file.write_text(form.write(arm), encoding="utf-8")
        again = ur5check.load(file)
        assert (again.source.kind, again.n) == (kind, arm.n)
        assert again.links[1].inertia.mass == arm.links[1].inertia.mass


def test_the_list_imports_no_reader() -> None:
    script = (
        "import sys; from ur5check._io.formats import FORMATS; "
        "print(sorted(m for m in sys.modules if m in ('numpy', 'lxml') or m.endswith('_reader')))"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert (done.stdout.strip(), done.stderr) == ("[]", "")


def test_the_page_on_inputs_has_a_row_for_every_format() -> None:
    page = (REPOSITORY / "docs" / "inputs.md").read_text(encoding="utf-8")
    rows = [line for line in page.splitlines() if line.startswith("| a path ending in")]
    listed = [re.findall(r"`(\.\w+)`", row.split("|")[1]) for row in rows]
    assert sorted(map(tuple, listed)) == sorted(form.suffixes for form in FORMATS.values())
    for row, suffixes in zip(rows, listed, strict=True):
        options = set(re.findall(r"`(\w+)`", row.split("|")[3])) - {"packages"}
        form = format_by_suffix(f"arm{suffixes[0]}")
        assert form is not None
        assert options == set(form.options)


def test_the_json_schema_knows_every_kind_of_source() -> None:
    schema = REPOSITORY / "src" / "ur5check" / "schemas" / "report.schema.json"
    text = schema.read_text(encoding="utf-8")
    kinds = [
        set(found) for found in _enums(json.loads(text)) if "pinocchio" in found and "dh" in found
    ]
    assert kinds
    assert all(found == {*FORMATS, "pinocchio", "value"} for found in kinds)


def _enums(value: object) -> list[list[str]]:
    if isinstance(value, list):
        return [found for item in value for found in _enums(item)]
    if not isinstance(value, dict):
        return []
    own = [value["enum"]] if isinstance(value.get("enum"), list) else []
    return own + [found for item in value.values() for found in _enums(item)]
