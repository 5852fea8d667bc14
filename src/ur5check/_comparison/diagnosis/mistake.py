"""What a known mistake is: a way to be wrong, and the values that would repair it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any, Literal

from .link_numbers import Body, LinkPair

__all__ = ["Mistake", "Quantity", "Repair", "changed", "value_of"]

#: What a mistake spoils: one number, vector or matrix of one link; "body" is mass, centre and
#: tensor at once.
Quantity = Literal["mass", "centre", "tensor", "link_vector", "rotation", "body"]

_FIELDS: dict[Quantity, str] = {
    "mass": "mass",
    "centre": "com",
    "tensor": "tensor",
    "link_vector": "offset",
    "rotation": "rotation",
    "body": "whole",
}

#: (how, the repaired value): one way in which the mistake could have been made.
Repair = tuple[str, Any]


@dataclass(frozen=True)
class Mistake:
    """A mistake that people make.

    id : how reports, tests and the docs name it
    quantity : what it spoils
    says : what happened, as a clause that follows the link's name
    repair : what to do in the file
    fixes : of a scene and a link (from 0), every value that would repair it
    alone : whether it must explain a number by itself.  Most mistakes are undone from the suspect's
        own numbers and may come in pairs; one that takes its value from elsewhere would, in a
        pair, explain anything.
    """

    id: str
    quantity: Quantity
    says: str
    repair: str
    repairs: Callable[[LinkPair, int], Iterator[Repair]]
    alone: bool = False


def value_of(body: Body, quantity: Quantity) -> Any:
    """The body's mass, centre, tensor, reach or turn, or all that moves with it."""
    return getattr(body, _FIELDS[quantity])


def changed(body: Body, quantity: Quantity, value: Any) -> Body:
    """The body with one quantity replaced."""
    if quantity == "body":
        return replace(body, mass=value.mass, com=value.com, tensor=value.tensor)
    return replace(body, **{_FIELDS[quantity]: value})
