"""Two models that do not agree: the finding says what differs."""

from __future__ import annotations

import pytest

from ur5check._validation.configuration import Configuration
from ur5check._validation.verdict import Request, compare_verdicts, verdicts
from urdf_examples import GOOD


def finding(tmp_path, old, new):
    requests = []
    for name, text in (("a", GOOD), ("b", GOOD.replace(old, new))):
        file = tmp_path / f"{name}.urdf"
        file.write_text(text)
        requests.append(Request(str(file), samples=20))
    models = list(verdicts(requests, Configuration(), "error"))
    (pair,) = compare_verdicts(models, None, Configuration()).pairs
    return pair.findings.open


@pytest.mark.parametrize(
    ("old", "new", "quantity"),
    [
        ('upper="2.5" effort="10"', 'upper="2.5" effort="1"', "effort limit"),
        ('upper="2.5"', 'upper="2.0"', "upper limit"),
        (
            '<limit lower="-1.5"',
            '<dynamics damping="0.5"/>\n    <limit lower="-1.5"',
            "damping",
        ),
    ],
)
def test_the_same_torques_but_another_number(tmp_path, old, new, quantity):
    (found,) = finding(tmp_path, old, new)
    assert found.rule == "CMP003"
    assert quantity in found.message
    assert "torques differ" not in found.message
    assert found.effect is None
    assert found.places


def test_other_torques(tmp_path):
    (found,) = finding(tmp_path, '<mass value="1.0"/>', '<mass value="1.5"/>')
    assert found.rule == "CMP001"
    assert found.value == found.effect > found.bound > 0.0


def test_no_difference(tmp_path):
    assert list(finding(tmp_path, "two", "three")) == []
