"""The registry is what the files of `adapters` declare, and imports no engine."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from ur5check._engines import adapters, registry
from ur5check._engines.adapters.ur5check_recursion import RecursionEngine
from ur5check._engines.conformance_arms import as_value
from ur5check._engines.engine_entry import EngineEntry
from ur5check._engines.lazy_import import lazy_import
from ur5check._engines.registry import (
    READERS,
    REFERENCE,
    REGISTRY,
    engine_class,
    make_engine,
    steppers,
)
from ur5check._errors import EngineError, UsageError

NEW_ENGINE = """\
from ur5check._engines.adapters.ur5check_recursion import RecursionEngine
from ur5check._engines.engine_entry import EngineEntry
from ur5check._engines.known_issue import KnownIssue


class NewEngine(RecursionEngine):
    name = "New"


ISSUE = KnownIssue(
    id="new-loses-friction", engine="new", measured="1", kinds=("damping", "friction"),
    harmful=False, title="t", explanation="e", fix="f",
)
ENTRY = EngineEntry(key="new", title="New", order=99, make=NewEngine, known_issues=(ISSUE,))
"""


def test_every_file_of_adapters_is_in_the_registry_with_the_reference_first():
    files = {file.stem for file in Path(adapters.__path__[0]).glob("*.py")} - {"__init__"}
    assert len(files) == len(READERS)
    assert next(iter(REGISTRY)) == REFERENCE == "ur5check"
    assert set(READERS) - set(REGISTRY) == {"gazebo"}
    assert [entry.order for entry in READERS.values()] == sorted(
        {entry.order for entry in READERS.values()}
    )


def test_an_engine_is_added_by_one_file(tmp_path):
    """A process that finds one more file among the adapters has it in registry and commands."""
    (tmp_path / "new.py").write_text(NEW_ENGINE)
    program = (
        f"from ur5check._engines import adapters; adapters.__path__.append({str(tmp_path)!r})\n"
        "from ur5check._engines.known_issues import known_issue_for\n"
        "from ur5check._simulation.static_hold import ENGINES\n"
        "print(ENGINES[-1], known_issue_for('new', 'friction').id)\n"
        "from ur5check._cli.main import main\n"
        "import sys; sys.exit(main('engines paper --with new --samples 5 --quiet'.split()))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("new new-loses-friction\n")
    assert "New" in done.stdout.partition("\n")[2]


def test_known_issues_stand_with_their_reader_and_have_ids_of_their_own():
    issues = [(key, one) for key, entry in READERS.items() for one in entry.known_issues]
    assert all(one.engine == key and one.id.startswith(f"{key}-") for key, one in issues)
    assert len({one.id for _, one in issues}) == len(issues) > 20


def test_engines_that_step_are_found_by_what_they_can_do(monkeypatch):
    assert steppers() == ("ur5check", "mujoco", "dart")

    class NoStep:
        """Names integrators, and has no step."""

        integrators = {"euler": 1}  # noqa: RUF012 - as a careless adapter would

    entry = EngineEntry(key="nostep", title="No step", order=99, make=NoStep)
    monkeypatch.setitem(registry.REGISTRY, "nostep", entry)
    assert "nostep" not in steppers()


def test_an_engine_that_is_not_installed_names_its_extra(monkeypatch):
    absent = EngineEntry(
        key="absent",
        title="Absent",
        order=99,
        make=RecursionEngine,
        module=lazy_import("no_such_module"),
        distribution="no-such-thing",
        extra="absent",
    )
    monkeypatch.setitem(registry.REGISTRY, "absent", absent)
    assert "absent" not in registry.installed()
    with pytest.raises(EngineError, match=r"Absent .* pip install 'ur5check\[absent\]'"):
        engine_class("absent")
    with pytest.raises(UsageError, match="'gazebo'; choose from ur5check, pinocchio"):
        make_engine("gazebo", as_value())


def test_a_made_engine_has_the_arm_and_the_gravity():
    arm, g = as_value(), (1.0, 2.0, 3.0)
    made = make_engine("ur5check", arm, g).gravity_torque(np.ones(arm.n))
    np.testing.assert_array_equal(made, RecursionEngine(arm, g).gravity_torque(np.ones(arm.n)))
    assert np.abs(made - RecursionEngine(arm).gravity_torque(np.ones(arm.n))).max() > 1.0
