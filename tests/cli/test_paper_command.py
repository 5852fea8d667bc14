"""`ur5check paper`: reports, pictures, and what it refuses before any work is done."""

from __future__ import annotations

import builtins
import json
import re
from pathlib import Path
from typing import Any

import pytest

from ur5check._cli.main import main
from ur5check._paper import reproduction as reproduction_module
from ur5check._paper.reproduction import Reproduction


@pytest.fixture
def reproduced(monkeypatch: pytest.MonkeyPatch, reproduction: Reproduction) -> None:
    """The result of the other tests: only its report is tested here."""
    monkeypatch.setattr(reproduction_module, "reproduce", lambda progress=None: reproduction)


def test_it_runs_from_end_to_end(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["paper", "--format", "json"]) == 0
    said = capsys.readouterr()
    report = json.loads(said.out)
    assert report["command"] == "ur5check paper"
    assert report["verdict"]["trustworthy"]
    assert all(line.startswith("ur5check: ") for line in said.err.splitlines())
    assert "running 9 cases for 5 models" in said.err


@pytest.mark.usefixtures("reproduced")
def test_formats(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert main(["paper", "--quiet"]) == 0
    said = capsys.readouterr()
    assert said.out.startswith("The paper, claim by claim\n\nREPRODUCED: ")
    assert said.err == ""
    target = tmp_path / "paper.md"
    assert main(["paper", "--quiet", "-o", str(target)]) == 0
    assert target.read_text("utf-8").startswith("# The paper, claim by claim\n")
    assert "Every claim, model by model" in target.read_text("utf-8")


@pytest.mark.usefixtures("reproduced")
def test_a_report_finds_its_pictures_from_where_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "reports").mkdir()
    (tmp_path / "pictures").mkdir()
    (tmp_path / "pictures" / "mine.txt").write_text("mine", "utf-8")
    monkeypatch.chdir(tmp_path)
    assert main(["paper", "--quiet", "--figures", "pictures", "-o", "reports/paper.md"]) == 0
    text = Path("reports", "paper.md").read_text("utf-8")
    links = re.findall(r"!\[.*?\]\((.*?)\)", text)
    assert len(links) == 9
    assert all(Path("reports", link).is_file() for link in links)
    assert Path("pictures", "mine.txt").read_text("utf-8") == "mine"


@pytest.mark.parametrize(
    ("figures", "says"),
    [("file", "is no folder; name one"), ("no/such/folder", "make it first")],
)
def test_a_folder_that_cannot_be_is_refused_before_any_work(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, figures: str, says: str
) -> None:
    (tmp_path / "file").write_text("mine", "utf-8")
    assert main(["paper", "--figures", str(tmp_path / figures)]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1
    assert says in said.err
    assert (tmp_path / "file").read_text("utf-8") == "mine"


def test_a_report_never_overwrites_a_model(capsys: pytest.CaptureFixture[str]) -> None:
    from ur5check._io.shipped_models import lookup

    model = lookup("paper").path()
    before = model.read_bytes()
    assert main(["paper", "-o", str(model)]) == 2
    assert "is one of the inputs" in capsys.readouterr().err
    assert model.read_bytes() == before


def test_without_matplotlib_pictures_are_refused_and_say_what_to_install(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = builtins.__import__

    def absent(name: str, *args: Any, **options: Any) -> Any:
        if name.split(".")[0] == "matplotlib":
            raise ImportError(name)
        return real(name, *args, **options)

    monkeypatch.setattr(builtins, "__import__", absent)
    assert main(["paper", "--figures", str(tmp_path / "figures")]) == 2
    assert "pip install 'ur5check[figures]'" in capsys.readouterr().err
    assert not (tmp_path / "figures").exists()
