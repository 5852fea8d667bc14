"""Where each element of an expansion was written, kept beside the nodes while xacro works.

DOM keeps data with a node and tells a handler when the node is cloned: so the origin follows macro
bodies and blocks, and no attribute is added that xacro would evaluate or write.
"""

from __future__ import annotations

import sys
import xml.dom.expatbuilder
import xml.dom.minidom
from collections.abc import Callable
from typing import Any, NamedTuple, cast

__all__ = ["Origins"]

_KEY = "origin"


class _Origin(NamedTuple):
    """file : number of the file;  call : of the macro call that brought the element here"""

    file: int
    line: int
    column: int
    tag: str
    call: _Origin | None


class Origins:
    """Of the elements of one expansion."""

    def __init__(self) -> None:
        self._files: list[str] = []
        self._calls: list[_Origin | None] = []  # those being expanded, the innermost last

    def parse(self, data: bytes, path: str) -> xml.dom.minidom.Document:
        """What `minidom.parseString` gives, each element with its origin."""
        self._files.append(path)
        return _Builder(self, len(self._files) - 1).parseString(data)

    def note(self, node: xml.dom.minidom.Element, origin: _Origin) -> None:
        """Keep an element's origin with it and with its clones."""
        node.setUserData(_KEY, origin, self)

    def handle(self, operation: int, key: str, data: _Origin, source: Any, clone: Any) -> None:
        """DOM's call when a node was cloned: macros and blocks are, where they are inserted."""
        del operation, key, source
        if data.call is None and self._calls:
            data = data._replace(call=self._calls[-1])
        self.note(clone, data)

    def noting_calls(self, expand_call: Callable[..., bool]) -> Callable[..., bool]:
        """xacro's `handle_macro_call`, noting the call for what it clones."""
        # One more frame a call: as deep a recursion as without it must fit.
        sys.setrecursionlimit(sys.getrecursionlimit() * 3 // 2)

        def noting(node: xml.dom.minidom.Element, *rest: Any) -> bool:
            self._calls.append(node.getUserData(_KEY))
            try:
                return expand_call(node, *rest)
            finally:
                self._calls.pop()

        return noting

    def table(self, document: xml.dom.minidom.Document) -> dict[str, Any]:
        """files : paths;  elements : [file, line, column, call] of each, in document order;
        calls : [file, line, column, call, tag];  a call is a number in `calls`, −1 for none
        """
        calls: list[list[Any]] = []
        numbers: dict[int, int] = {}

        def number(call: _Origin | None) -> int:
            chain = []
            while call is not None and id(call) not in numbers:
                chain.append(call)
                call = call.call
            last = -1 if call is None else numbers[id(call)]
            for one in reversed(chain):
                calls.append([one.file, one.line, one.column, last, one.tag])
                last = numbers[id(one)] = len(calls) - 1
            return last

        elements = []
        nodes: list[Any] = [document.documentElement]
        while nodes:
            node = nodes.pop()
            if node.nodeType == node.ELEMENT_NODE:
                origin = node.getUserData(_KEY)
                elements.append([origin.file, origin.line, origin.column, number(origin.call)])
                nodes += reversed(node.childNodes)
        return {"files": self._files, "elements": elements, "calls": calls}


class _Builder(xml.dom.expatbuilder.ExpatBuilderNS):
    """minidom's own builder, which notes where an element starts."""

    def __init__(self, origins: Origins, file: int) -> None:
        super().__init__()
        self._origins, self._file = origins, file

    def start_element_handler(self, name: str, attributes: list[str]) -> None:
        super().start_element_handler(name, attributes)
        parser, node = self.getParser(), cast("xml.dom.minidom.Element", self.curNode)
        line, column = parser.CurrentLineNumber, parser.CurrentColumnNumber + 1
        self._origins.note(node, _Origin(self._file, line, column, node.tagName, None))
