"""XML as a light tree in which every element and attribute knows its line and column.

Expat is used, since lxml knows lines of start tags only.  Document types are refused: they declare
entities, which readers treat differently.  Sizes are bounded before anything is parsed.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import accumulate
from xml.parsers import expat

from ..._errors import ModelError
from ..._finding import Place

__all__ = [
    "CORRECT_XML",
    "LARGEST_FILE",
    "XmlError",
    "XmlFile",
    "XmlNode",
    "checked_xml",
    "parse_xml",
]

#: Larger than any description of a robot (meshes are files of their own) [bytes].
LARGEST_FILE = 64 * 2**20

_MARKS = (
    (b"\xff\xfe\x00\x00", "UTF-32"),
    (b"\x00\x00\xfe\xff", "UTF-32"),
    (b"\xff\xfe", "UTF-16"),
    (b"\xfe\xff", "UTF-16"),
    (b"\xef\xbb\xbf", "UTF-8 with a byte order mark"),
    (b"<\x00", "UTF-16 without a byte order mark"),
    (b"\x00<", "UTF-16 without a byte order mark"),
)
CORRECT_XML = "correct the XML; a cut-off file must be fetched again"
_SAVE_AS_UTF8 = "save the file as UTF-8 without a byte order mark"
#: Bytes of a UTF-8 character after its first.
_CONTINUING = bytes(range(0x80, 0xC0))
_BLOCK = 1024
_ENCODING = re.compile(rb"""\A<\?xml\s[^>]*?\bencoding\s*=\s*["']([^"']*)["']""")


class XmlError(Exception):
    """Text that is no XML that every reader reads alike.

    fix : what to do;  line, column : from 1, 0 if unknown
    """

    def __init__(self, problem: str, fix: str, line: int = 0, column: int = 0) -> None:
        super().__init__(problem)
        self.problem, self.fix, self.line, self.column = problem, fix, line, column

    def of_file(self, file: str) -> ModelError:
        """The same about a file."""
        return ModelError(
            self.problem, fix=self.fix, file=file, line=self.line or None, rule="XML101"
        )


@dataclass(eq=False)
class XmlFile:
    """name : as reports call it;  data : its bytes"""

    name: str
    data: bytes

    @cached_property
    def _starts(self) -> list[int]:
        return [0, *(match.end() for match in re.finditer(rb"\n", self.data))]

    @cached_property
    def _counts(self) -> list[int]:
        """How many characters begin before each block: a file may be one line."""
        blocks = range(0, len(self.data) + 1, _BLOCK)
        return list(accumulate((_begun(self.data[k : k + _BLOCK]) for k in blocks), initial=0))

    def _characters(self, offset: int) -> int:
        block, rest = divmod(offset, _BLOCK)
        return self._counts[block] + _begun(self.data[offset - rest : offset])

    def line_column(self, offset: int) -> tuple[int, int]:
        """Line and column, from 1, of a byte; columns count characters."""
        line = bisect_right(self._starts, offset)
        return line, self._characters(offset) - self._characters(self._starts[line - 1]) + 1


def _begun(data: bytes) -> int:
    """How many UTF-8 characters begin in these bytes."""
    return len(data.translate(None, _CONTINUING))


@dataclass(eq=False)
class XmlNode:
    """One element.

    tag : with its namespace's prefix, as written;  offset : of its start tag in `file` [bytes]
    source : where it was written, if `file` was made from other files
    """

    tag: str
    attributes: dict[str, str]
    file: XmlFile
    offset: int
    children: list[XmlNode] = field(default_factory=list)
    text: str = ""
    source: Place | None = None

    def get(self, attribute: str) -> str | None:
        """An attribute's text, None where it is left out."""
        return self.attributes.get(attribute)

    def all(self, *tags: str) -> Iterator[XmlNode]:
        """The children of these tags, in order."""
        return (child for child in self.children if child.tag in tags)

    def walk(self) -> Iterator[XmlNode]:
        """This element and all below it, in document order."""
        stack = [self]
        while stack:
            node = stack.pop()
            yield node
            stack += reversed(node.children)

    def place(self, attribute: str | None = None, element: str = "") -> Place:
        """Where the element begins, or where the value of one of its attributes does.

        In a text made from other files: where the element was written, and by which way it came.
        """
        offset = self.offset if attribute is None else self.value_span(attribute)[0]
        line, column = self.file.line_column(offset)
        here = Place(self.file.name, line, column, element)
        if self.source is None:
            return here
        return replace(self.source, element=element, via=(*self.source.via, here))

    def value_span(self, attribute: str) -> tuple[int, int]:
        """The bytes between an attribute's quotes; none, at the element's start, without it."""
        # The element has the attribute, so the first one after its start is its own.
        name = re.escape(attribute.encode())
        pattern = re.compile(rb"\s" + name + rb"""\s*=\s*(?:"([^"]*)|'([^']*))""")
        found = (
            pattern.search(self.file.data, self.offset) if attribute in self.attributes else None
        )
        return (self.offset, self.offset) if found is None else found.span(found.lastindex or 0)


