"""Pictures as files: the same numbers give the same SVG, byte for byte."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

from .figure_style import matplotlib

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["as_png", "as_svg"]

_PNG_DOTS = 110  # per inch: 900 pixels across, what a page shows

#: Text stays text (small, can be searched and read aloud), and ids are drawn from a fixed salt.
_SVG = {"svg.fonttype": "none", "svg.hashsalt": "ur5check"}


def as_svg(figure: Figure) -> bytes:
    """The picture as SVG, without a date."""
    buffer = io.BytesIO()
    with matplotlib().rc_context(_SVG):
        figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": "ur5check"})
    return buffer.getvalue()


def as_png(figure: Figure) -> bytes:
    """The picture as PNG."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=_PNG_DOTS)
    return buffer.getvalue()
