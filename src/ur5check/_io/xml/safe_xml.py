"""The one place where lxml parses: XML that is edited, MJCF and SDF.

Checks are those of `xml_tree`, which reads URDFs: what readers could take differently is refused.
"""

from __future__ import annotations

import re

from lxml import etree

from .xml_numbers import Element
from .xml_tree import CORRECT_XML, XmlError, checked_xml

__all__ = ["checked_root", "parsed_xml"]


def checked_root(data: bytes, file: str) -> Element:
    """The root element of a file.  Raises ModelError, with the line where there is one."""
    return parsed_xml(checked_xml(data, file), file)


def parsed_xml(data: bytes | str, file: str = "URDF text") -> Element:
    """The root of text that was checked before.

    Neither parser errors are repaired (recover) nor deep or huge trees accepted (huge_tree).
    Raises ModelError for a prefix without a namespace and for elements nested too deep.
    """
    parser = etree.XMLParser(
        resolve_entities=False, no_network=True, load_dtd=False, recover=False, huge_tree=False
    )
    try:
        return etree.fromstring(data.encode() if isinstance(data, str) else data, parser)
    except etree.XMLSyntaxError as error:
        problem = f"the file is not well-formed XML: {_reason(error)}"
        raise XmlError(problem, CORRECT_XML, error.lineno or 0).of_file(file) from None


def _reason(error: etree.XMLSyntaxError) -> str:
    """libxml2's message without the place, which the error carries already."""
    return re.sub(r",? *line \d+, column \d+\s*$", "", error.msg or "unknown reason").strip()
