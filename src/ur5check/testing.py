"""The conformance suite that every engine passes, for an engine of your own.

    import pytest
    from ur5check import testing

    @pytest.mark.parametrize("law", testing.LAWS, ids=lambda law: law.id)
    @pytest.mark.parametrize("case", testing.CASES, ids=lambda case: case.name)
    def test_my_engine(case, law):
        testing.check(MyEngine, case, law)

`MyEngine(arm, gravity)` must follow the protocol `ur5check.results.Engine`.

And every rule for models, in a test of your own: `parametrize_with_rules`.
"""

from ._engines.conformance import CASES, LAWS, Case, Law, check, violations
from ._pytest.rule_parameters import parametrize_with_rules

__all__ = ["CASES", "LAWS", "Case", "Law", "check", "parametrize_with_rules", "violations"]
