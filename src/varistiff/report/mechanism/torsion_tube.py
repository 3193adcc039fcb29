"""Torsion tube: an element between its flange and a counter bearing that slides along it."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.report.mechanism.sheet import (
    MM,
    Bounds,
    Pose,
    axis_line,
    block,
    disc,
    legend,
    panels,
    poses_at,
    wall,
)
from varistiff.report.style import BLUE, INK, METAL_LIGHT, SOFT, Drawing, styled
from varistiff.report.view import View

GENERATORS = 24  # lines along the element that show its twist


def draw(actuator: TorsionTube, dataset: xr.Dataset) -> Drawing:
    """Draw side view and section at three settings, each twisted to the end of its ok range."""
    view = View.of(dataset)
    rows = view.some_settings(3)
    states = [poses_at(view, row) for row in rows]
    outer, inner = _radii(actuator)
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
            _side_view(part, actuator, poses[-1], outer, length)
            _section(part, actuator, poses, (section, 0.0), outer, inner)
        parts = [
            ("flange, drive side", METAL_LIGHT, "wall"),
            ("elastic element", METAL_LIGHT, "patch"),
            ("counter bearing, link side", BLUE, "patch"),
        ]
        legend(figure, parts)
    caption = (
        "The mechanism to scale. Left: the element between its flange and the counter bearing, whose"
        " place is the active"
        " length; lines that are straight at rest show the twist at the end of the usable range."
        " Right: the section at the"
        " bearing, with the twist of the element at rest, half and whole usable deflection."
    )
    if math.isfinite(actuator.series_stiffness):
        caption += " The rest of the deflection is in the drive train in series."
    return Drawing("mechanism", "The mechanism to scale", figure, caption)


def _radii(actuator: TorsionTube) -> tuple[float, float]:
    """Outer and inner radius [mm]; a section without radii is drawn as the circle of its area."""
    section = actuator.section
    outer = getattr(section, "outer_radius", getattr(section, "radius", math.sqrt(float(section.area) / math.pi)))
    return float(outer) * MM, float(getattr(section, "inner_radius", 0.0)) * MM


def _twist(actuator: TorsionTube, pose: Pose) -> float:
    """Part of the deflection that twists the element itself [rad]."""
    own = pose.setting / (actuator.shear_modulus * float(actuator.section.torsion_constant))
    return pose.deflection * own / (own + 1.0 / actuator.series_stiffness)


def _side_view(axes: Axes, actuator: TorsionTube, pose: Pose, outer: float, length: float) -> None:
    active, twist = pose.setting * MM, _twist(actuator, pose)
    middle = np.array([length / 2.0, 0.0])
    block(axes, middle, length, 2.0 * outer, colour=METAL_LIGHT, zorder=2.0)
    wall(axes, -0.9 * outer, -1.55 * outer, 0.9 * outer, 3.1 * outer)
    for side in (-1.0, 1.0):
        block(axes, np.array([active, side * 1.26 * outer]), 0.5 * outer, 0.5 * outer, colour=BLUE, zorder=5.0)
    axis_line(axes, np.array([[-1.2 * outer, 0.0], [length + 0.6 * outer, 0.0]]))
    along = np.linspace(0.0, length, 61)
    turned = twist * np.clip(along / active, 0.0, 1.0)
    for start in np.linspace(-math.pi, math.pi, GENERATORS, endpoint=False):
        place = start + turned
        seen = np.cos(place) > 0.0
        marked = abs(start) < 1e-9
        axes.plot(
            along,
            np.where(seen, outer * np.sin(place), np.nan),
            color=pose.colour if marked else SOFT,
            linewidth=2.6 if marked else 0.7,
            zorder=4.0 if marked else 3.0,
        )


def _section(
    axes: Axes,
    actuator: TorsionTube,
    poses: list[Pose],
    centre: tuple[float, float],
    outer: float,
    inner: float,
) -> None:
    middle = np.array(centre)
    disc(axes, middle, outer, colour=METAL_LIGHT, width=1.2, zorder=3.0)
    if inner > 0.0:
        disc(axes, middle, inner, colour="white", width=1.2, zorder=3.1)
    for pose in poses:
        angle = _twist(actuator, pose)
        direction = np.array([math.cos(angle), math.sin(angle)])
        line = np.stack([middle, middle + 1.32 * outer * direction])
        axes.plot(line[:, 0], line[:, 1], color=pose.colour, linewidth=2.4, zorder=4.0)
    disc(axes, middle, 0.05 * outer, colour=INK, zorder=5.0)
