"""Bad input and usage: one line on stderr, nothing on stdout, exit code 2."""

from __future__ import annotations

import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from ur5check._cli.main import main

if TYPE_CHECKING:
    from .conftest import Command


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("dif",), "no command is called 'dif'; did you mean 'diff'?"),
        (("--completion", "fish"), "--completion takes one of bash, zsh, tcsh"),
        (("--no-such-option",), "see `ur5check --help`"),
        (("diff", "paper"), "required: B; see `ur5check diff --help`"),
        (("validate", "--sample", "3"), "unrecognized arguments: --sample"),
        (("validate", "papr"), "did you mean 'paper'?"),
        (("validate", "no/such.urdf"), "no such file"),
        (("validate", "--samples", "0"), "samples must be a whole number of at least 1, not 0"),
        (("validate", "--samples", "many"), "'many' is not a whole number"),
        (("validate", "--seed", "-1"), "seed must be a whole number of at least 0, not -1"),
        (("diff", "paper", "appendix", "--gravity", "0", "0", "nan"), "three finite numbers"),
        (("diff", "paper", "appendix", "--gravity", "0", "0"), "expected 3 arguments"),
        (("show", "paper", "--base", "x"), "leave it out"),
        (("validate", "--base", "x"), "--base has no meaning with 2 models; use --base-a"),
        (("validate", "paper", "--tip-b", "x"), "--tip-b has no meaning with 1 model; use --tip"),
        (("validate", *["paper"] * 3, "--tip", "x"), "--tip has no meaning with 3 models"),
        (("show", "appendix", "--arg", "limited"), "write --arg NAME:=VALUE"),
        (("show", "appendix", "--arg", "a:=1", "--arg", "a:=2"), "given twice"),
        (("show", "appendix", "--package", "=x"), "write --package NAME=VALUE"),
        (("show", "paper", "--arg", "limited:=true"), "none of the models is a xacro"),
        (("expand", "paper"), "is a DH table"),
        (("expand", "erd-ur5", "--arg", "limited:=true"), "--arg has no meaning for erd-ur5"),
        (("expand", "papr"), "did you mean 'paper'?"),
        (("expand", "no/such.xacro"), "no such file"),
        (("expand", "no/such.urdf"), "No such file"),
    ],
)
def test_one_line_says_what_is_wrong(
    ur5check: Command, arguments: tuple[str, ...], said: str
) -> None:
    code, out, err = ur5check(*arguments)
    *progress, line = err.splitlines()
    assert (code, out) == (2, "")
    assert line.startswith("ur5check: error: ")
    assert said in line
    assert all(earlier.startswith("ur5check: ") and "error" not in earlier for earlier in progress)


def test_too_many_states_for_the_memory(ur5check: Command) -> None:
    code, out, err = ur5check("diff", "paper", "paper", "--samples", 10**15)
    assert (code, out) == (2, "")
    assert err.splitlines()[-1].endswith("use fewer --samples")


def test_a_reader_that_goes_away_is_no_error() -> None:
    command = [sys.executable, "-m", "ur5check", "expand", "appendix"]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.close()
        assert process.stderr.read() == ""
    assert process.returncode == 141


def test_a_full_disk_is_said() -> None:
    with open("/dev/full", "w") as full:  # noqa: PTH123 - a device
        command = [sys.executable, "-m", "ur5check", "show", "paper"]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr == "ur5check: error: stdout cannot be written: No space left on device\n"


def test_interruption(ur5check: Command) -> None:
    """SIGINT while a command works, as Ctrl-C sends it."""
    started = "from ur5check._cli.main import main; raise SystemExit(main())"
    with subprocess.Popen(
        [sys.executable, "-c", started, "validate", "--samples", "300000"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stderr is not None
        for line in process.stderr:
            if "reading" in line:
                process.send_signal(2)
                break
        out, err = process.communicate(timeout=60)
    assert (process.returncode, out) == (130, "")
    assert err.splitlines()[-1] == "ur5check: error: interrupted"


def test_main_reads_the_command_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["ur5check", "--version"])
    assert main() == 0
    assert capsys.readouterr().out.startswith("ur5check ")
