"""A text written from checked XML for another parser, and the map back to the file's lines."""

from __future__ import annotations

from lxml import etree

from .safe_xml import parsed_xml
from .xml_numbers import Element

__all__ = ["Places"]


class Places:
    """text : what the tree under `root` reads as, in lxml's writing

    Attributes spread over lines are gathered in one, and included files stand in it, so its lines
    are not the file's: `at` finds the element.
    """

    def __init__(self, root: Element) -> None:
        self.text: str = etree.tostring(root, encoding="unicode")
        again = parsed_xml(self.text).iter(etree.Element)
        self._at: dict[int, Element] = {}
        for written, original in zip(again, root.iter(etree.Element), strict=True):
            self._at.setdefault(written.sourceline, original)

    def at(self, line: int) -> Element | None:
        """The first element that begins on a line of the text."""
        return self._at.get(line)
