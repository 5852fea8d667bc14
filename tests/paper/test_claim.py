"""A trial has a limit with two sides; a verdict follows from what is printed and repaired."""

from __future__ import annotations

import pytest

from ur5check._paper.claim import Claim, Trial, judged, overall
from ur5check._paper.paper_models import Form


@pytest.mark.parametrize(
    ("bound", "inside", "edge", "outside"),
    [
        ("at most", 0.9, True, 1.1),
        ("at least", 1.1, True, 0.9),
        ("below", 0.9, False, 1.1),
        ("above", 1.1, False, 0.9),
    ],
)
def test_a_limit_has_two_sides(bound: str, inside: float, edge: bool, outside: float) -> None:
    def holds(value: float) -> bool:
        return Trial("arm", "other", value, 1.0, bound=bound).holds  # type: ignore[arg-type]

    assert holds(inside)
    assert holds(1.0) is edge
    assert not holds(outside)
    assert not holds(float("nan"))


def trial(form: Form, *, holds: bool) -> Trial:
    return Trial(form, form, 0.0 if holds else 2.0, 1.0)


@pytest.mark.parametrize(
    ("printed", "repaired", "verdict", "of_the_repaired"),
    [
        (True, True, "confirmed", "confirmed"),
        (False, True, "confirmed after repair", "confirmed after repair"),
        (False, False, "refuted", "refuted"),
        (True, False, "confirmed", "refuted"),
    ],
)
def test_a_verdict_asks_what_is_printed_then_what_is_repaired(
    printed: bool, repaired: bool, verdict: str, of_the_repaired: str
) -> None:
    claim = Claim("id", "text", "test", "source", "1")
    trials = (trial("printed", holds=printed), trial("repaired", holds=repaired))
    outcomes = judged(claim, trials)
    assert overall(outcomes) == verdict
    assert outcomes[1].verdict == of_the_repaired
    assert [o.holds for o in outcomes] == [printed, repaired]
    assert judged(claim, [*trials, trial("other", holds=True)])[2].verdict == "confirmed"


def test_without_a_repair_what_fails_is_refuted() -> None:
    claim = Claim("id", "text", "test", "source", "1")
    others = (trial("printed", holds=False), trial("other", holds=True))
    assert overall(judged(claim, others)) == "refuted"


def test_a_claim_that_is_put_to_nothing_printed_is_no_claim() -> None:
    claim = Claim("id", "text", "test", "source", "1")
    with pytest.raises(ValueError, match="'id' is not tested on anything that the paper printed"):
        judged(claim, [trial("repaired", holds=True)])
