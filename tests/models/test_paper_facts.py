"""The shipped DH files against the paper's tables, number by number.

The tables stand here once more, typed from the paper and not from the files.
"""

from __future__ import annotations

import tomllib
from typing import Any

import pytest

from ur5check._io.shipped_models import SHIPPED_MODELS

JOINTS = ["base", "shoulder", "elbow", "wrist1", "wrist2", "wrist3"]
LINKS = [f"link {i}" for i in range(1, 7)]
D = [0.089159, 0.0, 0.0, 0.10915, 0.09465, 0.0823]
A = [0.0, -0.42500, -0.39225, 0.0, 0.0, 0.0]
ALPHA_OF_TABLE_1 = ["pi/2", 0.0, 0.0, "pi/2", "-pi/2", 0.0]
ALPHA_OF_LISTING = [1.5707, 0.0, 0.0, 1.5707, -1.5707, 0.0]
R_OF_LISTING = [
    [0.0, 0.089159, 0.0],
    [0.42500, 0.0, 0.0],
    [0.39225, 0.0, 0.0],
    [0.0, 0.10915, 0.0],
    [0.0, 0.09465, 0.0],
    [0.0, 0.0, 0.0823],
]
MASS = [3.7000, 8.3930, 2.2750, 1.2190, 1.2190, 0.1879]
COM = [
    [0.0, -0.02561, 0.00193],
    [0.2125, 0.0, 0.11336],
    [0.11993, 0.0, 0.0265],
    [0.0, -0.0018, 0.01634],
    [0.0, 0.0018, 0.01634],
    [0.0, 0.0, -0.001159],
]
IXX = [0.016926823, 0.241988487, 0.035310391, 0.00475391, 0.00475391, 0.000216804]
IZZ = [0.00666, 0.0151074, 0.004095, 0.0021942, 0.0021942, 0.000132117]

both = pytest.mark.parametrize("name", ["paper", "paper-listing"])


def table(name: str) -> dict[str, Any]:
    return tomllib.loads(SHIPPED_MODELS[name].path().read_text("utf-8"))


def column(name: str, key: str) -> list[Any]:
    return [row[key] for row in table(name)["joint"]]


@both
def test_the_file_says_what_it_is(name: str) -> None:
    file = table(name)
    assert file["schema"] == "ur5check.dh/1"
    assert file["name"] == name
    assert file["convention"] == "standard"
    assert file["title"] == SHIPPED_MODELS[name].title.replace("α", "alpha")


@both
@pytest.mark.parametrize(
    ("key", "expected"),
    [("joint", JOINTS), ("link", LINKS), ("d", D), ("a", A), ("mass", MASS), ("com", COM)],
)
def test_the_two_files_share_these_numbers(name: str, key: str, expected: list[Any]) -> None:
    assert column(name, key) == expected


@both
def test_the_tensors_are_the_listings(name: str) -> None:
    expected = [
        {"ixx": across, "iyy": across, "izz": along} for across, along in zip(IXX, IZZ, strict=True)
    ]
    assert column(name, "inertia") == expected


def test_table_1_has_exact_angles() -> None:
    assert column("paper", "alpha") == ALPHA_OF_TABLE_1


def test_the_listing_has_cut_off_angles() -> None:
    assert column("paper-listing", "alpha") == ALPHA_OF_LISTING


def test_the_listing_brings_its_own_vectors_and_table_1_none() -> None:
    assert column("paper-listing", "r") == R_OF_LISTING
    assert not any("r" in row for row in table("paper")["joint"])


def test_only_the_listing_brings_its_own_gravity() -> None:
    assert table("paper-listing")["gravity"] == [0.0, 0.0, -9.806]
    assert "gravity" not in table("paper")


@both
def test_every_number_has_a_source(name: str) -> None:
    for row in table(name)["joint"]:
        assert set(row["source"]) == set(row) - {"joint", "link", "source"}
        assert all(len(sentence.split()) > 3 for sentence in row["source"].values())
