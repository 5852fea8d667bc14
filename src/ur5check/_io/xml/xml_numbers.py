"""Reading one XML element: its names, its numbers, its children; each fault a `ModelError`."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, NoReturn

from ..._errors import ModelError
from ..printed_numbers import Printed, plain_number

__all__ = ["Element", "ElementReader"]

Element = Any  # lxml.etree._Element: lxml ships no types


def xml_words(text: str) -> list[str]:
    """Words parted by XML's white space only: other readers take a no-break space for a letter."""
    return [word for word in re.split(r"[ \t\r\n]+", text) if word]


class ElementReader:
    """Reads elements of one file; knows the file's name and says where each fault stands.

    `subject` is the link or joint that an element belongs to, as in "link 'forearm'
    inertial/mass".
    """

    def __init__(self, file: str) -> None:
        self.file = file

    def fail(
        self,
        node: Element,
        element: str | None,
        problem: str,
        fix: str,
        value: object = None,
        rule: str = "XML100",
    ) -> NoReturn:
        raise ModelError(
            problem,
            fix=fix,
            file=self.file,
            line=node.sourceline,
            element=element,
            value=value,
            rule=rule,
        )

    def name(self, node: Element) -> str:
        """The `name` attribute, which must not be empty."""
        name = node.get("name")
        if name is None or not name.strip():
            fix = f'write <{node.tag} name="…">'
            self.fail(node, f"<{node.tag}>", "has no name", fix, value=name)
        return str(name)

    def child(self, node: Element, tag: str, subject: str) -> Element | None:
        """The only child of this tag, or None; two of them are one too many."""
        found = node.findall(tag)
        if len(found) > 1:
            self.fail(
                found[1],
                subject,
                f"has several <{tag}> elements",
                "keep one: readers differ on which",
            )
        return found[0] if found else None

    def number(self, node: Element, attribute: str, subject: str) -> Printed:
        """A required attribute that holds one plain number."""
        text = node.get(attribute)
        if text is None:
            self.fail(node, subject, f"{attribute} is missing", f'write {attribute}="…"')
        return self._plain(node, f"{subject} {attribute}", text, text)

    def optional_number(self, node: Element, attribute: str, subject: str) -> Printed | None:
        return None if node.get(attribute) is None else self.number(node, attribute, subject)

    def triple(
        self, node: Element, attribute: str, subject: str, default: Sequence[float] | None
    ) -> tuple[float, float, float]:
        """An attribute of three plain numbers; `default` where it is left out, if there is one."""
        text = node.get(attribute)
        if text is None:
            if default is None:
                self.fail(node, subject, f"{attribute} is missing", f'write {attribute}="x y z"')
            a, b, c = default
            return a, b, c
        where = f"{subject} {attribute}"
        words = xml_words(text)
        numbers = [self._plain(node, where, word, text) for word in words]
        if len(numbers) != 3:
            problem = f"takes 3 numbers, not {len(numbers)}"
            self.fail(node, where, problem, "write three numbers, parted by spaces", text)
        a, b, c = numbers
        return a, b, c

    def numbers(self, node: Element, attribute: str, subject: str) -> list[Printed]:
        """An attribute of plain numbers, however many."""
        text = str(node.get(attribute))
        return [self._plain(node, f"{subject} {attribute}", word, text) for word in xml_words(text)]

    def text_numbers(self, node: Element, subject: str, count: int) -> list[Printed]:
        """An element's own text: `count` plain numbers."""
        text = node.text or ""
        words = xml_words(text)
        numbers = [self._plain(node, subject, word, text) for word in words]
        if len(numbers) != count:
            problem = f"takes {count} number{'s' if count > 1 else ''}, not {len(numbers)}"
            self.fail(node, subject, problem, "write them, parted by spaces", text)
        return numbers

    def origin(
        self, node: Element, subject: str
    ) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """Both xyz [m] and rpy [rad] of the node's `<origin>`; zeros where it has none."""
        origin = self.child(node, "origin", subject)
        if origin is None:
            return (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
        where = f"{subject} origin"
        zero = (0.0, 0.0, 0.0)
        return self.triple(origin, "xyz", where, zero), self.triple(origin, "rpy", where, zero)

    def _plain(self, node: Element, where: str, word: str, whole: str) -> Printed:
        try:
            return plain_number(word)
        except ValueError as error:
            fix = "write a finite decimal number, such as -0.0018 or 1.2e-3"
            self.fail(node, where, str(error), fix, whole)
