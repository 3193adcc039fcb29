"""Roller beam: two links, a cantilever on one, rollers on a shuttle along the other."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from varistiff.actuators.roller_beam import RollerBeam
from varistiff.actuators.rollers import FixedPair, SingleLower, SingleUpper
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
from varistiff.report.style import FAINT, METAL, METAL_LIGHT, Drawing, styled
from varistiff.report.view import Array, View

TITLE = "The mechanism to scale"


def draw(actuator: RollerBeam, dataset: xr.Dataset) -> Drawing:
    """Draw the clamp's frame: beam, rollers and the axis of link 2 at rest, at half and at the whole ok range."""
    view = View.of(dataset)
    rows = end_rows(view)
    states = [poses_at(view, row) for row in rows]
    shapes = [[_beam(actuator, pose) for pose in poses] for poses in states]
    tips = [_along_shank(actuator, pose, 1.1 * pose.setting) for poses in states for pose in poses]
    origin = _joint(actuator)
    reach = max(float(np.abs(shape).max()) for group in shapes for shape in group)
    behind = origin - rotation(actuator.mounting_angle) @ np.array([0.13 * reach, 0.0])
    bounds = Bounds.around(*[shape for group in shapes for shape in group], np.array([*tips, origin, behind]))
    with styled():
        titles = [f"Roller position {view.setting_text(row)}" for row in rows]
        figure, axes = panels(bounds, len(rows), titles=titles)
        for part, poses, group in zip(axes, states, shapes, strict=True):
            _frame(part, actuator, reach)
            for order, (pose, shape) in enumerate(zip(poses, group, strict=True)):
                _state(part, actuator, pose, shape, reach, zorder=4.0 + order)
        parts = [("beam clamped to link 1", METAL, "patch"), ("link 2 with its axis", FAINT, "patch"),
                 ("roller", METAL_LIGHT, "patch")]
        legend(figure, states[0] if len(rows) == 1 else _shared(states), parts)
    caption = (
        "Mechanism to scale in the frame of link 1, which carries the clamp (dark block) and ends in the joint. Link 2 turns"
        " about the joint and carries the rollers that bend the beam. Grey: at rest; colours: half and whole usable"
        " deflection at the shortest and the longest usable setting."
    )
    if actuator_pair_radius_is_nominal(actuator):
        caption += " The design does not need the radius of the swivelling rollers: they are drawn at a nominal size."
    return Drawing("mechanism", TITLE, figure, caption)


def actuator_pair_radius_is_nominal(actuator: RollerBeam) -> bool:
    """Whether the rollers' size has no effect, and so none to draw from."""
    return not isinstance(actuator.rollers, SingleLower | SingleUpper | FixedPair)
