"""The rules as parameters of a test function of one's own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from .._errors import UsageError

if TYPE_CHECKING:
    import pytest

    from .request import PluginRequest

__all__ = ["RuleCheck", "parametrize_with_rules"]


@dataclass(frozen=True)
class RuleCheck:
    """One rule.  Calling it with the model raises AssertionError where the model breaks it."""

    request: PluginRequest
    rule: str

    def __call__(self, model: str | Path) -> None:
        """Raises AssertionError, or what pytest's xfail raises."""
        from .rule_check import check_rule

        check_rule(self.request.verdict(model), self.rule)


def parametrize_with_rules(models: Sequence[str | Path]) -> pytest.MarkDecorator:
    """A pytest mark that runs a test for each model and rule.

    The test takes `model` and `check`, and calls `check(model)`, which fails for a finding at or
    above the project's fail level; one that the project accepts (`ur5check.toml`) is an expected
    failure with its reason.

    Parameters
    ----------
    models : sequence of str or path
        Files of models.

    Returns
    -------
    pytest.MarkDecorator

    Raises
    ------
    UsageError
        For anything but a sequence of paths of which at least one is given.

    Examples
    --------
    >>> from ur5check.testing import parametrize_with_rules
    >>> @parametrize_with_rules(["my_arm.urdf"])
    ... def test_my_arm(model, check):
    ...     check(model)
    """
    import pytest

    from .._validation.configuration import find_configuration
    from .._validation.rule_outcomes import rules_asked
    from .request import PluginRequest

    if isinstance(models, str | Path) or not models:
        raise UsageError(f"models must be a sequence of paths, not {models!r:.80}")
    parameters = []
    for model in models:
        if not isinstance(model, str | Path):
            raise UsageError(f"models must be paths, not {model!r:.80}")
        file = Path(model)
        configuration = find_configuration(file.resolve().parent)
        request = PluginRequest((file,), None, (), configuration, Path.cwd())
        for rule in rules_asked(str(file), configuration):
            name = f"{file.name}-{rule.id}-{rule.name}"
            parameters.append(pytest.param(model, RuleCheck(request, rule.id), id=name))
    return pytest.mark.parametrize(("model", "check"), parameters)
