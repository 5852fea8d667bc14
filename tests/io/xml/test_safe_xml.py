"""What `checked_root` takes and what it refuses, byte by byte."""

from __future__ import annotations

import pytest

from ur5check._errors import ModelError
from ur5check._io.xml.safe_xml import checked_root
from ur5check._io.xml.xml_tree import checked_xml

DECLARED = b'<?xml version="1.0" encoding="%s"?>\n<robot/>'
LAUGHS = b"""<!-- a comment -->
<!DOCTYPE robot [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>
<robot name="&b;"/>"""


def refusal(data: bytes) -> ModelError:
    with pytest.raises(ModelError) as caught:
        checked_root(data, "arm.urdf")
    assert (caught.value.file, caught.value.rule) == ("arm.urdf", "XML101")
    return caught.value


@pytest.mark.parametrize(
    "data",
    [
        b"<robot/>",
        '<robot name="é"/>'.encode(),
        DECLARED % b"UTF-8",
        DECLARED % b"us-ascii",
        b"<robot><!-- <!DOCTYPE robot> --><a><![CDATA[<!DOCTYPE robot>]]></a></robot>",
    ],
)
def test_plain_xml_comes_back_unchanged(data: bytes) -> None:
    assert checked_xml(data, "arm.urdf") is data


@pytest.mark.parametrize("data", [b"", b" \n\t"])
def test_an_empty_file_is_refused(data: bytes) -> None:
    assert refusal(data).problem == "the file is empty"


@pytest.mark.parametrize(
    ("data", "name"),
    [
        ("<robot/>".encode("utf-16"), "UTF-16"),
        ("<robot/>".encode("utf-16-be"), "UTF-16"),
        ("<robot/>".encode("utf-32"), "UTF-32"),
        (b"\xef\xbb\xbf<robot/>", "byte order mark"),
    ],
)
def test_another_encoding_is_refused_by_name(data: bytes, name: str) -> None:
    error = refusal(data)
    assert name in error.problem
    assert "UTF-8 without a byte order mark" in error.fix


def test_a_declared_encoding_other_than_utf_8_is_refused() -> None:
    error = refusal(DECLARED % b"ISO-8859-1")
    assert error.line == 1
    assert "ISO-8859-1" in error.problem


def test_bytes_that_are_not_utf_8_are_refused_with_their_line() -> None:
    error = refusal('<robot>\n  <link name="é"/>\n</robot>'.encode("latin-1"))
    assert error.line == 2


def test_a_document_type_is_refused_before_its_entities_expand() -> None:
    error = refusal(LAUGHS)
    assert error.line == 2
    assert "DOCTYPE" in error.problem


def test_a_document_type_behind_a_long_prolog_is_found_at_once() -> None:
    error = refusal(b"<!-- x -->  <?y z?>\n" * 20_000 + b"<!DOCTYPE robot><robot/>")
    assert error.line == 20_001
    assert "DOCTYPE" in error.problem


@pytest.mark.parametrize(
    ("data", "line"),
    [
        (b"hello", 1),
        (b"<robot>\n<link>\n</robot>", 3),
        (b"<robot>\n  <link/>\n", 3),
        (b'<robot>\n<link name="a" name="b"/></robot>', 2),
        (b"<robot/>\n<robot/>", 2),
        (b"<robot>\n&undeclared;</robot>", 2),
        (b"<robot>\n<xacro:include/></robot>", 2),
        (b"<robot>\n\x00</robot>", 2),
        (b"<a>" * 300 + b"</a>" * 300, 1),
    ],
    ids=["text", "mismatch", "cut off", "twice", "two roots", "entity", "prefix", "nul", "deep"],
)
def test_what_is_not_well_formed_is_refused_with_its_line(data: bytes, line: int) -> None:
    error = refusal(data)
    assert "not well-formed" in error.problem
    assert error.line == line
