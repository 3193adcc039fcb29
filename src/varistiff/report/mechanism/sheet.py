"""The drawing sheet of a mechanism: equal scales, a scale bar, and the parts that several kinds share."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch, Polygon, Rectangle

from varistiff.core.status import Status
from varistiff.report.display import display, number
from varistiff.report.style import FAINT, INK, LOOKS, METAL, METAL_LIGHT, SOFT, WIDTH, ramp
from varistiff.report.view import Array, View

MM = 1e3  # drawings are in millimetres
REST = "#9aa3ab"


@dataclass(frozen=True)
class Pose:
    """One state of the mechanism to draw; SI units, ``setting`` 0 where the kind has none."""

    deflection: float
    setting: float
    label: str
    colour: str
    row: int = 0  # of the map
    column: int = 0


@dataclass(frozen=True)
class Bounds:
    """Rectangle that a panel shows, in millimetres."""

    left: float
    right: float
    bottom: float
    top: float

    @staticmethod
    def around(*points: Array, margin: float = 0.05) -> Bounds:
        """Smallest rectangle around points of shape (N, 2), with a margin relative to its larger side."""
        every = np.concatenate([np.atleast_2d(part) for part in points])
        low, high = every.min(axis=0), every.max(axis=0)
        room = margin * float((high - low).max())
        return Bounds(low[0] - room, high[0] + room, low[1] - room, high[1] + room)

    @property
    def width(self) -> float:
        """Horizontal extent."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Vertical extent."""
        return self.top - self.bottom


def poses_at(view: View, row: int, count: int = 3) -> list[Pose]:
    """States at one setting, from rest to the last ok deflection (of the side that reaches further)."""
    setting = 0.0 if view.setting is None else float(view.setting[row])
    good = np.flatnonzero(view.ok[row])
    if good.size:
        end = float(view.deflection[good[np.argmax(np.abs(view.deflection[good]))]])
        if abs(view.deflection[good[-1]]) >= 0.999 * abs(end):  # symmetric: draw the positive side
            end = float(view.deflection[good[-1]])
    else:
        end = float(view.deflection[-1])
    load = np.atleast_2d(np.asarray(view.dataset[view.load_name].values, float))[row]
    unit = display(
        str(view.dataset[view.load_name].attrs.get("units", "N*m")),
        float(np.nanmax(np.abs(load), initial=0.0)),
    )
    poses: list[Pose] = []
    for order, (part, colour) in enumerate(zip(np.linspace(0.0, 1.0, count), [REST, *ramp(4)[1:3]], strict=False)):
        column = int(np.argmin(np.abs(view.deflection - part * end)))
        status = Status(int(view.status[row, column]))
        text = f"{view.deflection_text(column)}: {unit.text(float(load[column]))}"
        if status is not Status.OK:
            text += f" ({LOOKS[status].name})"
        if order == 0 or float(view.deflection[column]) != poses[-1].deflection:
            poses.append(Pose(float(view.deflection[column]), setting, text, colour, row, column))
    return poses


def end_rows(view: View) -> list[int]:
    """Rows of the smallest and the largest setting that have ok points."""
    rows = view.some_settings(2)
    return [rows[0], rows[-1]] if rows[0] != rows[-1] else rows[:1]


