"""Mistakes that more than one quantity can have: a lost sign, a wrong axis, a unit, an exchange."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..._robot.transforms import Array
from .link_numbers import LinkPair
from .mistake import LinkMistake, Quantity, Repair, value_of
from .number_mistakes import DECADES, axis_swaps, shifted_decimals, sign_flips, words_of

__all__ = ["exchanged", "scaled", "sign_lost", "swapped_axes"]

#: What ids and sentences call a quantity.
_IDS: dict[Quantity, str] = {"link_vector": "length"}
_WORDS: dict[Quantity, str] = {
    "mass": "mass",
    "centre": "centre of mass",
    "tensor": "tensor",
    "link_vector": "length",
}


def sign_lost(quantity: Quantity, rule_id: str, sources: tuple[str, ...] = ()) -> LinkMistake:
    """A component, or the whole vector, with the other sign."""

    def repairs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
        v: Array = value_of(link_pair.bodies[i], quantity)
        yield from sign_flips(v)
        if np.count_nonzero(v) > 1:
            yield "all signs", -v

    return LinkMistake(
        id=f"{_IDS.get(quantity, quantity)}-sign",
        rule_id=rule_id,
        quantity=quantity,
        says=f"a sign of the {_WORDS[quantity]} is lost",
        repair="write the sign",
        bad="(0.425, 0, 0) m",
        good="(-0.425, 0, 0) m",
        repairs=repairs,
        sources=sources,
    )


def swapped_axes(quantity: Quantity, rule_id: str) -> LinkMistake:
    """The components of a vector in another order."""

    def repairs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
        for how, permutation in axis_swaps():
            yield how, permutation @ value_of(link_pair.bodies[i], quantity)

    what = "offset" if quantity == "link_vector" else _WORDS[quantity]
    return LinkMistake(
        id=f"{_IDS.get(quantity, quantity)}-axes",
        rule_id=rule_id,
        quantity=quantity,
        says=f"the {what} has its components on the wrong axes",
        repair="write each component on its own axis",
        bad="(0, 0, 0.28) m for a link that extends along x",
        good="(0.28, 0, 0) m",
        repairs=repairs,
    )


def scaled(
    quantity: Quantity, rule_id: str, says: str, repair: str, example: tuple[str, str]
) -> LinkMistake:
    """A power of ten: another unit, or a decimal point in the wrong place."""

    def repairs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
        value = value_of(link_pair.bodies[i], quantity)
        for factor in DECADES:
            yield words_of(factor), factor * value
        if quantity in ("centre", "link_vector"):
            yield from shifted_decimals(value)

    # Not in pairs: shrunk to nothing, a number takes any mistake that adds something.
    return LinkMistake(
        id=f"{_IDS.get(quantity, quantity)}-scaled",
        rule_id=rule_id,
        quantity=quantity,
        says=says,
        repair=repair,
        bad=example[0],
        good=example[1],
        repairs=repairs,
        alone=True,
    )


def exchanged(quantity: Quantity, rule_id: str) -> LinkMistake:
    """The numbers of two links exchanged."""

    def repairs(link_pair: LinkPair, i: int) -> Iterator[Repair]:
        own, own_due = (value_of(side[i], quantity) for side in (link_pair.bodies, link_pair.truth))
        for j, other in enumerate(link_pair.bodies):
            # An exchange goes both ways: what stands here is what the other link should have.  Two
            # links that should have nearly the same (a UR5's wrists) must have it to the digit.
            due = value_of(link_pair.truth[j], quantity)
            size = np.linalg.norm(due)
            nearly = 0.1 if np.linalg.norm(own_due - due) > 0.1 * size else 1e-4
            if j != i and np.linalg.norm(own - due) < nearly * size:
                yield f"with link {j + 1}", value_of(other, quantity)

    return LinkMistake(
        id=f"{_IDS.get(quantity, quantity)}-exchanged",
        rule_id=rule_id,
        quantity=quantity,
        says=f"the {_WORDS[quantity]} is exchanged with another link's",
        repair="put each link's numbers into its own row",
        bad=f"link 2 has the {_WORDS[quantity]} of link 3, and link 3 that of link 2",
        good=f"each link has its own {_WORDS[quantity]}",
        repairs=repairs,
        alone=True,
    )
