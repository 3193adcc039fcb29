"""Series elastic joint: a torsion spring between the drive and the link."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from varistiff.actuators.series_elastic import SeriesElastic
from varistiff.report.mechanism.sheet import (
    Bounds,
    Pose,
    bar,
    disc,
    joint,
    legend,
    panels,
    poses_at,
    rotation,
)
from varistiff.report.style import FAINT, METAL, METAL_LIGHT, Drawing, styled
from varistiff.report.view import View

TURNS = 2.75
INNER, OUTER = 0.28, 1.0  # radii of the spring's ends, in units of the sketch


def draw(actuator: SeriesElastic, dataset: xr.Dataset) -> Drawing:
    """Sketch the spring at rest, half and whole range; it has no dimensions, so only the angles are true."""
    poses = poses_at(View.of(dataset), 0)
    with styled():
        bounds = Bounds(-1.25, 2.75, -1.22, 1.22)
        figure, axes = panels(bounds, 1, titles=["Torsion spring between drive and link"], poses=[poses], scaled=False)
        disc(axes[0], np.zeros(2), 1.12, colour="#f4f6f7", edge=METAL, zorder=0.5)
        bar(axes[0], np.array([[OUTER, 0.0], [2.5, 0.0]]), 0.16, colour=FAINT, zorder=0.8)
        for order, pose in enumerate(poses):
            _spring(axes[0], pose, zorder=3.0 + order)
        joint(axes[0], np.zeros(2), 0.09)
        legend(figure, [("drive shaft", METAL_LIGHT, "round"), ("housing with the link", FAINT, "patch")])
    caption = (
        f"Sketch of the joint, spring stiffness {actuator.stiffness:.4g} N m/rad: no dimensions are"
        " given, but the angles are"
        " true. The link is held; the drive shaft turns by the deflection, as the dashed pointers show."
    )
    return Drawing("mechanism", "The mechanism (a sketch)", figure, caption)


def _spring(axes: Axes, pose: Pose, *, zorder: float) -> None:
    part = np.linspace(0.0, 1.0, 200)
    # the inner end turns with the drive, the outer one stays with the link
    angle = 2.0 * math.pi * TURNS * (part - 1.0) + pose.deflection * (1.0 - part)
    radius = INNER + (OUTER - INNER) * part
    axes.plot(radius * np.cos(angle), radius * np.sin(angle), color=pose.colour, linewidth=2.6, zorder=zorder)
    hub = 2.0 * math.pi * TURNS * -1.0 + pose.deflection
    tip = rotation(hub) @ np.array([INNER, 0.0])
    axes.plot([0.0, tip[0]], [0.0, tip[1]], color=pose.colour, linewidth=3.4, zorder=zorder)
    pointer = np.stack([0.55 * tip / INNER, 1.06 * tip / INNER])
    axes.plot(pointer[:, 0], pointer[:, 1], color=pose.colour, linewidth=2.0, linestyle=(0, (3, 1.5)), zorder=zorder)
    disc(axes, np.zeros(2), 0.14, colour=METAL_LIGHT, zorder=zorder + 0.5)
