"""One style for every figure: colours that colour-blind readers tell apart, legible at half size.

Figures are made from ``matplotlib.figure.Figure`` alone: pyplot is slow to import and keeps global state.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from varistiff.core.status import Status

# Okabe & Ito's palette
BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
YELLOW, BLUE, VERMILION, PURPLE = "#F0E442", "#0072B2", "#D55E00", "#CC79A7"

INK = "#1b1f24"
SOFT = "#5c6670"
FAINT = "#c9d0d6"
METAL = "#8b96a1"
METAL_LIGHT = "#dfe4e8"

DPI = 110
PNG_DPI = 160
WIDTH = 7.4  # inches
HEIGHT = 4.5

_STYLE: dict[str, Any] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],  # comes with matplotlib: the same picture everywhere
    "font.size": 11.5,
    "axes.titlesize": 12.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.titlepad": 9.0,
    "axes.titley": 1.0,  # fixed: finding a place for the title costs a tenth of the drawing time
    "axes.labelsize": 12.0,
    "axes.labelcolor": INK,
    "axes.edgecolor": SOFT,
    "axes.linewidth": 0.9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.unicode_minus": True,
    "grid.color": "#e3e7ea",
    "grid.linewidth": 0.8,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.labelsize": 11.0,
    "ytick.labelsize": 11.0,
    "text.color": INK,
    "text.parse_math": False,
    "lines.linewidth": 2.2,
    "lines.solid_capstyle": "round",
    "legend.fontsize": 10.5,
    "legend.title_fontsize": 10.5,
    "legend.frameon": False,
    "legend.handlelength": 2.2,
    "legend.borderaxespad": 0.0,
    "figure.facecolor": "white",
    "figure.dpi": DPI,
    "savefig.dpi": DPI,
    "hatch.linewidth": 0.7,
    "hatch.color": "#6b7680",
    "svg.fonttype": "path",  # self-contained: no font of the reader's machine is needed
    "svg.hashsalt": "varistiff",  # the same figure gives the same file
    "path.simplify": True,
    "path.simplify_threshold": 0.3,
}


@dataclass(frozen=True)
class Look:
    """How one status is drawn: fill and hatch of its region, dashes of a curve inside it."""

    fill: str
    hatch: str
    dashes: Any
    name: str


LOOKS: dict[Status, Look] = {
    Status.OK: Look("#ffffff", "", "solid", "ok"),
    Status.NO_SOLUTION: Look("#b9bfc5", "xx", (0, (1.2, 1.6)), "no solution"),
    Status.ELEMENT_TOO_SHORT: Look("#d9c3e0", "--", (0, (1.2, 1.6)), "element too short"),
    Status.NO_CONTACT: Look("#e9ecef", "..", (0, (1.2, 2.2)), "no contact"),
    Status.OUTSIDE_VALIDITY: Look("#bfe0f5", "\\\\", (0, (6.5, 1.8, 1.2, 1.8)), "outside validity"),
    Status.YIELDED: Look("#fbd3b4", "//", (0, (3.6, 1.8)), "yielded"),
}


@dataclass(frozen=True)
class Drawing:
    """A figure with the words that go with it; ``caption`` is plain text."""

    name: str
    title: str
    figure: Figure
    caption: str

    def svg(self) -> str:
        """The figure as the text of an ``<svg>`` element, without XML prologue."""
        FigureCanvasSVG(self.figure)
        buffer = io.StringIO()
        with styled():
            self.figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": "varistiff"})
        text = re.sub(r"<metadata>.*?</metadata>\s*", "", buffer.getvalue(), count=1, flags=re.DOTALL)
        return text[text.index("<svg") :]

    def save_png(self, path: Path) -> None:
        """Write the figure as PNG."""
        FigureCanvasAgg(self.figure)
        with styled():
            self.figure.savefig(
                path,
                format="png",
                dpi=PNG_DPI,
                metadata={"Software": "varistiff"},
                pil_kwargs={"compress_level": 4},
            )


@contextmanager
def styled() -> Iterator[None]:
    """Everything drawn inside has the house style, whatever the user's own matplotlib settings say."""
    parameters: Any = matplotlib.rcParams  # the stubs of some versions allow known keys only
    with matplotlib.rc_context():
        defaults = {key: value for key, value in matplotlib.rcParamsDefault.items() if not key.startswith("backend")}
        dict.update(matplotlib.rcParams, defaults)  # already validated: checking them again takes longer than drawing
        parameters.update(_STYLE)
        yield


def canvas(*, width: float = WIDTH, height: float = HEIGHT, right: float = 0.76) -> tuple[Figure, Axes]:
    """Figure with one pair of axes; the column right of it stays free for a legend or a colour bar."""
    figure = Figure(figsize=(width, height))
    axes = figure.add_axes((0.118, 0.145, right - 0.118, 0.76))
    return figure, axes


def ramp(count: int) -> list[str]:
    """Colours of an ordered family of lines: viridis without its pale end."""
    colours = matplotlib.colormaps["viridis"]
    if count == 1:
        return [BLUE]
    return [to_hex(colours(0.86 * index / (count - 1))) for index in range(count)]
