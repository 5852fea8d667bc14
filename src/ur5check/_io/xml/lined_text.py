"""XML for somebody else's parser, one element a line, so that its messages can be placed."""

from __future__ import annotations

import re
from xml.sax.saxutils import escape, quoteattr

from .xml_tree import XmlNode

__all__ = ["LinedText"]

_LINE = re.compile(r"\bline (\d+)|:(\d+)\b")


class LinedText:
    """text : what a tree of elements reads as.

    Included files may stand in the tree, and an element's attributes on several lines of its file,
    so the text's lines are not the file's: `at` finds the element.
    """

    def __init__(self, root: XmlNode) -> None:
        self._nodes: list[XmlNode] = []
        lines: list[str] = []
        stack: list[XmlNode | str] = [root]
        while stack:
            node = stack.pop()
            if isinstance(node, str):
                lines[-1] += node
                continue
            self._nodes.append(node)
            words = "".join(f" {key}={quoteattr(text)}" for key, text in node.attributes.items())
            lines.append(f"<{node.tag}{words}>{escape(' '.join(node.text.split(chr(10))))}")
            stack += [f"</{node.tag}>", *reversed(node.children)]
        self.text = "\n".join(lines)

    def at(self, message: str) -> XmlNode | None:
        """The element at the first line that a message names: "line 12", or "model.sdf:12"."""
        found = _LINE.search(message)
        line = int(found[1] or found[2]) if found else 0
        return self._nodes[line - 1] if 0 < line <= len(self._nodes) else None
