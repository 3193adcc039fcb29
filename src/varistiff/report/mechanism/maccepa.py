"""MACCEPA: a lever on the drive, a cable over an anchor on the link, a preloaded spring."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from varistiff.actuators.maccepa import Maccepa
from varistiff.report.mechanism.sheet import (
    MM,
    Bounds,
    Pose,
    bar,
    block,
    disc,
    end_rows,
    joint,
    legend,
    panels,
    poses_at,
)
from varistiff.report.style import FAINT, METAL, METAL_LIGHT, VERMILION, Drawing, styled
from varistiff.report.view import View

COILS = 7


def draw(actuator: Maccepa, dataset: xr.Dataset) -> Drawing:
    """Draw lever, cable and spring in the frame of the link, at rest, half and whole usable deflection."""
    view = View.of(dataset)
    rows = end_rows(view)
    states = [poses_at(view, row) for row in rows]
    lever, anchor = actuator.lever_length * MM, actuator.anchor_distance * MM
    pull = max(_elongation(actuator, pose) for poses in states for pose in poses)
    size = max(lever, anchor)
    tail = anchor + 0.45 * size + pull
    swing = max(abs(pose.deflection) for poses in states for pose in poses)
    high = max(lever * math.sin(min(swing, math.pi / 2)), 0.16 * size)
    low = min(-0.16 * size, 0.0)
    bounds = Bounds(min(-0.12 * size, lever * math.cos(swing) - 0.1 * size), tail + 0.1 * size, low, high + 0.08 * size)
    if any(pose.deflection < 0.0 for poses in states for pose in poses):
        bounds = Bounds(bounds.left, bounds.right, -bounds.top, bounds.top)
    with styled():
        titles = [f"Pretension {view.setting_text(row)}" for row in rows]
        figure, axes = panels(bounds, len(rows), titles=titles, poses=states)
        for part, poses in zip(axes, states, strict=True):
            bar(part, np.array([[0.0, 0.0], [tail, 0.0]]), 0.1 * size, colour=FAINT)
            for order, pose in enumerate(poses):
                _lever(part, actuator, pose, size, zorder=3.0 + order)
            _spring(part, actuator, poses, 0.45 * size + pull, size)
            block(part, np.array([anchor, 0.0]), 0.035 * size, 0.16 * size, colour=METAL, zorder=8.0)
            joint(part, np.zeros(2), 0.035 * size)
        legend(
            figure,
            [
                ("link", FAINT, "patch"),
                ("anchor that guides the cable", METAL, "patch"),
                ("spring, at the whole deflection", VERMILION, "line"),
            ],
        )
    caption = (
        "Lever, anchor and cable to scale, in the frame of the link. The lever turns with the drive;"
        " the cable runs from its"
        " tip through the anchor to the spring. Grey: the deflection nearest to zero; colours: half and whole"
        " usable deflection. Of the spring only"
        " its elongation is to scale: the plates stand where the cable pulls them."
    )
    return Drawing("mechanism", "The mechanism to scale", figure, caption)


def _elongation(actuator: Maccepa, pose: Pose) -> float:
    """Elongation of the spring [mm], at least zero."""
    lever, anchor = actuator.lever_length, actuator.anchor_distance
    gap = math.sqrt((anchor - lever) ** 2 + 4.0 * lever * anchor * math.sin(0.5 * pose.deflection) ** 2)
    return max(gap - abs(anchor - lever) + pose.setting, 0.0) * MM


def _lever(axes: Axes, actuator: Maccepa, pose: Pose, size: float, *, zorder: float) -> None:
    lever, anchor = actuator.lever_length * MM, actuator.anchor_distance * MM
    tip = lever * np.array([math.cos(pose.deflection), math.sin(pose.deflection)])
    axes.plot([0.0, tip[0]], [0.0, tip[1]], color=pose.colour, linewidth=5.0, solid_capstyle="round", zorder=zorder)
    axes.plot([tip[0], anchor], [tip[1], 0.0], color=pose.colour, linewidth=1.5, zorder=zorder)
    disc(axes, tip, 0.018 * size, colour=METAL_LIGHT, edge=pose.colour, width=1.5, zorder=zorder + 0.3)


def _spring(axes: Axes, actuator: Maccepa, poses: list[Pose], free: float, size: float) -> None:
    """Compression spring behind the anchor: the cable pulls its plate towards the anchor."""
    anchor = actuator.anchor_distance * MM
    ends = [anchor + free - _elongation(actuator, pose) for pose in poses]
    steps = np.linspace(0.0, 1.0, 40 * COILS)
    axes.plot(
        anchor + (ends[-1] - anchor) * steps,
        0.055 * size * np.sin(2.0 * math.pi * COILS * steps),
        color=VERMILION,
        linewidth=1.8,
        zorder=7.0,
    )
    for pose, end in zip(poses, ends, strict=True):
        block(axes, np.array([end, 0.0]), 0.016 * size, 0.15 * size, colour=pose.colour, zorder=8.0)
