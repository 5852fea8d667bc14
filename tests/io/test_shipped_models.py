"""The shipped models, by name."""

from __future__ import annotations

import pytest

from ur5check._errors import UsageError
from ur5check._io.shipped_models import SHIPPED_MODELS, ShippedModel, lookup, models_directory

each = pytest.mark.parametrize("entry", SHIPPED_MODELS.values(), ids=list(SHIPPED_MODELS))


def test_these_four_models_ship() -> None:
    assert {entry.name: entry.kind for entry in SHIPPED_MODELS.values()} == {
        "paper": "dh",
        "paper-listing": "dh",
        "appendix": "xacro",
        "erd-ur5": "urdf",
    }


@each
def test_a_model_has_its_file_source_and_licence(entry: ShippedModel) -> None:
    assert SHIPPED_MODELS[entry.name] is entry is lookup(entry.name)
    assert entry.path().is_file()
    assert entry.licence.startswith("BSD")
    assert entry.title
    assert entry.source


@each
def test_the_links_of_a_urdf_model_stand_in_its_file(entry: ShippedModel) -> None:
    if entry.kind == "dh":
        assert entry.base is None
        assert entry.tip is None
        return
    texts = [file.read_text("utf-8") for file in entry.path().parent.iterdir() if file.is_file()]
    for link in (entry.base, entry.tip):
        names = (f'name="{link}"', f'name="${{prefix}}{link}"')
        assert any(name in text for name in names for text in texts)


@each
def test_the_readme_of_the_models_lists_it(entry: ShippedModel) -> None:
    assert f"| `{entry.name}` |" in (models_directory() / "README.md").read_text("utf-8")


def test_an_unknown_name_is_answered_with_the_nearest_one() -> None:
    with pytest.raises(UsageError, match="did you mean 'paper-listing'"):
        lookup("paper-listings")
    with pytest.raises(UsageError, match="choose one of: appendix, erd-ur5, paper, paper-listing"):
        lookup("zzz")
