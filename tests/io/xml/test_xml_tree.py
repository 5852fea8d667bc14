"""XML with places: lines and columns of elements and attributes, and what is refused."""

from __future__ import annotations

import pytest

from ur5check._io.xml.xml_tree import LARGEST_FILE, XmlError, parse_xml

TEXT = '<robot name="r">\n  <!-- é -->\n  <link\n     name="ä b" x = "1"/>\n</robot>\n'.encode()


def test_elements_and_attributes_know_line_and_column():
    (link,) = parse_xml(TEXT, "f.urdf").children
    place = link.place()
    assert (place.file, place.line, place.column) == ("f.urdf", 3, 3)
    assert (link.place("name").line, link.place("name").column) == (4, 12)
    # One column a character, not a byte: "ä" has two bytes.
    assert (link.place("x").line, link.place("x").column) == (4, 22)


@pytest.mark.parametrize("letter", ["a", "ä", "腕", "🦾"])
@pytest.mark.parametrize("before", [0, 1, 1023, 1024, 1025, 5000])
def test_columns_of_a_long_line_count_characters(before, letter):
    text = f"<r>\n<!--{letter * before}--><a/>{letter * before}<b/></r>".encode()
    columns = [child.place().column for child in parse_xml(text, "f.urdf").children]
    assert columns == [before + 8, 2 * before + 12]


@pytest.mark.parametrize(
    ("data", "line"),
    [
        (b"", 0),
        (b"  \n", 0),
        (b"<a>\n<b>\n</a>", 3),
        (b"<a/>\n<b/>", 2),
        (b'<!DOCTYPE a [<!ENTITY e "x">]>\n<a>&e;</a>', 1),
        ("<a>ä</a>".encode("latin-1"), 1),
        ("<a/>".encode("utf-16"), 1),
        (b'<?xml version="1.0" encoding="latin-1"?><a/>', 1),
        (b"<a>\x00</a>", 1),
    ],
)
def test_what_readers_take_differently_is_refused(data, line):
    with pytest.raises(XmlError) as caught:
        parse_xml(data, "f.urdf")
    assert caught.value.line == line


def test_a_file_beyond_the_limit_is_not_parsed():
    with pytest.raises(XmlError, match="bytes"):
        parse_xml(b" " * (LARGEST_FILE + 1), "f.urdf")


def test_twenty_thousand_links_are_read_with_their_places():
    text = "<robot>" + "".join(f'\n<link name="l{i}"/>' for i in range(20_000)) + "</robot>"
    root = parse_xml(text.encode(), "f.urdf")
    assert root.children[-1].place("name").line == 20_001
