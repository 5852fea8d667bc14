"""A model as a file of test items: one a rule, grouped by family, and the computation."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from .._errors import Ur5checkError
from .._validation.rule_outcomes import rules_asked
from .request import PluginRequest
from .rule_check import ModelFaultError, check_agreement, check_laws, check_rule

__all__ = ["ModelFile"]

#: Raises ModelFaultError; returns what is worth knowing of a check that passes.
Check = Callable[[], str]


class ModelFile(pytest.File):
    """One model."""

    def __init__(self, *, request: PluginRequest, **fields: Any) -> None:
        super().__init__(**fields)
        self.request = request

    def collect(self) -> Iterator[pytest.Collector]:
        """The families of rules, then the laws of the computation, and the comparison."""
        request, model = self.request, self.path
        families: dict[str, dict[str, Check]] = {}
        rules = rules_asked(str(model), request.configuration, engines=bool(request.engines))
        for rule in rules:
            name = f"{rule.id}-{rule.name}"
            families.setdefault(rule.family, {})[name] = _rule(request, model, rule.id)
        families["computation"] = {"laws-of-dynamics": lambda: _laws(request, model)}
        if request.against is not None and Path(request.against).resolve() != model:
            name = f"agrees-with-{Path(request.against).name}"
            families["CMP"] = {name: lambda: _agreement(request, model)}
        for name, checks in families.items():
            yield Family.from_parent(self, name=name, checks=checks)


class Family(pytest.Collector):
    """The rules of one family."""

    def __init__(self, *, checks: dict[str, Check], **fields: Any) -> None:
        super().__init__(**fields)
        self.checks = checks

    def collect(self) -> Iterator[pytest.Item]:
        """One item a rule."""
        for name, check in self.checks.items():
            yield RuleItem.from_parent(self, name=name, check=check)


class RuleItem(pytest.Item):
    """One rule, asked of one model."""

    def __init__(self, *, check: Check, **fields: Any) -> None:
        super().__init__(**fields)
        self.check = check

    def runtest(self) -> None:
        """Raises ModelFaultError, or what pytest's xfail and skip raise."""
        said = self.check()
        if said:
            self.add_report_section("call", "findings below the fail level", said)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """The report of the findings, without a traceback."""
        if isinstance(excinfo.value, ModelFaultError | Ur5checkError):
            return str(excinfo.value).replace(f"{self.config.rootpath}{os.sep}", "")
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, None, str]:
        """The model's file, and the rule."""
        return self.path, None, self.name


def _rule(request: PluginRequest, model: Path, rule: str) -> Check:
    return lambda: check_rule(request.verdict(model), rule)


def _laws(request: PluginRequest, model: Path) -> str:
    check_laws(request.verdict(model))
    return ""


def _agreement(request: PluginRequest, model: Path) -> str:
    pair = request.agreement(model)
    if pair is not None:
        check_agreement(pair)
    return ""