def checked_xml(data: bytes, file: str) -> bytes:
    """`data` itself.  Raises ModelError for what `parse_xml` refuses; file : what it is called."""
    try:
        parse_xml(data, file)
    except XmlError as error:
        raise error.of_file(file) from None
    return data


def parse_xml(data: bytes, name: str) -> XmlNode:
    """The root of an XML file.

    Raises XmlError for an empty file, one that is too large, an encoding other than UTF-8, a
    document type, and anything that is not well-formed.
    """
    if len(data) > LARGEST_FILE:
        problem = f"the file has {len(data):,} bytes, more than {LARGEST_FILE:,}"
        raise XmlError(problem, "give the robot's description, without meshes in it")
    if not data.strip():
        raise XmlError("the file is empty", "give a robot description")
    file = XmlFile(name, data)
    for mark, encoding in _MARKS:
        if data.startswith(mark):
            raise XmlError(f"the file is {encoding}, not UTF-8", _SAVE_AS_UTF8, 1, 1)
    declared = _ENCODING.match(data)
    if declared and declared[1].lower() not in (b"utf-8", b"us-ascii", b"ascii"):
        encoding = declared[1].decode("ascii", "replace")
        problem = f"the file declares the encoding {encoding}, not UTF-8"
        raise XmlError(problem, f"{_SAVE_AS_UTF8} and declare that", 1, 1)
    try:
        data.decode("utf-8")
    except UnicodeDecodeError as error:
        line, column = file.line_column(error.start)
        raise XmlError("the file is not UTF-8 text", _SAVE_AS_UTF8, line, column) from None
    return _parsed(file)


def _parsed(file: XmlFile) -> XmlNode:
    parser = expat.ParserCreate("utf-8")
    parser.buffer_text = True
    roots: list[XmlNode] = []
    open_nodes: list[XmlNode] = []

    def start(tag: str, attributes: dict[str, str]) -> None:
        node = XmlNode(tag, attributes, file, parser.CurrentByteIndex)
        (open_nodes[-1].children if open_nodes else roots).append(node)
        open_nodes.append(node)

    def end(_tag: str) -> None:
        open_nodes.pop()

    def text(data: str) -> None:
        open_nodes[-1].text += data

    def doctype(*_: object) -> None:
        line, column = parser.CurrentLineNumber, parser.CurrentColumnNumber + 1
        problem = "a document type (DOCTYPE, which may declare entities) is not accepted"
        fix = "write out what its entities stand for and remove it"
        raise XmlError(problem, fix, line, column)

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.CharacterDataHandler = text
    parser.StartDoctypeDeclHandler = doctype
    try:
        parser.Parse(file.data, True)
    except expat.ExpatError as error:
        reason = expat.ErrorString(error.code)
        raise XmlError(
            f"the file is not well-formed XML: {reason}",
            CORRECT_XML,
            error.lineno,
            error.offset + 1,
        ) from None
    return roots[0]
