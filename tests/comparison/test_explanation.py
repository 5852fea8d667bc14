"""An explanation holds what each part finds, each of its own arm."""

from __future__ import annotations

from dataclasses import replace

import pytest

import ur5check


def with_one_impossible_body(arm):
    links = list(arm.links)
    links[1] = replace(links[1], inertia=replace(links[1].inertia, mass=-1.0))
    return replace(arm, links=tuple(links))


@pytest.mark.parametrize("wrong", ["a", "b"])
def test_an_impossible_body_is_reported_for_its_own_arm(wrong):
    arm = ur5check.load("appendix")
    arms = {"a": arm, "b": arm} | {wrong: with_one_impossible_body(arm)}
    e = ur5check.explain(ur5check.diff(arms["a"], arms["b"], samples=50))
    impossible = {
        side: [f.link for f in found if f.severity == "impossible"]
        for side, found in (("a", e.plausible_a), ("b", e.plausible_b))
    }
    assert impossible == {"a": [], "b": []} | {wrong: [2]}
