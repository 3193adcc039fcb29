"""The path of a run over the map of its design."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from varistiff.core.status import Status
from varistiff.report.figures.field import NUMBERS, field_canvas, fill_region, status_legend
from varistiff.report.simulation.figures.stiffness import varies
from varistiff.report.simulation.run import Run
from varistiff.report.simulation.timeline import MOST_POINTS, stamp
from varistiff.report.style import INK, SOFT, Drawing, styled
from varistiff.report.view import Array, View

TITLE = "Path over the map"


def draw(run: Run, characteristic: xr.Dataset) -> Drawing | None:
    """Draw deflection against setting over the statuses of the map; None where the setting does not change."""
    view, setting, deflection = View.of(characteristic), run.given("setting"), run.given(run.stretch)
    if view.setting is None or view.setting.size < 2 or deflection is None or setting is None or not varies(setting):
        return None
    x, y = deflection * view.deflection_display.factor, setting * view.setting_display.factor
    with styled():
        figure, axes = field_canvas()
        _map(axes, view)
        _path(figure, axes, run, x, y)
        axes.set_xlim(*_around(view.x, x))
        axes.set_ylim(*_around(view.y, y))
        axes.set(xlabel=view.deflection_label, ylabel=f"{run.setting_name} [{view.setting_display.unit}]", title=TITLE)
        present = [status for status in view.statuses if status is not Status.OK]
        if present:
            status_legend(figure, present)
        stamp(figure, run)
    caption = (
        "Deflection and setting of the run over the map of the design, coloured by time: circle at the start, square"
        " at the end. White is ok; hatched is not; beyond the frame nothing was mapped."
    )
    return Drawing("map_path", TITLE, figure, caption)


def _map(axes: Axes, view: View) -> None:
    for status in view.statuses:
        if status is not Status.OK:
            fill_region(axes, view.x, view.y, view.status == status, status)
    low, high = (view.x.min(), view.y.min()), (view.x.max(), view.y.max())
    frame = np.array([low, (high[0], low[1]), high, (low[0], high[1]), low])
    axes.plot(frame[:, 0], frame[:, 1], color=SOFT, linewidth=1.0, zorder=3.0)
    axes.xaxis.set_major_formatter(NUMBERS)
    axes.yaxis.set_major_formatter(NUMBERS)


def _path(figure: Figure, axes: Axes, run: Run, x: Array, y: Array) -> None:
    step = max(x.size // (2 * MOST_POINTS), 1)
    points = np.stack([x, y], axis=1)[::step]
    under = LineCollection([points], colors="white", linewidths=4.0, zorder=4.0, rasterized=True)
    axes.add_collection(under, autolim=False)
    pieces = np.stack([points[:-1], points[1:]], axis=1)
    line = LineCollection(list(pieces), cmap=colormaps["viridis"], linewidths=2.2, zorder=4.1, rasterized=True)
    line.set_array(run.x[::step][:-1])
    axes.add_collection(line, autolim=False)
    known = np.flatnonzero(np.isfinite(x) & np.isfinite(y))
    for index, marker in ((known[0], "o"), (known[-1], "s")):
        axes.plot(x[index], y[index], marker=marker, color="white", markeredgecolor=INK, markersize=8.0, zorder=5.0)
    bar = figure.colorbar(line, cax=figure.add_axes((0.80, 0.205, 0.026, 0.70)))
    bar.outline.set_linewidth(0.6)
    bar.ax.set_ylabel(f"Time [{run.time_display.unit}]", labelpad=8)
    bar.ax.yaxis.set_major_formatter(NUMBERS)


def _around(grid: Array, path: Array) -> tuple[float, float]:
    """The map, and as much of a path that leaves it as the map is wide."""
    low, high = float(grid.min()), float(grid.max())
    wide = high - low
    least, most = max(float(np.nanmin(path)), low - wide), min(float(np.nanmax(path)), high + wide)
    room = 0.03 * wide
    return min(low, least) - room, max(high, most) + room
