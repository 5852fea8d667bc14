"""All rules, collected from the package's files whose names end in `_rules`: one file a family."""

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
    root = Path(__file__).parents[1]
    for file in sorted(root.rglob("*_rules.py")):
        module = ".".join([root.name, *file.relative_to(root).with_suffix("").parts])
        for rule in import_module(module).RULES:
            if rule.id in rules:
                raise ValueError(f"rule {rule.id} is registered twice")
            rules[rule.id] = rule
    return dict(sorted(rules.items()))


def rule_of(rule_id: str) -> Rule:
    """One rule by its id.  Raises KeyError for an id that no rule has."""
    return all_rules()[rule_id]
