"""Fields over deflection and setting: colour, contours with numbers, and a veil over points that are not ok."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch, Rectangle
from matplotlib.ticker import FuncFormatter, MaxNLocator

from varistiff.core.status import Status
from varistiff.report.display import number
from varistiff.report.style import INK, LOOKS, SOFT, canvas
from varistiff.report.view import Array, Mask, View

NUMBERS = FuncFormatter(lambda value, _: number(float(f"{value:.10g}")))
MOST_CELLS = 140  # per axis: finer than the picture's pixels is wasted time


def field_canvas() -> tuple[Figure, Axes]:
    """Figure for one field; the colour bar and the legend stand to the right."""
    figure, axes = canvas(right=0.775)
    axes.set_position((0.118, 0.205, 0.657, 0.70))
    axes.grid(visible=False)
    for side in ("top", "right"):
        axes.spines[side].set_visible(True)
    return figure, axes


def draw_field(figure: Figure, axes: Axes, view: View, values: Array, *, label: str, colours: str = "viridis") -> None:
    """Colour a field of shape (setting, deflection) with a colour bar; ok points set the range of colours."""
    finite = np.isfinite(values)
    telling = finite & view.ok
    shown = values[telling] if telling.any() else values[finite]
    low, high = float(shown.min()), float(shown.max())
    if low < 0.0 < high and min(-low, high) > 0.02 * (high - low):
        high = max(-low, high)
        low, colours = -high, "PuOr"
    elif low < 0.0:
        colours += "_r"  # bright is always the larger magnitude
    if high <= low:
        high = low + (abs(low) or 1.0)
    rows, columns = (slice(None, None, max(size // MOST_CELLS, 1)) for size in values.shape)
    mesh = axes.pcolormesh(
        view.x[columns],
        view.y[rows],
        np.ma.masked_invalid(values[rows, columns]),
        cmap=matplotlib.colormaps[colours],
        norm=Normalize(low, high),
        shading="nearest",
        rasterized=True,
        zorder=1.0,
    )
    _frame(axes, view)
    levels = np.asarray(MaxNLocator(6).tick_values(low, high), float)
    edge = 0.02 * (high - low)  # a contour that close to the end of the range says nothing
    levels = levels[(levels > low + edge) & (levels < high - edge)]
    if levels.size and min(values.shape) > 2:
        _contours(axes, view, values, levels, colour=INK if colours == "PuOr" else "white")
    bar = figure.colorbar(mesh, cax=figure.add_axes((0.80, 0.205, 0.026, 0.70)))
    bar.outline.set_linewidth(0.6)
    bar.ax.set_ylabel(label, labelpad=8)
    bar.ax.yaxis.set_major_formatter(NUMBERS)


def _contours(axes: Axes, view: View, values: Array, levels: Array, *, colour: str) -> None:
    """Contours with numbers, kept off the frame and off points that are not ok."""
    field = np.ma.masked_invalid(values)
    lines = axes.contour(
        view.x, view.y, field, levels=levels, colors=colour, linewidths=1.0, linestyles="solid", zorder=2.0
    )
    for text in axes.clabel(lines, fontsize=9.5, inline=False, fmt=lambda value: number(float(f"{value:.6g}"))):
        place = axes.transAxes.inverted().transform(axes.transData.transform(text.get_position()))
        row, column = (
            int(np.rint(np.clip(part, 0, 1) * (size - 1))) for part, size in zip(place[::-1], values.shape, strict=True)
        )
        if place.min() < 0.06 or place.max() > 0.94 or (view.ok.any() and not view.ok[row, column]):
            text.set_visible(False)
        text.set_bbox(
            {
                "facecolor": (0.1, 0.12, 0.14, 0.55) if colour == "white" else (1.0, 1.0, 1.0, 0.7),
                "edgecolor": "none",
                "boxstyle": "round,pad=0.15",
            }
        )


def _frame(axes: Axes, view: View) -> None:
    axes.set_xlim(float(view.x.min()), float(view.x.max()))
    axes.set_ylim(float(view.y.min()), float(view.y.max()))
    axes.set(xlabel=view.deflection_label, ylabel=view.setting_label)
    axes.xaxis.set_major_formatter(NUMBERS)
    axes.yaxis.set_major_formatter(NUMBERS)


def veil(figure: Figure, axes: Axes, view: View) -> None:
    """Cover what is not ok with its hatch, draw the edge of what is, and name the hatches below the axes."""
    present = [status for status in view.statuses if status is not Status.OK]
    if not present:
        return
    for status in present:
        fill_region(axes, view.x, view.y, view.status == status, status)
    status_legend(figure, present)


def fill_region(axes: Axes, x: Array, y: Array, mask: Mask, status: Status) -> None:
    """Fill, hatch and outline the points under a mask."""
    if min(mask.shape) < 2:
        return
    look = LOOKS[status]
    if mask.all():
        axes.add_patch(
            Rectangle((0, 0), 1, 1, transform=axes.transAxes, facecolor=look.fill, hatch=look.hatch, zorder=2.4)
        )
        return
    level = smooth(mask)
    axes.contourf(x, y, level, levels=[0.5, 1.5], colors=[look.fill], hatches=[look.hatch], zorder=2.4)
    axes.contour(x, y, level, levels=[0.5], colors=INK, linewidths=1.2, zorder=3.0)


def smooth(mask: Mask) -> Array:
    """Mask as numbers whose 0.5 contour runs between the steps of the grid; thin regions stay as they are."""
    level = np.asarray(mask, float)
    for axis, size in enumerate(mask.shape):
        level = _running_mean(level, half=max(size // (45 if axis == 0 else 120), 1), axis=axis)
    kept = ((level >= 0.5) & mask).sum()
    return level if kept >= 0.97 * mask.sum() else np.asarray(mask, float)


def _running_mean(values: Array, *, half: int, axis: int) -> Array:
    padding = [(half, half) if index == axis else (0, 0) for index in range(values.ndim)]
    padded = np.pad(values, padding, mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * half + 1, axis=axis)
    return np.asarray(windows.mean(axis=-1))


def status_legend(figure: Figure, present: Sequence[Status]) -> None:
    """Patches for the statuses that occur, in one row under the axes."""
    handles = [
        Patch(
            facecolor=LOOKS[status].fill,
            hatch=LOOKS[status].hatch,
            edgecolor=SOFT,
            linewidth=0.7,
            label=LOOKS[status].name,
        )
        for status in present
    ]
    figure.legend(
        handles=handles,
        loc="lower left",
        bbox_to_anchor=(0.118 if len(handles) < 4 else 0.012, 0.012),
        ncols=len(handles),
        columnspacing=1.1,
        handlelength=1.5,
        handleheight=1.1,
        handletextpad=0.5,
    )
