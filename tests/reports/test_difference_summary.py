"""A difference in a few sentences."""

from __future__ import annotations

import numpy as np
import pytest

import ur5check
from ur5check._reports.difference_summary import base_in_words, summarize
from ur5check._robot import Transform


def summary(a, b, **options):
    return summarize(ur5check.diff(a, b, samples=500, **options))


def test_paper_against_appendix():
    verdict, geometry, contributions, others, residual = summary("paper", "appendix")
    assert others.startswith("Also different: ")
    assert "different torques" in verdict
    assert "turned by 180° about z" in geometry
    assert "joint angles unchanged" in geometry
    assert contributions.startswith("Attributed to link 2, centre of mass")
    assert "The attribution is complete" in residual


def test_the_listing_against_the_paper():
    sentences = summary("paper-listing", "paper")
    assert (
        "links 2 (0.425 m), 3 (0.3922 m) and 5 (0.09465 m) reach the opposite way" in sentences[1]
    )
    assert "9.806 against 9.81" in sentences[2]
    assert "geometry 100%" in sentences[3]


def test_the_librarys_ur5_against_the_appendix():
    sentences = summary("erd-ur5", "appendix")
    assert "link 5, tensor" in sentences[2]
    assert "principal moments of link 6 are 256 times apart" in sentences[3]


def test_an_arm_and_itself_have_the_same_dynamics():
    assert "have the same dynamics" in summary("appendix", "appendix")[0]


@pytest.mark.parametrize(
    ("T", "words"),
    [
        (Transform.identity(), "the same"),
        (Transform.rotation((0, 0, 1), np.pi), "turned by 180° about z"),
        (Transform.rotation((0, 0, 1), -np.pi / 2), "turned by 90° about −z"),
        (Transform.rotation((0.6, 0, 0.8), 1.0), "turned by 57.3° about (0.6, 0, 0.8)"),
        (Transform.translation((0, 0, 0.1)), "shifted by (0, 0, 100) mm"),
    ],
)
def test_base_transforms_in_words(T, words):
    assert base_in_words(T) == words
