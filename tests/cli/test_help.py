"""The help of every command: each option is described, and all fits a terminal of 80 columns."""

from __future__ import annotations

import argparse
from importlib import import_module

import pytest

from ur5check._cli.main import COMMANDS, main
from ur5check._cli.parser import Parser


def parser_of(command: str) -> argparse.ArgumentParser:
    module = import_module(f"ur5check._cli.{command}")
    parser = Parser(prog=command, description=module.__doc__, epilog=module.EXAMPLES)
    module.add_options(parser)
    return parser


@pytest.mark.parametrize("arguments", [[], *([command] for command in COMMANDS)], ids=" ".join)
def test_help_fits_80_columns(arguments, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    assert main([*arguments, "--help"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) > 10
    assert [line for line in lines if len(line) > 80] == []


@pytest.mark.parametrize("command", COMMANDS)
def test_every_option_is_described(command):
    for action in parser_of(command)._actions:
        assert action.help, action.option_strings or action.dest
        assert not action.help.startswith("default"), action.option_strings


@pytest.mark.parametrize("command", COMMANDS)
def test_the_examples_of_a_command_parse(command):
    epilog = parser_of(command).epilog
    assert epilog is not None
    examples = [line.split() for line in epilog.splitlines() if line.startswith("  ur5check ")]
    assert len(examples) >= 2
    for _, name, *arguments in examples:
        assert name == command
        parser_of(command).parse_args(arguments)
