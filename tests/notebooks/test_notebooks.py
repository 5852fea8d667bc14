"""Every notebook runs from top to bottom in a kernel of its own, and is stored without outputs."""

from __future__ import annotations

from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

from repository import REPOSITORY

FOLDER = REPOSITORY / "notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))

#: How many pictures a notebook draws, and what it must say.
EXPECTED = {
    "01-paper-against-appendix": (
        2,
        (
            "74.5 % above that of the controller's DH",
            "turned by 180° about z",
            "explained to better than 1e-9 N m: True",
        ),
    ),
    "02-explain-a-difference": (
        4,
        (
            "Links 2, 3 and 5 of paper-listing: a sign of the length is lost",
            "cylinder of radius 0.6 m and length 0.12 m",
            "24 hidden directions; torque below 1e-9 N m: True",
        ),
    ),
    "03-nine-cases": (
        4,
        (
            "our recursion and Pinocchio agree on the appendix: True",
            "claims on a shape: 6; all hold as printed: True",
            "as printed, 74.5 % too large and of opposite sign: True",
            "eight arms of nonsense, all sines: True",
            "with these repaired, every case is the controller's: True",
            "of the wrong sign: True",
            "m((3r)² + l²)·0.08333",
        ),
    ),
    "04-closed-form": (
        2,
        (
            "torques of the UR5 in fewer than 560 operations: True",
            "closed form and Pinocchio within 1e-11 N m: True",
            "M_12 = a1*a2*m2*cos(q2) + a2**2*m2",
            "joints 1 to 3 hold more than 99 % of M's squares: True",
        ),
    ),
    "05-control-and-simulation": (
        4,
        (
            "appendix moves under the torques that hold paper-listing",
            "appendix stands for 0.25 s under the torques that hold appendix, held constant. "
            "All three agree: True",
            "each at its order: True",
            "at step zero within 1e-6 rad: True",
            "eqs (22), (23) as printed pole +38.37 / s lost after 0.44 s",
            "repaired tables, the right model nothing: True",
        ),
    ),
    "06-engines": (
        2,
        (
            "ur5check, Pinocchio, Drake and iDynTree agree",
            "DART has added 2 kg",
            "with the fixes within 1e-10 N m: True",
            "all explained: True",
            "16.1 N m too much, 28%",
        ),
    ),
}


def test_there_are_notebooks() -> None:
    assert [path.stem for path in NOTEBOOKS] == list(EXPECTED)


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_is_stored_clean(path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            assert cell.outputs == [], f"{cell.id}: clear all outputs before saving"
            assert cell.execution_count is None, f"{cell.id}: clear all outputs before saving"


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_runs(path: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    # The kernel inherits the environment: no window, and nothing left in the user's folders.
    monkeypatch.setenv("MPLBACKEND", "module://matplotlib_inline.backend_inline")
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path))
    # Threads of a busy machine wait for each other longer than these small matrices take.
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "1")
    notebook = nbformat.read(path, as_version=4)
    client = NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(tmp_path)}})
    client.execute()
    outputs = [out for cell in notebook.cells for out in cell.get("outputs", [])]
    assert not [out for out in outputs if out.get("name") == "stderr"]
    pictures = [out for out in outputs if "image/png" in out.get("data", {})]
    count, sentences = EXPECTED[path.stem]
    assert len(pictures) == count
    said = "".join(out["text"] for out in outputs if out.get("name") == "stdout")
    for sentence in sentences:
        assert sentence in " ".join(said.split()), sentence
