"""Torsion tube: an element between its flange and a counter bearing that slides along it."""

from __future__ import annotations

import math

import jax.numpy as jnp
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.report.mechanism.element_view import Edges, edges_of, evenly_spread, seen_from_the_side, silhouette
from varistiff.report.mechanism.sheet import (
    MM,
    REST,
    Bounds,
    Pose,
    axis_line,
    block,
    disc,
    legend,
    panels,
    poses_at,
    rotation,
    wall,
)
from varistiff.report.section_path import section_loops, section_path
from varistiff.report.style import BLUE, INK, METAL_LIGHT, SOFT, Drawing, styled
from varistiff.report.view import Array, View

STATIONS = 161  # along the element
BEARING = 1.51  # its outer radius over the largest of the element
ROUND = ("circle", "hollow_circle")


def draw(actuator: TorsionTube, dataset: xr.Dataset) -> Drawing:
    """Draw side view and section at three settings, each twisted to the end of its ok range."""
    view = View.of(dataset)
    rows = view.some_settings(3)
    states = [poses_at(view, row) for row in rows]
    loops = section_loops(actuator.section)
    outer = float(np.hypot(*loops[0].T).max())
    length = (
        actuator.length
        if math.isfinite(actuator.length)
        else float(view.setting.max() if view.setting is not None else 0)
    )
    length *= MM
    section = length + 3.6 * outer
    bounds = Bounds(-1.3 * outer, section + 1.7 * outer, -1.75 * outer, 1.75 * outer)
    with styled():
        titles = [f"Active length {view.setting_text(row)}" for row in rows]
        figure, axes = panels(bounds, len(rows), titles=titles, poses=states)
        for part, poses in zip(axes, states, strict=True):
            _side_view(part, actuator, poses[-1], loops[0], length)
            _section(part, actuator, poses, (section, 0.0), loops)
        parts = [
            ("flange, drive side", METAL_LIGHT, "wall"),
            ("elastic element", METAL_LIGHT, "patch"),
            ("counter bearing, link side", BLUE, "patch"),
        ]
        legend(figure, parts)
    return Drawing("mechanism", "The mechanism to scale", figure, _caption(actuator))


def _caption(actuator: TorsionTube) -> str:
    lines = "lines that are straight at rest show" if actuator.section.shape in ROUND else "its edges show"
    words = (
        "The mechanism to scale. Left: the element between its flange and the counter bearing, whose place is the"
        f" active length; {lines} the twist at the end of the usable range. Right: the section at the bearing, with"
        " the twist of the element at rest, half and whole usable deflection."
    )
    if actuator.section.shape not in ROUND:
        words += " Element and bearing are drawn at the whole one; the thin grey outline is the section at rest."
    if math.isfinite(actuator.series_stiffness):
        words += " The rest of the deflection is in the drive train in series."
    return words


def _twist(actuator: TorsionTube, pose: Pose) -> float:
    """Part of the deflection that twists the element itself [rad]."""
    length = float(actuator.effective_length(jnp.asarray(pose.setting)))
    own = max(length, 0.0) / (actuator.shear_modulus * actuator.torsion_constant)
    return pose.deflection * own / (own + 1.0 / actuator.series_stiffness) if own else 0.0


def _side_view(axes: Axes, actuator: TorsionTube, pose: Pose, outline: Array, length: float) -> None:
    """The element seen along its section's x axis, from outside; y is up."""
    outer = float(np.hypot(*outline.T).max())
    active = pose.setting * MM
    along = np.unique(np.append(np.linspace(0.0, length, STATIONS), min(active, length)))
    turned = _twist(actuator, pose) * np.clip(along / active, 0.0, 1.0)
    low, high = silhouette(outline, turned)
    axes.fill_between(along, low, high, facecolor=METAL_LIGHT, edgecolor=INK, linewidth=0.8, zorder=2.0)
    wall(axes, -0.9 * outer, -1.55 * outer, 0.9 * outer, 3.1 * outer)
    for side, end in ((-1.0, np.interp(active, along, -low)), (1.0, np.interp(active, along, high))):
        inside = float(end) + 0.01 * outer
        centre = np.array([active, side * 0.5 * (BEARING * outer + inside)])
        block(axes, centre, 0.5 * outer, BEARING * outer - inside, colour=BLUE, zorder=5.0)
    axis_line(axes, np.array([[-1.2 * outer, 0.0], [length + 0.6 * outer, 0.0]]))
    edges = edges_of(outline)
    smooth = edges.points.shape[0] < 3
    _lines(axes, along, seen_from_the_side(outline, evenly_spread(outline) if smooth else edges, turned), smooth)
    marked = seen_from_the_side(outline, Edges.facing(outline), turned)
    axes.plot(along, marked[0], color=pose.colour, linewidth=2.6, zorder=4.0)


def _lines(axes: Axes, along: Array, heights: Array, smooth: bool) -> None:
    for height in heights:
        axes.plot(along, height, color=SOFT if smooth else INK, linewidth=0.7 if smooth else 0.8, zorder=3.0)


def _section(
    axes: Axes, actuator: TorsionTube, poses: list[Pose], centre: tuple[float, float], loops: list[Array]
) -> None:
    middle = np.array(centre)
    outer = float(np.hypot(*loops[0].T).max())
    angles = [_twist(actuator, pose) for pose in poses]
    turned = angles[-1]
    reach = 1.32
    if actuator.section.shape not in ROUND:
        reach = 1.66  # past the bearing
        _bearing(axes, loops[0], middle, outer, turned)
        rest = PathPatch(
            section_path(loops, centre=centre), facecolor="none", edgecolor=REST, linewidth=0.9, zorder=3.5
        )
        axes.add_artist(rest)  # the axes have their limits: add_patch would look for the path's, slowly
    path = section_path(loops, angle=turned, centre=centre)
    axes.add_artist(PathPatch(path, facecolor=METAL_LIGHT, edgecolor=INK, linewidth=1.2, zorder=3.0))
    for pose, angle in zip(poses, angles, strict=True):
        direction = np.array([math.cos(angle), math.sin(angle)])
        line = np.stack([middle, middle + reach * outer * direction])
        axes.plot(line[:, 0], line[:, 1], color=pose.colour, linewidth=2.4, zorder=4.0)
    disc(axes, middle, 0.05 * outer, colour=INK, zorder=5.0)


def _bearing(axes: Axes, outline: Array, middle: Array, outer: float, angle: float) -> None:
    """A ring around the element that fits it."""
    around = np.linspace(0.0, 2.0 * math.pi, 181)
    ring = middle + BEARING * outer * np.stack([np.cos(around), np.sin(around)], axis=1)
    bore = (outline @ rotation(angle).T + middle)[::-1]
    codes = [[Path.MOVETO] + [Path.LINETO] * (len(part) - 2) + [Path.CLOSEPOLY] for part in (ring, bore)]
    path = Path(np.concatenate([ring, bore]), np.concatenate(codes))
    axes.add_artist(PathPatch(path, facecolor=BLUE, edgecolor=INK, linewidth=0.8, zorder=2.5))
