"""One look for every mechanism drawing: colours, hatched ground, arrows with a label."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle

ELASTIC = "#c2410c"  # whatever bends or twists
RIGID = "#334155"
DRIVE = "#0369a1"  # what the stiffness drive moves
MUTED = "#94a3b8"
LABEL = {"fontsize": 11, "color": "#0f172a"}

Point = Sequence[float]


def sheet(width: float, height: float) -> tuple[Figure, Axes]:
    """Return a figure with one axis without frame, drawn to scale."""
    matplotlib.rcParams.update({"svg.hashsalt": "varistiff", "mathtext.fontset": "cm"})
    figure = Figure(figsize=(width, height), layout="constrained")
    axes = figure.add_subplot()
    axes.set_aspect("equal")
    axes.axis("off")
    return figure, axes


def _include(axes: Axes, *points: Point) -> None:
    """Widen the view: annotations do not."""
    axes.update_datalim(np.asarray(points, dtype=float))
    axes.autoscale_view()


def ground(axes: Axes, start: Point, end: Point, *, depth: float) -> None:
    """Draw a rigid wall from start to end, hatched to the left of that direction."""
    first, last = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    along = (last - first) / np.linalg.norm(last - first)
    back = depth * (np.array([-along[1], along[0]]) - along)
    axes.plot(*np.transpose([first, last]), color=RIGID, linewidth=2)
    for share in np.linspace(0.1, 1, 8):
        root = first + share * (last - first)
        axes.plot(*np.transpose([root, root + back]), color=RIGID, linewidth=0.8)


def dimension(axes: Axes, start: Point, end: Point, text: str, *, offset: Point = (0.0, 0.0)) -> None:
    """Draw a double arrow from start to end with its symbol at the middle, moved by offset."""
    style = {"arrowstyle": "<->", "color": MUTED, "shrinkA": 0, "shrinkB": 0, "linewidth": 1}
    axes.annotate("", xy=end, xytext=start, arrowprops=style)
    middle = (np.asarray(start) + np.asarray(end)) / 2 + np.asarray(offset)
    axes.text(*middle, text, ha="center", va="center", **LABEL)
    _include(axes, start, end, middle)


def arrow(axes: Axes, start: Point, end: Point, text: str, *, color: str = RIGID, offset: Point = (0.0, 0.0)) -> None:
    """Draw an arrow from start to end with its symbol at the tip, moved by offset."""
    style = {"arrowstyle": "-|>", "color": color, "shrinkA": 0, "shrinkB": 0, "linewidth": 1.6}
    axes.annotate("", xy=end, xytext=start, arrowprops=style)
    tip = np.asarray(end) + np.asarray(offset)
    axes.text(*tip, text, ha="center", va="center", fontsize=11, color=color)
    _include(axes, start, end, tip)


def angle(
    axes: Axes, centre: Point, radius: float, start: float, end: float, text: str, *, reach: float = 1.18
) -> None:
    """Draw an arc from start to end [rad] round centre with its symbol just outside."""
    axes.add_patch(Arc(centre, 2 * radius, 2 * radius, theta1=np.degrees(start), theta2=np.degrees(end), color=MUTED))
    middle = (start + end) / 2
    place = np.asarray(centre) + reach * radius * np.array([np.cos(middle), np.sin(middle)])
    axes.text(*place, text, ha="center", va="center", **LABEL)


def joint(axes: Axes, centre: Point, radius: float) -> None:
    """Draw a revolute joint seen along its axis."""
    axes.add_patch(Circle(centre, radius, facecolor="white", edgecolor=RIGID, linewidth=1.6, zorder=5))
