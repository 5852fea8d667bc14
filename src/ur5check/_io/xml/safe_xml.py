"""The one place where lxml parses: XML that every reader reads alike, and nothing else.

A robot description is read by several parsers (this program's, xacro's, each engine's own), and
they are strict about different things.  What they could read differently is refused here: an
encoding other than UTF-8, a document type, and anything that is not well-formed.
"""

from __future__ import annotations

import re

from lxml import etree

from ..._errors import ModelError
from .xml_numbers import Element

__all__ = ["checked_root", "checked_xml", "parsed_xml"]

# An XML declaration, from which only the encoding is wanted (XML 1.0, productions 23 and 80).
_ENCODING = re.compile(rb"""\A<\?xml\s[^>]*?\bencoding\s*=\s*["']([^"']*)["']""")

# A document type may only follow white space, comments and processing instructions (productions 22
# and 27).  The possessive `*+` keeps a hostile prolog from making the search backtrack.
_DOCTYPE = re.compile(rb"\A(?>\s+|<\?.*?\?>|<!--.*?-->)*+<!DOCTYPE", re.DOTALL)

_FOREIGN_MARKS = (
    (b"\xff\xfe\x00\x00", "UTF-32"),
    (b"\x00\x00\xfe\xff", "UTF-32"),
    (b"\xff\xfe", "UTF-16"),
    (b"\xfe\xff", "UTF-16"),
    (b"\xef\xbb\xbf", "UTF-8 with a byte order mark"),
    (b"<\x00", "UTF-16 without a byte order mark"),
    (b"\x00<", "UTF-16 without a byte order mark"),
)

_SAVE_AS_UTF8 = "save the file as UTF-8 without a byte order mark"


def checked_xml(data: bytes, file: str) -> bytes:
    """`data` itself, when it is well-formed UTF-8 XML without a document type.

    file : the name to put into an error

    Raises ModelError, with the line where there is one.
    """
    checked_root(data, file)
    return data


def checked_root(data: bytes, file: str) -> Element:
    """The root element of a file.  Raises ModelError as `checked_xml` does."""
    if not data.strip():
        raise ModelError(
            "the file is empty", fix="give a robot description", file=file, rule="XML101"
        )
    _check_encoding(data, file)
    doctype = _DOCTYPE.search(data)
    if doctype:
        raise ModelError(
            "a document type (DOCTYPE, which may declare entities) is not accepted",
            fix="write out what its entities stand for and remove it",
            file=file,
            line=_line_at(data, doctype.end()),
            element="<!DOCTYPE>",
            rule="XML101",
        )
    try:
        return parsed_xml(data)
    except etree.XMLSyntaxError as error:
        raise ModelError(
            f"the file is not well-formed XML: {_reason(error)}",
            fix="correct the XML; a cut-off file must be fetched again",
            file=file,
            line=error.lineno or None,
            rule="XML101",
        ) from None


def parsed_xml(data: bytes | str) -> Element:
    """The root of text that was checked before.  Raises lxml's XMLSyntaxError if it was not.

    Neither parser errors are repaired (recover) nor deep or huge trees accepted (huge_tree).
    """
    parser = etree.XMLParser(
        resolve_entities=False, no_network=True, load_dtd=False, recover=False, huge_tree=False
    )
    return etree.fromstring(data.encode() if isinstance(data, str) else data, parser)


def _check_encoding(data: bytes, file: str) -> None:
    for mark, name in _FOREIGN_MARKS:
        if data.startswith(mark):
            raise ModelError(
                f"the file is {name}", fix=_SAVE_AS_UTF8, file=file, line=1, rule="XML101"
            )
    declared = _ENCODING.match(data)
    # ASCII is a part of UTF-8, so a file that declares it is read alike by everyone.
    if declared and declared[1].lower() not in (b"utf-8", b"us-ascii", b"ascii"):
        raise ModelError(
            "the file declares an encoding other than UTF-8",
            fix=f"{_SAVE_AS_UTF8} and declare that",
            file=file,
            line=1,
            element="<?xml?>",
            value=declared[1].decode("ascii", "replace"),
            rule="XML101",
        )
    try:
        data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise ModelError(
            "the file is not UTF-8 text",
            fix=_SAVE_AS_UTF8,
            file=file,
            line=_line_at(data, error.start),
            value=data[error.start : error.end],
            rule="XML101",
        ) from None


def _line_at(data: bytes, position: int) -> int:
    return data.count(b"\n", 0, position) + 1


def _reason(error: etree.XMLSyntaxError) -> str:
    """libxml2's message without the place, which the error carries already."""
    return re.sub(r",? *line \d+, column \d+\s*$", "", error.msg or "unknown reason").strip()
