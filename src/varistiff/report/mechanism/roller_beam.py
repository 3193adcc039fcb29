"""Roller beam: two links, a cantilever on one, rollers on a shuttle along the other."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from varistiff.actuators.roller_beam import RollerBeam
from varistiff.actuators.rollers import FixedPair, SwivellingPair
from varistiff.report.mechanism.leaf_shape import bent, detail
from varistiff.report.mechanism.sheet import (
    MM,
    Bounds,
    Pose,
    axis_line,
    bar,
    block,
    disc,
    end_rows,
    joint,
    legend,
    panels,
    poses_at,
    rotation,
    strip,
)
from varistiff.report.style import FAINT, METAL, METAL_LIGHT, SOFT, Drawing, styled
from varistiff.report.view import Array, View

NOMINAL_ROLLER = 0.012  # of the drawing's size, where the design's numbers do not fix the rollers' size


def draw(actuator: RollerBeam, dataset: xr.Dataset) -> Drawing:
    """Draw beam, rollers and the axis of link 2 in the clamp's frame, unloaded to the end of the ok range."""
    view = View.of(dataset)
    rows = end_rows(view)
    states = [poses_at(view, row) for row in rows]
    shapes = [[_beam(view, actuator, pose) for pose in poses] for poses in states]
    origin = _joint(actuator)
    size = max(float(np.abs(shape).max()) for group in shapes for shape in group)
    behind = origin - rotation(actuator.mounting_angle) @ np.array([0.1 * size, 0.0])
    tips = [_on_shank(actuator, pose, 1.08 * pose.setting * MM, 0.0) for poses in states for pose in poses]
    around = [shape for group in shapes for shape in group]
    bounds = Bounds.around(
        *around, np.array([*tips, origin, behind, [0.0, 0.05 * size], [0.0, -0.05 * size]]), margin=0.025
    )
    with styled():
        titles = [f"Roller position {view.setting_text(row)}" for row in rows]
        figure, axes = panels(bounds, len(rows), titles=titles, poses=states)
        for part, poses, group in zip(axes, states, shapes, strict=True):
            _link_one(part, actuator, size)
            for order, (pose, shape) in enumerate(zip(poses, group, strict=True)):
                _state(part, actuator, pose, shape, size, zorder=4.0 + 0.1 * order)
        parts = [
            ("clamp on link 1", METAL, "patch"),
            ("joint", "white", "round"),
            ("roller", METAL_LIGHT, "round"),
            ("axis of link 2", SOFT, "dash"),
        ]
        legend(figure, parts)
    caption = (
        "The mechanism to scale, in the frame of link 1, which carries the clamped beam and ends in"
        " the joint. Link 2 turns"
        " about the joint; the rollers on its shuttle bend the beam. Grey: the deflection nearest to zero; colours:"
        " half and whole usable"
        " deflection, at the stiffest and the softest usable setting."
    )
    if isinstance(actuator.rollers, SwivellingPair):
        caption += " The size of swivelling rollers has no effect, so they are drawn at a nominal one."
    return Drawing("mechanism", "The mechanism to scale", figure, caption)


def _beam(view: View, actuator: RollerBeam, pose: Pose) -> Array:
    """Centreline of the whole beam in the clamp's frame [mm]."""
    beam = actuator.beam
    drawn = beam.length if math.isfinite(beam.length) else 1.2 * pose.setting
    slope, length = detail(view, pose, "contact_slope"), detail(view, pose, "active_length")
    return bent(slope=slope, length=length, drawn=drawn)


def _joint(actuator: RollerBeam) -> Array:
    offset = np.array([actuator.clamp_offset_along, actuator.clamp_offset_across])
    return np.asarray(rotation(actuator.mounting_angle) @ -offset * MM)


def _on_shank(actuator: RollerBeam, pose: Pose, along: float, across: float) -> Array:
    turned = rotation(actuator.mounting_angle + pose.deflection)
    return np.asarray(_joint(actuator) + turned @ np.array([along, across]))


def _link_one(axes: Axes, actuator: RollerBeam, size: float) -> None:
    origin = _joint(actuator)
    behind = origin - rotation(actuator.mounting_angle) @ np.array([0.1 * size, 0.0])
    bar(axes, np.array([behind, origin]), 0.028 * size)
    bar(axes, np.array([origin, [0.0, 0.0]]), 0.016 * size)
    block(axes, np.array([-0.016 * size, 0.0]), 0.032 * size, 0.05 * size, colour=METAL, zorder=6.0)
    joint(axes, origin, 0.012 * size)


def _state(axes: Axes, actuator: RollerBeam, pose: Pose, shape: Array, size: float, *, zorder: float) -> None:
    along = pose.setting * MM
    ends = np.array([_on_shank(actuator, pose, 0.0, 0.0), _on_shank(actuator, pose, 1.08 * along, 0.0)])
    bar(axes, ends, 0.014 * size, colour=FAINT, zorder=1.0)
    axis_line(axes, ends, colour=pose.colour)
    strip(axes, shape, actuator.beam.thickness * MM, colour=pose.colour, zorder=zorder)
    for centre, radius in _rollers(actuator, pose, shape, size):
        disc(axes, centre, radius, edge=pose.colour, width=1.8, zorder=zorder - 0.05)


def _rollers(actuator: RollerBeam, pose: Pose, shape: Array, size: float) -> list[tuple[Array, float]]:
    """Centres and radii of the rollers, in millimetres."""
    rollers, along = actuator.rollers, pose.setting * MM
    offset = float(rollers.offset) * MM  # type: ignore[attr-defined]  # every arrangement has one; the base has no fields
    half = 0.5 * actuator.beam.thickness * MM
    if isinstance(rollers, SwivellingPair):
        pivot = _on_shank(actuator, pose, along, offset)
        # straight beyond the contact: the last piece has the slope that the pair aligns with
        slope = math.atan2(*(shape[-1] - shape[-2])[::-1])
        radius = NOMINAL_ROLLER * size
        spread = rotation(slope) @ np.array([0.0, rollers.clearance * MM + half + radius])
        return [(pivot - spread, radius), (pivot + spread, radius)]
    radius = float(rollers.radius) * MM  # type: ignore[attr-defined]  # as above
    if isinstance(rollers, FixedPair):
        spread = radius + half + rollers.clearance * MM
        return [(_on_shank(actuator, pose, along, offset + side * spread), radius) for side in (-1.0, 1.0)]
    return [(_on_shank(actuator, pose, along, offset), radius)]