def panels(
    bounds: Bounds,
    count: int,
    *,
    titles: Sequence[str],
    poses: Sequence[Sequence[Pose]] = (),
    scaled: bool = True,
) -> tuple[Figure, list[Axes]]:
    """Panels of one scale, stacked where the mechanism is wide and side by side where it is not.

    Each panel carries its title, and the key of its own poses above the drawing.
    """
    stacked = bounds.height < 0.5 * bounds.width or count == 1
    columns, rows = (1, count) if stacked else (count, 1)
    keys = max((len(group) for group in poses), default=0)
    head = 0.36 + (0.0 if not keys else 0.25 if stacked else 0.21 * keys)  # inches above each panel
    foot, side = 0.62, 0.12
    wide = (WIDTH - side * (columns + 1)) / columns
    if scaled:  # room for the scale bar below the mechanism
        bounds = replace(bounds, bottom=bounds.bottom - 0.34 * bounds.width / wide)
    tall = float(np.clip(wide * bounds.height / bounds.width, 0.8, 4.4))
    height = rows * (tall + head) + foot + 0.04
    figure = Figure(figsize=(WIDTH, height))
    axes = []
    for index in range(count):
        column, row = (0, index) if stacked else (index, 0)
        left = side + column * (wide + side)
        bottom = height - 0.04 - (row + 1) * (tall + head)
        part = figure.add_axes((left / WIDTH, bottom / height, wide / WIDTH, tall / height))
        part.set_axis_off()
        _show(part, bounds, wide / tall)
        figure.text(
            left / WIDTH,
            (bottom + tall + head - 0.05) / height,
            titles[index],
            fontsize=12.0,
            fontweight="bold",
            va="top",
        )
        if keys:
            handles = [Line2D([], [], color=pose.colour, linewidth=3.0, label=pose.label) for pose in poses[index]]
            figure.legend(
                handles=handles,
                loc="upper left",
                bbox_to_anchor=(left / WIDTH, (bottom + tall + head - 0.3) / height),
                ncols=len(handles) if stacked else 1,
                columnspacing=1.8,
                labelspacing=0.3,
                handlelength=1.8,
            )
        if scaled:
            scale_bar(part)
        axes.append(part)
    return figure, axes


def _show(axes: Axes, bounds: Bounds, shape: float) -> None:
    """Widen the shorter side of the bounds to the shape of the axes, so that both scales are equal."""
    middle = (0.5 * (bounds.left + bounds.right), 0.5 * (bounds.bottom + bounds.top))
    width = max(bounds.width, bounds.height * shape)
    shown = replace(
        bounds,
        left=middle[0] - width / 2,
        right=middle[0] + width / 2,
        bottom=middle[1] - width / shape / 2,
        top=middle[1] + width / shape / 2,
    )
    axes.set_xlim(shown.left, shown.right)
    axes.set_ylim(shown.bottom, shown.top)
    axes.set_aspect("equal")


def scale_bar(axes: Axes) -> None:
    """A bar of a round length in the lower right corner."""
    left, right = axes.get_xlim()
    bottom, _ = axes.get_ylim()
    span = right - left
    power = 10.0 ** math.floor(math.log10(0.25 * span))
    length = max(step * power for step in (1.0, 2.0, 5.0) if step * power <= 0.25 * span)
    x, y = right - 0.015 * span - length, bottom + 0.012 * span
    axes.plot([x, x + length], [y, y], color=INK, linewidth=2.6, solid_capstyle="butt", zorder=9)
    axes.text(
        x + length / 2,
        y + 0.012 * span,
        f"{number(length)} mm",
        ha="center",
        va="bottom",
        fontsize=10.5,
        zorder=9,
        bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.6},
    )


def legend(figure: Figure, parts: Sequence[tuple[str, str, str]]) -> None:
    """Key of the parts below the panels, as (name, colour, "patch" | "wall" | "line" | "dash" | "round")."""
    handles: list[Line2D | Patch] = []
    for name, colour, look in parts:
        if look in ("patch", "wall"):
            hatch = "////" if look == "wall" else ""
            handles.append(Patch(facecolor=colour, edgecolor=INK, linewidth=0.7, hatch=hatch, label=name))
        elif look == "round":
            handles.append(
                Line2D(
                    [],
                    [],
                    color=INK,
                    marker="o",
                    markersize=8.5,
                    markerfacecolor=colour,
                    markeredgewidth=1.0,
                    linestyle="none",
                    label=name,
                )
            )
        else:
            style: Any = "solid" if look == "line" else (0, (6, 2, 1.2, 2))
            handles.append(Line2D([], [], color=colour, linewidth=1.6, linestyle=style, label=name))
    figure.legend(
        handles=handles,
        loc="lower center",
        ncols=4,
        columnspacing=1.6,
        handlelength=1.6,
        labelspacing=0.35,
        bbox_to_anchor=(0.5, 0.05 / float(figure.get_figheight())),
    )


