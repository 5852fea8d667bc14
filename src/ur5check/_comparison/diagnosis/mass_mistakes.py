"""Mistakes in a link's mass."""

from __future__ import annotations

from collections.abc import Iterator

from .common_mistakes import exchanged, scaled
from .link_numbers import LinkPair
from .mistake import LinkMistake, Repair
from .number_mistakes import digit_swaps

__all__ = ["MASS_MISTAKES"]


def _digits(link_pair: LinkPair, i: int) -> Iterator[Repair]:
    # Two neighbouring digits further back make a difference that any two measurements have: the
    # repaired number must be the other one, digit by digit.
    for how, repaired in digit_swaps(link_pair.bodies[i].mass):
        if abs(repaired - link_pair.truth[i].mass) <= 1e-9 * repaired:
            yield how, repaired


#: The likelier first.
MASS_MISTAKES: tuple[LinkMistake, ...] = (
    scaled("mass", "CMP111", "the mass is in another unit", "write kilograms", ("3700", "3.7 kg")),
    LinkMistake(
        id="mass-digits",
        rule_id="CMP112",
        quantity="mass",
        says="two digits of the mass are exchanged",
        repair="write the mass again",
        bad="8.933 kg",
        good="8.393 kg",
        repairs=_digits,
    ),
    exchanged("mass", "CMP113"),
)
