"""Names that were almost right."""

from __future__ import annotations

from ur5check._io.suggestions import did_you_mean


def test_the_nearest_name_all_of_few_or_three_of_many():
    many = [f"robot_{i}_description" for i in range(60)]
    assert did_you_mean("robot_7_descripton", many) == "did you mean 'robot_7_description'?"
    assert did_you_mean("zzz", ["one", "two"]) == "choose one of: one, two"
    assert did_you_mean("zzz", many).count("_description") == 3
    assert did_you_mean("zzz", []) == "there is none to choose from"
