"""All rules, collected from the files of this folder that end in `_rules`: one file a family."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pathlib import Path

from .rule import Rule

__all__ = ["all_rules", "rule_of"]


@cache
def all_rules() -> dict[str, Rule]:
    """Every rule by its id, in order of ids.  Two rules of one id are a defect: ValueError."""
    rules: dict[str, Rule] = {}
    for file in sorted(Path(__file__).parent.glob("*_rules.py")):
        for rule in import_module(f".{file.stem}", __package__).RULES:
            if rule.id in rules:
                raise ValueError(f"rule {rule.id} is registered twice")
            rules[rule.id] = rule
    return dict(sorted(rules.items()))


def rule_of(rule_id: str) -> Rule:
    """One rule by its id.  Raises KeyError for an id that no rule has."""
    return all_rules()[rule_id]
