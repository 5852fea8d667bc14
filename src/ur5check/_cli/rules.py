"""List the rules that models are judged by, or explain one: what it checks, why, a bad and a good
example, and what to do.
"""

from __future__ import annotations

import argparse
import textwrap

from .._errors import UsageError
from .options import add_output_options
from .output import check_output, emit

__all__ = ["EXAMPLES", "add_options", "run"]

EXAMPLES = """\
examples:
  ur5check rules
  ur5check rules INE108
  ur5check rules JNT
"""

_WIDTH = 80


def add_options(parser: argparse.ArgumentParser) -> None:
    """What `rules` takes."""
    parser.add_argument("rule", nargs="?", metavar="ID", help="a rule, or a family of rules")
    add_output_options(parser)


def run(args: argparse.Namespace) -> int:
    """Show the list, a family, or one rule."""
    from .._rules.registry import all_rules
    from .._rules.rule import FAMILIES

    check_output(args.output, ())
    rules = all_rules()
    wanted = args.rule or ""
    if wanted in rules:
        emit(_explained(wanted), args.output)
        return 0
    chosen = [rule for rule in rules.values() if rule.id.startswith(wanted)]
    if not chosen:
        families = ", ".join(FAMILIES)
        raise UsageError(f"no rule is called {wanted!r}; give an id or a family: {families}")
    lines = []
    for family, about in FAMILIES.items():
        members = [rule for rule in chosen if rule.family == family]
        if members:
            lines += [f"{family}  {about}"]
            lines += [f"  {rule.id}  {rule.severity:7}  {rule.name}" for rule in members]
    emit("\n".join(lines) + "\n", args.output)
    return 0


def _explained(rule_id: str) -> str:
    from .._rules.registry import rule_of

    rule = rule_of(rule_id)
    parts = [
        ("checks", rule.checks),
        ("why", rule.why),
        ("effect", rule.consequence),
        ("fix", rule.fix),
        ("report", rule.report),
    ]
    lines = [f"{rule.id}  {rule.name}  ({rule.severity})", ""]
    for title, text in parts:
        if text:
            lines += textwrap.wrap(f"{title:8}{text}", _WIDTH, subsequent_indent=" " * 8)
    for title, example in (("refused", rule.bad), ("accepted", rule.good)):
        lines += ["", f"{title}:", *(f"    {line}" for line in example.strip().splitlines())]
    return "\n".join(lines) + "\n"
