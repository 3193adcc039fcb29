"""Deflection, load and stress against what the map calls safe."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from varistiff.core.status import Status
from varistiff.report.simulation.run import Run
from varistiff.report.simulation.safe_range import SAFE, SafeRange
from varistiff.report.simulation.timeline import Panel, Trace, draw_panel, key, sheet
from varistiff.report.style import BLUE, GREEN, LOOKS, SOFT, Drawing, styled
from varistiff.report.view import Array, View

ROOM = "#d7efe6"  # pale green; its edge is drawn too
MOST = 1000  # points of the edge of the safe area
TITLE = "Deflection and load in the safe area"
Band = tuple[Array, Array]


def draw(run: Run, characteristic: xr.Dataset) -> Drawing | None:
    """Draw deflection, load and stress over time inside their safe ranges; None without a deflection."""
    deflection, load, stress = run.given(run.stretch), run.telling("load"), run.telling("stress")
    if deflection is None:
        return None
    bands = SafeRange.of(characteristic).at(run.given("setting"), run.time.size)
    rows: list[tuple[Panel, Band | None]]
    rows = [(Panel("Deflection", run.unit(run.stretch), (Trace(deflection, "deflection", BLUE),)), bands[0])]
    if load is not None:
        rows.append((Panel(run.load_name, run.unit("load"), (Trace(load, "load", BLUE),)), bands[1]))
    strength = View.of(characteristic).strength
    if stress is not None:
        limits = (-math.inf, strength or math.inf)
        rows.append((Panel("Stress", run.unit("stress"), (Trace(stress, "largest stress", BLUE),), limits), None))
    with styled():
        figure, axes = sheet(run, [1.75] * len(rows), TITLE)
        for part, (panel, band) in zip(axes, rows, strict=True):
            _draw(run, part, panel, band)
    caption = (
        "Green: what the map of the design calls safe at the setting of each instant, from rest outwards; its edge is"
        " a status other than ok, or the end of the map."
    )
    if stress is not None and strength is not None:
        caption += " The limit of the stress is the strength of the elastic element."
    return Drawing("safe_area", TITLE, figure, caption)


def _draw(run: Run, axes: Axes, panel: Panel, band: Band | None) -> None:
    drawn = draw_panel(run, axes, panel)
    handles = drawn.handles
    if band is not None:
        step = max(run.time.size // MOST, 1)
        low, high = (edge[::step] * drawn.shown.factor for edge in band)
        axes.fill_between(run.x[::step], low, high, color=ROOM, linewidth=0.0, zorder=0.5)
        for edge in (low, high):
            axes.plot(run.x[::step], edge, color=GREEN, linewidth=1.2, zorder=1.0)
        _widen(axes, low, high)
        handles.append(Patch(facecolor=ROOM, edgecolor=GREEN, label="safe"))
    key(axes, [*handles, *_unsafe(run, axes)])


def _widen(axes: Axes, low: Array, high: Array) -> None:
    """Show an edge of the safe area that is not far away: at most three times what the lines need."""
    bottom, top = axes.get_ylim()
    reach = 3.0 * max(abs(bottom), abs(top))
    near = [float(value) for value in (np.nanmin(low), np.nanmax(high)) if abs(value) <= reach] if low.size else []
    room = 0.05 * (top - bottom)
    axes.set_ylim(min([bottom, *(value - room for value in near)]), max([top, *(value + room for value in near)]))


def _unsafe(run: Run, axes: Axes) -> list[Patch]:
    """Hatch the times at which the status is not safe; returns the key."""
    codes = run.given("status")
    handles = []
    for status in Status:
        here = np.zeros(0, bool) if codes is None else codes == status
        if status in SAFE or not here.any():
            continue
        look = LOOKS[status]
        across = axes.get_xaxis_transform()
        fill: dict[str, Any] = {"facecolor": look.fill, "hatch": look.hatch, "edgecolor": SOFT, "linewidth": 0.0}
        axes.fill_between(run.x, 0.0, 1.0, where=here.tolist(), transform=across, zorder=0.8, **fill)
        handles.append(Patch(facecolor=look.fill, hatch=look.hatch, edgecolor=SOFT, linewidth=0.7, label=look.name))
    return handles
