"""Families of curves whose dashes say which status holds along them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from varistiff.core.status import Status
from varistiff.report.display import number
from varistiff.report.style import LOOKS, SOFT
from varistiff.report.view import Array, Mask

LEGEND_X = 0.785
LOG_ABOVE = 12.0  # ratio beyond which a linear axis hides the low curves


@dataclass(frozen=True)
class Curve:
    """Points along one line, in shown units, with a status each."""

    x: Array
    y: Array
    status: npt.NDArray[np.int8]
    label: str
    colour: str


def draw_curves(axes: Axes, curves: Iterable[Curve]) -> set[Status]:
    """Draw each curve piecewise, solid where ok; returns the statuses that got ink."""
    inked: set[Status] = set()
    for order, curve in enumerate(curves):
        for status in Status:
            here = curve.status == status
            if not (here & np.isfinite(curve.y)).any():
                continue
            inked.add(status)
            ok = status is Status.OK
            axes.plot(
                curve.x,
                np.where(_reach(here, curve, status), curve.y, np.nan),
                color=curve.colour,
                linestyle=LOOKS[status].dashes,
                linewidth=2.3 if ok else 1.5,
                zorder=3.0 + 0.01 * order if ok else 2.5,
                dash_capstyle="butt",
            )
    return inked


def _reach(here: Mask, curve: Curve, status: Status) -> Mask:
    """Let a piece reach one point into an ok neighbour, so that the line has no gap; not across a jump."""
    if status is Status.OK:
        return here
    ok = curve.status == Status.OK
    span = float(np.ptp(curve.y[ok & np.isfinite(curve.y)])) if (ok & np.isfinite(curve.y)).any() else np.inf
    near = np.abs(np.diff(curve.y)) <= 0.2 * span + 0.2 * np.minimum(np.abs(curve.y[1:]), np.abs(curve.y[:-1]))
    wide = here.copy()
    wide[1:] |= here[:-1] & near
    wide[:-1] |= here[1:] & near
    return np.asarray(wide & (ok | here))


def curve_limits(curves: Iterable[Curve], *, room: float = 0.06) -> tuple[float, float] | None:
    """Range that shows every ok point: curves may run on, but they do not squeeze what can be used."""
    curves = list(curves)
    finite = [np.isfinite(curve.y) for curve in curves]
    good = [curve.y[mask & (curve.status == Status.OK)] for curve, mask in zip(curves, finite, strict=True)]
    every = np.concatenate([curve.y[mask] for curve, mask in zip(curves, finite, strict=True)] or [np.zeros(0)])
    inside = np.concatenate([*good, np.zeros(0)])
    if inside.size == 0:
        inside = every
    if inside.size == 0:
        return None
    low, high = float(inside.min()), float(inside.max())
    if high - low <= 1e-6 * abs(high):  # a constant: show it against zero
        return min(1.2 * high, -0.05 * abs(high)), max(1.2 * high, 0.05 * abs(high), 1e-300)
    span = high - low
    # let curves that are not ok be seen for a third more, if there are any out there
    low = max(float(every.min()), low - 0.3 * span)
    high = min(float(every.max()), high + 0.3 * span)
    return low - room * span, high + room * span


def wants_log(curves: Iterable[Curve]) -> bool:
    """Whether the ok points are all positive and far enough apart for a logarithmic axis."""
    good = np.concatenate([curve.y[(curve.status == Status.OK) & np.isfinite(curve.y)] for curve in curves])
    return bool(good.size and good.min() > 0.0 and good.max() > LOG_ABOVE * good.min())


def set_range(axes: Axes, curves: Iterable[Curve], *, log: bool) -> None:
    """Limit the vertical axis to what is worth seeing, on the scale asked for."""
    curves = list(curves)
    if not log:
        limits = curve_limits(curves)
        if limits:
            axes.set_ylim(*limits)
        return
    good = np.concatenate([curve.y[(curve.status == Status.OK) & np.isfinite(curve.y)] for curve in curves])
    margin = (float(good.max()) / float(good.min())) ** 0.06
    axes.set_yscale("log")
    axes.set_ylim(float(good.min()) / margin, float(good.max()) * margin)


def legends(
    figure: Figure,
    axes: Axes,
    curves: Iterable[Curve],
    *,
    title: str,
    inked: set[Status],
    x: float = LEGEND_X,
) -> None:
    """Legend of the family, and below it the dashes, in the free column right of the axes."""
    families = [Line2D([], [], color=curve.colour, linewidth=2.6, label=curve.label) for curve in curves]
    first = figure.legend(
        handles=families,
        title=title,
        loc="upper left",
        bbox_to_anchor=(x, 0.91),
        alignment="left",
        labelspacing=0.45,
    )
    first.set_zorder(5)
    if inked == {Status.OK}:
        return
    dashes = [
        Line2D(
            [],
            [],
            color=SOFT,
            linewidth=2.0 if status is Status.OK else 1.5,
            linestyle=LOOKS[status].dashes,
            label=LOOKS[status].name,
        )
        for status in Status
        if status in inked
    ]
    figure.legend(
        handles=dashes,
        title="Status",
        loc="lower left",
        bbox_to_anchor=(x, 0.135),
        alignment="left",
        labelspacing=0.45,
    )


def plain_numbers(axes: Axes, *, log: bool) -> None:
    """Numbers a person would write on both axes, also on a logarithmic vertical one."""
    formatter = FuncFormatter(lambda value, _: number(float(f"{value:.10g}")))
    if log:
        low, high = axes.get_ylim()
        decades = np.log10(high / low)
        subs = (1.0, 2.0, 5.0) if decades < 2.6 else (1.0,)
        axes.yaxis.set_major_locator(LogLocator(base=10.0, subs=subs, numticks=20))
        axes.yaxis.set_minor_locator(LogLocator(base=10.0, subs=tuple(np.arange(1.0, 10.0)), numticks=40))
        axes.yaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_major_formatter(formatter)
    axes.xaxis.set_major_formatter(formatter)


def zero_lines(axes: Axes, *, vertical: bool = True, horizontal: bool = True) -> None:
    """Thin lines through zero where zero lies inside the axes."""
    if horizontal and axes.get_ylim()[0] < 0.0 < axes.get_ylim()[1]:
        axes.axhline(0.0, color=SOFT, linewidth=0.9, zorder=1.5)
    if vertical and axes.get_xlim()[0] < 0.0 < axes.get_xlim()[1]:
        axes.axvline(0.0, color=SOFT, linewidth=0.9, zorder=1.5)
