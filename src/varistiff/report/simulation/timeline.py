"""Panels over a common time axis, with events marked above and a key to the right of each."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator, ScalarFormatter
from matplotlib.transforms import blended_transform_factory

from varistiff.dynamics.outcome import Outcome
from varistiff.report.display import Display
from varistiff.report.figures.curves import plain_numbers, zero_lines
from varistiff.report.simulation.run import Run
from varistiff.report.style import SOFT, VERMILION, WIDTH
from varistiff.report.view import Array

LEFT, RIGHT = 0.165, 0.755  # of the figure's width
KEY = 0.775
HEAD, STRIP, FOOT, GAP = 0.46, 0.20, 0.62, 0.20  # inches
MOST_POINTS = 2000  # of a line; more are thinned to the extremes of as many spans
MOST_MARKS = 40
DIGIT = 0.019  # width of a digit above the panels, of the time axis
LIMIT: Any = (0, (5.0, 2.0))
WANTED: Any = (0, (4.0, 1.6))
ASTRAY = (Outcome.UNSTABLE, Outcome.STEP_TOO_LARGE)
ASTRAY_SHOWN = 10.0  # times what was before: as much of what comes after a run went astray is shown
REACHED = 0.4  # of a limit that a signal must reach for the axis to show the limit


@dataclass(frozen=True)
class Trace:
    """One line over time, in SI."""

    values: Array
    label: str
    colour: str
    dashes: Any = "solid"
    width: float = 2.0


@dataclass(frozen=True)
class Panel:
    """What one pair of axes shows, in SI; ``limits`` are drawn where the lines come near them."""

    name: str
    unit: str
    traces: tuple[Trace, ...]
    limits: tuple[float, float] = (-math.inf, math.inf)


def sheet(run: Run, heights: Sequence[float], title: str) -> tuple[Figure, list[Axes]]:
    """Axes below each other with one time axis, heights in inches; events and the stamp are drawn already."""
    strip = STRIP if run.events else 0.0
    tall = HEAD + strip + sum(heights) + GAP * (len(heights) - 1) + FOOT
    figure = Figure(figsize=(WIDTH, tall))
    figure.text(LEFT, 1.0 - 0.08 / tall, title, fontsize=12.5, fontweight="bold", va="top")
    top, axes = tall - HEAD - strip, []
    for height in heights:
        box = (LEFT, (top - height) / tall, RIGHT - LEFT, height / tall)
        axes.append(figure.add_axes(box))
        top -= height + GAP
    ends = run.x[0], run.x[-1] if run.x[-1] > run.x[0] else run.x[0] + 1.0
    for number, part in enumerate(axes, start=1):
        part.set_xlim(*ends)
        part.tick_params(labelbottom=number == len(axes))
    axes[-1].set_xlabel(f"Time [{run.time_display.unit}]")
    _mark_events(run, axes, tall)
    if not run.done:
        for part in axes:
            part.axvline(run.stopped_at * run.time_display.factor, color=VERMILION, linewidth=2.0, zorder=2.2)
    stamp(figure, run)
    return figure, axes


def stamp(figure: Figure, run: Run) -> None:
    """Mark a picture of a run that is no result, so that it cannot pass for one on its own."""
    if run.stamp:
        height = float(figure.get_figheight())
        figure.text(
            0.985,
            1.0 - 0.08 / height,
            run.stamp,
            fontsize=10.5,
            fontweight="bold",
            color=VERMILION,
            ha="right",
            va="top",
            bbox={"facecolor": "white", "edgecolor": VERMILION, "linewidth": 1.0, "pad": 2.5},
        )


def draw_panels(run: Run, panels: Sequence[Panel], title: str, *, height: float = 1.75) -> Figure:
    """One figure with a panel below the other."""
    figure, axes = sheet(run, [height] * len(panels), title)
    for part, panel in zip(axes, panels, strict=True):
        key(part, draw_panel(run, part, panel).handles)
    return figure


@dataclass(frozen=True)
class Drawn:
    """What drawing a panel leaves to do: its key, and the unit that other things in it are drawn in."""

    shown: Display
    handles: list[Any]


def draw_panel(run: Run, axes: Axes, panel: Panel) -> Drawn:
    """Draw the lines of a panel and its limits."""
    shown = run.shown(panel.unit, [trace.values for trace in panel.traces])
    handles: list[Any] = []
    for trace in panel.traces:
        x, y = thinned(run.x, trace.values * shown.factor)
        handles += axes.plot(
            x, y, color=trace.colour, linestyle=trace.dashes, linewidth=trace.width, label=trace.label, zorder=3.0
        )
    low, high = span(run, panel)
    handles += _limits(axes, panel, shown, (low, high))
    axes.set_ylim(low * shown.factor, high * shown.factor)
    finish(axes, panel.name, shown)
    return Drawn(shown, handles)


def finish(axes: Axes, name: str, shown: Display, *, log: bool = False) -> None:
    """Axis label on two lines, plain numbers, and a line through zero."""
    axes.set_ylabel(f"{name}\n[{shown.unit}]" if shown.unit else name, fontsize=11.0)
    plain_numbers(axes, log=log)
    if not log:
        axes.yaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]))
        numbers = ScalarFormatter(useOffset=False)  # as many digits as tell two ticks apart
        numbers.set_powerlimits((-3, 4))
        axes.yaxis.set_major_formatter(numbers)
    zero_lines(axes, vertical=False, horizontal=not log)


def key(axes: Axes, handles: Sequence[Any]) -> None:
    """Legend in the free column right of the axes."""
    if handles:
        place = ((KEY - LEFT) / (RIGHT - LEFT), 1.02)
        axes.legend(handles=handles, loc="upper left", bbox_to_anchor=place, labelspacing=0.35, handlelength=1.7)


def span(run: Run, panel: Panel) -> tuple[float, float]:
    """Range of the vertical axis in SI: every line, and a limit that they come near.

    What comes after a run went astray does not squeeze what came before.
    """
    values = np.concatenate([trace.values[np.isfinite(trace.values)] for trace in panel.traces] or [np.zeros(0)])
    if not values.size:
        return -1.0, 1.0
    low, high = float(values.min()), float(values.max())
    if run.simulation.outcome in ASTRAY:
        before = run.time <= run.stopped_at
        early = [trace.values[before & np.isfinite(trace.values)] for trace in panel.traces]
        usual = ASTRAY_SHOWN * float(np.abs(np.concatenate(early)).max(initial=0.0))
        if usual > 0.0:
            low, high = max(low, -usual), min(high, usual)
    bottom, top = panel.limits
    if math.isfinite(top) and high > 0.0 and high >= REACHED * top:
        high = max(high, top)
    if math.isfinite(bottom) and low < 0.0 and low <= REACHED * bottom:
        low = min(low, bottom)
    if high - low <= 1e-9 * max(abs(low), abs(high)):  # a constant: show it against zero
        low, high = min(1.2 * high, 0.0), max(1.2 * high, 0.0)
        if low == high:
            low, high = -1.0, 1.0
    room = 0.07 * (high - low)
    return low - room, high + room


def _limits(axes: Axes, panel: Panel, shown: Display, ends: tuple[float, float]) -> list[Line2D]:
    """Lines at the limits; one that lies outside the axis is told in the key."""
    handles, outside = [], []
    for limit in panel.limits:
        if not math.isfinite(limit):
            continue
        if ends[0] <= limit <= ends[1]:
            line = axes.axhline(limit * shown.factor, color=VERMILION, linewidth=1.5, linestyle=LIMIT, zorder=2.5)
            line.set_label("limit")
            handles.append(line)
        else:
            outside.append(limit)
    if handles:
        return handles[:1]
    if not outside:
        return []
    both = len(outside) == 2 and outside[0] == -outside[1]
    text = f"\N{PLUS-MINUS SIGN}{shown.text(outside[1])}" if both else " and ".join(map(shown.text, outside))
    return [Line2D([], [], color=VERMILION, linewidth=1.5, linestyle=LIMIT, label=f"limit {text}:\noff the axis")]


def thinned(time: Array, values: Array, most: int = MOST_POINTS) -> tuple[Array, Array]:
    """Keep the lowest and highest value of each span of time, so that no peak is lost; NaN stays a gap."""
    count = values.size
    if count <= most:
        return time, values
    edges = np.linspace(0, count, most // 2 + 1).astype(int)[:-1]
    filled = [np.where(np.isfinite(values), values, fill) for fill in (np.inf, -np.inf)]
    kept = [0, count - 1]
    for first, last in zip(edges, [*edges[1:], count], strict=True):
        kept += [first + int(np.argmin(filled[0][first:last])), first + int(np.argmax(filled[1][first:last]))]
    chosen = np.unique(np.concatenate([kept, np.flatnonzero(np.diff(np.isfinite(values).astype(int)) != 0)]))
    return time[chosen], values[chosen]


def _mark_events(run: Run, axes: Sequence[Axes], height: float) -> None:
    """Thin lines where something happened; numbers as in the table, one for events that lie close together."""
    events = run.events
    if not events:
        return
    places = [event.time * run.time_display.factor for event in events]
    many = len(events) > MOST_MARKS
    for part in axes:
        across = blended_transform_factory(part.transData, part.transAxes)
        heights = ([0.94] if many else [0.0]) * len(places)
        part.vlines(
            places, heights, 1.0, transform=across, color=SOFT, linewidth=0.9, linestyle=(0, (1.2, 1.8)), zorder=1.8
        )
    low, high = axes[0].get_xlim()
    above = blended_transform_factory(axes[0].transData, axes[0].transAxes)
    inch = 1.0 / float(axes[0].get_position().height * height)
    for group in clusters(places, DIGIT * (high - low)):
        axes[0].text(
            group[2],
            1.0 + 0.045 * inch,
            _label(group),
            transform=above,
            ha="center",
            va="bottom",
            fontsize=9.5,
            color=SOFT,
        )


def clusters(places: Sequence[float], digit: float) -> list[tuple[int, int, float]]:
    """First and last number, counted from 1, and middle of events whose labels, of digits so wide, would meet."""
    groups: list[tuple[int, int, float]] = []
    for number, place in enumerate(places, start=1):
        groups.append((number, number, place))
        while len(groups) > 1 and groups[-1][2] - groups[-2][2] < digit * (
            1.0 + 0.5 * (_wide(groups[-1]) + _wide(groups[-2]))
        ):
            (_, last, _), (first, _, _) = groups.pop(), groups.pop()
            groups.append((first, last, 0.5 * (places[first - 1] + places[last - 1])))
    return groups


def _label(group: tuple[int, int, float]) -> str:
    first, last, _ = group
    return f"{first}" if first == last else f"{first}\N{EN DASH}{last}"


def _wide(group: tuple[int, int, float]) -> int:
    return len(_label(group))