def strip(axes: Axes, centreline: Array, thickness: float, *, colour: str, zorder: float = 4.0) -> None:
    """An elastic element of true thickness, but never thinner than a line that can be seen; millimetres."""
    axes.plot(centreline[:, 0], centreline[:, 1], color=colour, linewidth=1.8, zorder=zorder, solid_capstyle="butt")
    along = np.gradient(centreline, axis=0)
    size = np.hypot(along[:, 0], along[:, 1])
    across = np.stack([-along[:, 1], along[:, 0]], axis=1) / np.where(size > 0.0, size, 1.0)[:, None]
    half = 0.5 * thickness * across
    outline = np.concatenate([centreline + half, (centreline - half)[::-1]])
    # the axes have their limits: add_patch would look for the outline's, slowly
    axes.add_artist(Polygon(outline, closed=True, facecolor=colour, edgecolor="none", zorder=zorder))


def block(
    axes: Axes,
    centre: Array,
    width: float,
    height: float,
    angle: float = 0.0,
    *,
    colour: str = METAL,
    hatch: str = "",
    zorder: float = 3.0,
) -> None:
    """A rectangular part about its centre, turned by an angle [rad]."""
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * (0.5 * width, 0.5 * height)
    axes.add_patch(
        Polygon(
            centre + corners @ rotation(angle).T,
            closed=True,
            facecolor=colour,
            edgecolor=INK,
            linewidth=0.8,
            hatch=hatch,
            zorder=zorder,
        )
    )


def disc(
    axes: Axes,
    centre: Array,
    radius: float,
    *,
    colour: str = METAL_LIGHT,
    edge: str = INK,
    width: float = 1.1,
    zorder: float = 5.0,
    fill: bool = True,
) -> None:
    """A round part."""
    axes.add_patch(
        Circle(
            (float(centre[0]), float(centre[1])),
            radius,
            facecolor=colour if fill else "none",
            edgecolor=edge,
            linewidth=width,
            zorder=zorder,
        )
    )


def joint(axes: Axes, centre: Array, radius: float) -> None:
    """A revolute joint."""
    disc(axes, centre, radius, colour="white", width=1.6, zorder=7.0)
    disc(axes, centre, 0.28 * radius, colour=INK, zorder=7.1)


def bar(axes: Axes, points: Array, width: float, *, colour: str = FAINT, zorder: float = 1.0) -> None:
    """A rigid link of some width along a polyline."""
    left, right = axes.get_xlim()
    points_per_unit = 72.0 * WIDTH * float(axes.get_position().width) / (right - left)
    axes.plot(
        points[:, 0],
        points[:, 1],
        color=colour,
        linewidth=width * points_per_unit,
        solid_capstyle="round",
        solid_joinstyle="round",
        zorder=zorder,
    )


def axis_line(axes: Axes, points: Array, *, colour: str = SOFT, zorder: float = 2.0) -> None:
    """A centre line: dash and dot."""
    axes.plot(
        points[:, 0],
        points[:, 1],
        color=colour,
        linewidth=1.0,
        linestyle=(0, (8, 2.5, 1.2, 2.5)),
        zorder=zorder,
    )


def wall(axes: Axes, left: float, bottom: float, width: float, height: float) -> None:
    """Something fixed: hatched."""
    axes.add_patch(
        Rectangle(
            (left, bottom),
            width,
            height,
            facecolor=METAL_LIGHT,
            edgecolor=INK,
            hatch="////",
            linewidth=0.8,
            zorder=3.0,
        )
    )


def rotation(angle: float) -> Array:
    """Matrix that turns columns by an angle [rad]."""
    return np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
