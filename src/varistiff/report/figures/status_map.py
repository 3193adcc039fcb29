"""Which status holds where: regions over deflection and setting, named in place."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from varistiff.report.figures.field import NUMBERS, fill_region, status_legend
from varistiff.report.style import LOOKS, Drawing, canvas, styled
from varistiff.report.view import Array, Mask, View

CELLS = 60  # of the grid that labels are placed on
TITLE = "Where the numbers may be used"


def draw(dataset: xr.Dataset) -> Drawing | None:
    """Draw the regions of status; a kind without a setting gets one band, and none where all of it is ok."""
    view = View.of(dataset)
    flat = view.setting is None or view.setting.size < 2
    if flat and view.ok.all():
        return None
    with styled():
        figure, axes = canvas(right=0.95, height=2.3 if flat else 4.5)
        axes.set_position((0.118, 0.46, 0.832, 0.36) if flat else (0.118, 0.205, 0.832, 0.70))
        axes.grid(visible=False)
        for side in ("top", "right"):
            axes.spines[side].set_visible(True)
        if flat:
            axes.set_yticks([])
        axes.set_xlim(float(view.x.min()), float(view.x.max()))
        y = np.array([0.0, 1.0]) if flat else view.y
        axes.set_ylim(float(y.min()), float(y.max()))
        axes.xaxis.set_major_formatter(NUMBERS)
        if not flat:
            axes.yaxis.set_major_formatter(NUMBERS)
        axes.set(xlabel=view.deflection_label, ylabel="" if flat else view.setting_label, title=TITLE)
        _regions(axes, view, y)
        status_legend(figure, view.statuses)
    shares = [f"{LOOKS[status].name} {100.0 * (view.status == status).mean():.3g} %" for status in view.statuses]
    caption = "Status of every point of the map: " + ", ".join(shares) + "."
    if view.unbounded_stress:
        caption += " The ideal stress is unbounded at a sharp corner of the section, so no point can count as yielded."
    return Drawing("status", TITLE, figure, caption)


def _regions(axes: Axes, view: View, y: Array) -> None:
    for status in view.statuses:
        mask = np.repeat(view.status == status, 2 if view.status.shape[0] == 1 else 1, axis=0)
        fill_region(axes, view.x, y, mask, status)
        name = LOOKS[status].name
        for spot in label_spots(mask, width=0.0165 * len(name) + 0.02, height=0.09 if y.size > 2 else 0.3):
            axes.text(
                *spot,
                name,
                transform=axes.transAxes,
                ha="center",
                va="center",
                fontsize=11.5,
                fontweight="bold",
                zorder=5.0,
                bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "boxstyle": "round,pad=0.2"},
            )


def label_spots(mask: Mask, *, width: float, height: float, most: int = 3) -> list[tuple[float, float]]:
    """Middle of the roomiest place for a label in each connected region; all in fractions of the axes."""
    left = _pooled(mask)
    spots: list[tuple[float, float]] = []
    while len(spots) < most:
        spot = _roomiest(left, width=width, height=height)
        if spot is None:
            break
        spots.append(spot)
        _erase(left, (int(spot[1] * CELLS), int(spot[0] * CELLS)))
    return spots


def _pooled(mask: Mask) -> Mask:
    """Coarse grid of the cells that lie wholly inside the region, so that no label crosses a thin one."""
    pooled = np.asarray(mask)
    for axis, size in enumerate(mask.shape):
        edges = np.linspace(0, size, CELLS + 1)
        first = np.minimum(edges[:-1].astype(int), size - 1)
        last = np.maximum(np.ceil(edges[1:]).astype(int), first + 1)
        total = np.cumsum(np.insert(pooled.astype(int), 0, 0, axis=axis), axis=axis)
        inside = np.take(total, last, axis=axis) - np.take(total, first, axis=axis)
        shape = [-1 if index == axis else 1 for index in range(2)]
        pooled = inside == (last - first).reshape(shape)
    return pooled


def _roomiest(grid: Mask, *, width: float, height: float) -> tuple[float, float] | None:
    """Enlarge the label's box until it fits nowhere; the last place where it fitted is the roomiest."""
    total = np.zeros((CELLS + 1, CELLS + 1))
    total[1:, 1:] = np.cumsum(np.cumsum(grid, axis=0), axis=1)
    best: tuple[float, float] | None = None
    for scale in np.linspace(1.0, 10.0, 37):
        tall, wide = (max(int(np.ceil(size * scale * CELLS)), 1) for size in (height, width))
        if tall > CELLS or wide > CELLS:
            break
        inside = total[tall:, wide:] - total[:-tall, wide:] - total[tall:, :-wide] + total[:-tall, :-wide]
        spots = np.argwhere(inside == tall * wide)
        if not spots.size:
            break
        row, column = spots[np.argmin(np.square(spots - spots.mean(axis=0)).sum(axis=1))]
        best = ((column + 0.5 * wide) / CELLS, (row + 0.5 * tall) / CELLS)
    return best


def _erase(grid: Mask, start: tuple[int, int]) -> None:
    """Take the connected region around a cell out of the grid."""
    queue = [start]
    while queue:
        row, column = queue.pop()
        if 0 <= row < CELLS and 0 <= column < CELLS and grid[row, column]:
            grid[row, column] = False
            queue += [(row + 1, column), (row - 1, column), (row, column + 1), (row, column - 1)]
