"""Three instants of the motion as a still picture."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, PathPatch
from matplotlib.path import Path

from varistiff.report.mechanism.sheet import legend, panels
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.scene import Part, Scene
from varistiff.report.simulation.run import Run
from varistiff.report.simulation.timeline import stamp
from varistiff.report.style import WIDTH, Drawing, styled
from varistiff.report.view import Array

PIXELS = 96.0  # of a page to the inch
TITLE = "The mechanism in motion"


def draw_strip(run: Run, scene: Scene, frames: Frames) -> Drawing:
    """Draw the mechanism at the start, at its largest deflection and at the end."""
    chosen = sorted({0, int(np.argmax(np.abs(frames.deflection))), frames.count - 1})
    titles = [run.time_text(float(frames.time[frame])) for frame in chosen]
    bounds = scene.bounds_at(chosen)
    with styled():
        figure, axes = panels(bounds, len(chosen), titles=titles, scaled=scene.scaled)
        for part, frame in zip(axes, chosen, strict=True):
            paint(part, scene, frame)
        legend(figure, scene.key)
        stamp(figure, run)
    caption = f"{scene.caption} Shown: the start, the largest deflection and the end of the run."
    return Drawing("mechanism", TITLE, figure, caption)


def paint(axes: Axes, scene: Scene, frame: int) -> None:
    """Paint one frame on axes with equal scales in millimetres."""
    left, right = axes.get_xlim()
    unit = 72.0 * WIDTH * float(axes.get_position().width) / (right - left)  # points of a picture to the millimetre
    for order, part in enumerate(scene.parts):
        points = part.at(frame)
        look: dict[str, Any] = {
            "facecolor": part.fill or "none",
            "edgecolor": part.edge or "none",
            "linewidth": max(part.pixels * 72.0 / PIXELS, part.width * unit),
            "linestyle": (0, (4.0, 2.5)) if part.dashed else "solid",
            "zorder": 2.0 + 0.01 * order,
        }
        if part.radius:
            axes.add_artist(Circle((float(points[0, 0]), float(points[0, 1])), part.radius, **look))
        else:
            axes.add_artist(PathPatch(_path(points, part), capstyle="round", joinstyle="round", **look))


def _path(points: Array, part: Part) -> Path:
    """Pen up at NaN."""
    known = np.asarray(np.isfinite(points).all(axis=1))
    lifted = known & ~np.insert(known[:-1], 0, False)
    codes = np.where(lifted, Path.MOVETO, Path.LINETO)[known]
    vertices = points[known]
    if part.closed:
        vertices, codes = np.append(vertices, vertices[:1], axis=0), np.append(codes, Path.CLOSEPOLY)
    return Path(vertices, codes)
