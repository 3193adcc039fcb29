"""Stress on surfaces of a three-dimensional result, like Figs. 10 and 11 of Schuy et al. (2013)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection, TriMesh
from matplotlib.figure import Figure
from matplotlib.tri import Triangulation
from numpy.typing import NDArray

from varistiff.fe.torsion_problem import StressField
from varistiff.report.style import Drawing, styled

TITLES = {
    "torsion_section": ("Torsion alone, cross-section", "at half the active length"),
    "bearing_section": ("Torsion and bearing, cross-section", "at the middle of the bearing"),
    "bearing_surface": ("Torsion and bearing, surface", "of the whole element"),
}
TURN, TILT = 0.55, 0.45  # of the element to the viewer [rad]

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


def draw_all(fields: Iterable[StressField]) -> Iterator[Drawing]:
    """Draw each field, per newton metre of torque."""
    for field in fields:
        yield draw(field)


def draw(field: StressField) -> Drawing:
    """Draw von Mises stress per torque; a plane field as seen along the axis, others from the side."""
    title, where = TITLES.get(field.name, (field.name.replace("_", " ").capitalize(), ""))
    points = field.points * 1e3
    flat = float(np.ptp(points[:, 2])) < 1e-3 * float(np.ptp(points[:, 0]))
    values = field.equivalent * 1e-6
    # single cells at a sharp edge would take the whole colour scale
    top = float(np.quantile(values[np.isfinite(values)], 0.99))
    corners = field.triangles
    caption = f"Von Mises stress {where}, for a torque of 1 N\N{MIDDLE DOT}m."
    with styled():
        shown: TriMesh | PolyCollection
        if flat:
            figure, axes = _frame(points[:, 0], points[:, 1])
            plane = Triangulation(points[:, 0], points[:, 1], corners)
            shown = axes.tripcolor(plane, values, shading="gouraud", cmap="cividis", rasterized=True)
        else:
            kept = _loaded(points, corners, values > 0.03 * top)
            if kept.sum() < len(corners):
                caption += " The rest of the element carries almost nothing and is cut off."
            corners = corners[kept]
            across, up, depth = _seen(points)
            figure, axes = _frame(across[corners], up[corners])
            corners = corners[np.argsort(depth[corners].mean(axis=1))]  # the nearest last
            shown = PolyCollection(
                list(np.stack([across[corners], up[corners]], axis=2)),
                cmap="cividis",
                edgecolors="face",
                linewidths=0.2,
                rasterized=True,
            )
            shown.set_array(values[corners].mean(axis=1))
            axes.add_collection(shown)
            axes.autoscale_view()
        shown.set_clim(0.0, top)
        axes.set_title(title)
        bar = figure.colorbar(shown, cax=figure.add_axes((0.86, 0.14, 0.022, 0.68)), extend="max")
        bar.set_label("MPa per N\N{MIDDLE DOT}m")
    caption += (
        " The colours end at the 99 % quantile, so that an edge with an unbounded ideal stress does not take the scale."
    )
    return Drawing(field.name, title, figure, caption)


def _loaded(points: Floats, corners: Integers, loaded: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which triangles lie before the last loaded point along the element, or less than a radius beyond it."""
    end = points[loaded, 2].max() + np.abs(points[:, 0]).max()
    kept: NDArray[np.bool_] = points[corners, 2].max(axis=1) <= end
    return kept


def _frame(across: Floats, up: Floats) -> tuple[Figure, Axes]:
    share = float(np.ptp(up)) / float(np.ptp(across))
    figure = Figure(figsize=(7.4, float(np.clip(6.0 * share + 0.8, 3.0, 5.6))))
    axes = figure.add_axes((0.02, 0.04, 0.82, 0.84))
    axes.set_aspect("equal")
    axes.set_axis_off()
    return figure, axes


def _seen(points: Floats) -> tuple[Floats, Floats, Floats]:
    """Parallel projection with the element's axis to the right, its free end turned a little to the viewer."""
    x, y, z = points.T
    near, right = math.cos(TURN) * x + math.sin(TURN) * z, math.cos(TURN) * z - math.sin(TURN) * x
    return right, math.cos(TILT) * y - math.sin(TILT) * near, math.cos(TILT) * near + math.sin(TILT) * y
