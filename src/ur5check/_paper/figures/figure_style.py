"""Style of the figures: colours that are distinguishable with colour vision deficiency.

Colours are those of Okabe and Ito.  A model has the same colour and line in every picture.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..._errors import UsageError
from ..paper_models import PINOCCHIO, PRINTED, REPAIRED

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = [
    "GREY",
    "INK",
    "LOOKS",
    "READING_ORDER",
    "Look",
    "bare",
    "matplotlib",
    "new_figure",
    "titled",
]

ORANGE, BLUE, GREEN = "#D55E00", "#0072B2", "#009E73"
INK, SILVER, GREY = "#333333", "#ABABAB", "#666666"


@dataclass(frozen=True)
class Look:
    """A model's name in pictures, its colour, and its line."""

    label: str
    colour: str
    width: float
    dashes: tuple[float, ...] | None = None

    def line(self, thickness: float = 1.0) -> dict[str, Any]:
        """As arguments of `plot`."""
        style = "-" if self.dashes is None else (0, self.dashes)
        return {"color": self.colour, "linewidth": thickness * self.width, "linestyle": style}


#: In drawing order: the reference engine's dashes lie on the appendix's broad line, and must cover
#: it.
LOOKS = {
    "appendix": Look("appendix URDF", SILVER, 5.0),
    "erd-ur5": Look("example-robot-data", GREEN, 1.8),
    REPAIRED: Look("listing, signs repaired", BLUE, 2.4),
    PRINTED: Look("listing, as printed", ORANGE, 2.4, (6, 2)),
    PINOCCHIO: Look("appendix, by Pinocchio", INK, 1.3, (4, 2)),
}

#: In legends: what the paper printed, its repair, then the other models.
READING_ORDER = (PRINTED, REPAIRED, "appendix", PINOCCHIO, "erd-ur5")


def matplotlib() -> Any:
    """The library.  Raises UsageError, saying how to get it, where it is absent."""
    try:
        import matplotlib as mpl
    except ImportError:
        raise UsageError("pictures need matplotlib; pip install 'ur5check[figures]'") from None
    return mpl


def new_figure(width: float, height: float) -> Figure:
    """An empty figure without window or global state; sizes in inches."""
    matplotlib()
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure as Empty

    figure = Empty(figsize=(width, height))
    FigureCanvasAgg(figure)
    return figure


def bare(axes: Axes) -> None:
    """Two axes and the zero line."""
    axes.spines[["top", "right"]].set_visible(False)
    axes.axhline(0.0, color="#BBBBBB", linewidth=0.8, zorder=0)


def titled(figure: Figure, title: str, below: str, *, left: float) -> None:
    """The finding in bold, and under it what is shown; left : as a part of the width."""
    inch = 1.0 / figure.get_figheight()
    figure.text(left, 1 - 0.15 * inch, title, va="top", fontsize=13, fontweight="bold", color=INK)
    figure.text(left, 1 - 0.5 * inch, below, va="top", fontsize=10.5, color=GREY)
