"""Slider leaf joint: leaves clamped on the output disc, sliders on the input disc, a groove that moves them."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from varistiff.actuators.groove import Groove
from varistiff.actuators.leaf_joint_theory import SmallDeflection
from varistiff.actuators.slider_leaf_joint import SliderLeafJoint
from varistiff.report.mechanism.leaf_shape import bent, cubic, detail
from varistiff.report.mechanism.sheet import (
    MM,
    Bounds,
    Pose,
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
from varistiff.report.style import METAL, METAL_LIGHT, PURPLE, SOFT, Drawing, styled
from varistiff.report.view import Array, View


def draw(actuator: SliderLeafJoint, dataset: xr.Dataset) -> Drawing:
    """Draw the joint along its axis, in the frame of the output disc, unloaded to the end of the ok range."""
    view = View.of(dataset)
    rows = end_rows(view)
    states = [poses_at(view, row) for row in rows]
    radius = actuator.clamp_radius * MM
    longest = max(_active(view, actuator, poses[0]) for poses in states)
    rim = radius + 1.3 * longest
    with styled():
        titles = [f"{_setting_name(actuator)} {view.setting_text(row)}" for row in rows]
        bounds = Bounds(-1.04 * rim, 1.04 * rim, -1.04 * rim, 1.04 * rim)
        if actuator.count == 1:  # nothing to see but around the leaf
            bounds = Bounds(-0.15 * rim, 1.04 * rim, -0.48 * rim, 0.48 * rim)
        figure, axes = panels(bounds, len(rows), titles=titles, poses=states)
        for part, poses in zip(axes, states, strict=True):
            _discs(part, radius, rim)
            _groove(part, view, actuator, poses[0])
            for order, pose in enumerate(poses):
                _state(part, view, actuator, pose, rim, zorder=4.0 + 0.1 * order)
        parts = [("output disc with clamps", METAL, "patch"), ("slider on the input disc", "white", "round")]
        if actuator.groove is not None:
            parts.append(("groove of the stiffness disc", PURPLE, "line"))
        legend(figure, parts)
    leaves = "One leaf" if actuator.count == 1 else f"{actuator.count} leaves"
    caption = (
        f"The joint to scale along its axis. {leaves}, seen on edge, clamped on the output disc; the"
        " sliders turn with the"
        " input disc. Grey: the deflection nearest to zero; colours: half and whole usable deflection, at the"
        " stiffest and the softest usable"
        " setting."
    )
    return Drawing("mechanism", "The mechanism to scale", figure, caption)


def _setting_name(actuator: SliderLeafJoint) -> str:
    return "Disc angle" if actuator.setting_unit == "rad" else "Active length"


def _active(view: View, actuator: SliderLeafJoint, pose: Pose) -> float:
    """Active length [mm]."""
    return (detail(view, pose, "active_length") if actuator.setting_unit == "rad" else pose.setting) * MM


def _discs(axes: Axes, radius: float, rim: float) -> None:
    disc(axes, np.zeros(2), rim, colour="#f4f6f7", edge=SOFT, width=1.0, zorder=0.5)
    disc(axes, np.zeros(2), radius, colour=METAL_LIGHT, zorder=2.0)
    joint(axes, np.zeros(2), 0.05 * rim)


def _state(axes: Axes, view: View, actuator: SliderLeafJoint, pose: Pose, rim: float, *, zorder: float) -> None:
    radius = actuator.clamp_radius * MM
    turn = 2.0 * math.pi / actuator.count
    place = radius + _active(view, actuator, pose)
    leaf = _leaf(view, actuator, pose)
    # beyond the rim a long leaf only hides the discs
    leaf = leaf[np.hypot(leaf[:, 0] + radius, leaf[:, 1]) <= rim]
    for index in range(actuator.count):
        angle = index * turn
        line = (leaf + np.array([radius, 0.0])) @ rotation(angle).T
        strip(axes, line, actuator.leaf.thickness * MM, colour=pose.colour, zorder=zorder)
        seat = rotation(angle) @ np.array([radius - 0.03 * rim, 0.0])
        block(axes, seat, 0.06 * rim, 0.1 * rim, angle, colour=METAL, zorder=6.0)
        pin = rotation(angle + pose.deflection) @ np.array([place, 0.0])
        _slider(axes, pin, angle + pose.deflection, actuator.leaf.thickness * MM, rim, pose.colour, zorder)


def _leaf(view: View, actuator: SliderLeafJoint, pose: Pose) -> Array:
    """Centreline of a leaf from its clamp along +x [mm], by the theory that the design asks for."""
    active = _active(view, actuator, pose) / MM
    drawn = actuator.leaf.length if math.isfinite(actuator.leaf.length) else 1.2 * active
    if isinstance(actuator.theory, SmallDeflection):
        offset = (actuator.clamp_radius + active) * math.tan(pose.deflection)
        return cubic(length=active, offset=offset, drawn=drawn)
    slope, length = (detail(view, pose, name) for name in ("leaf_rotation", "active_arc_length"))
    return bent(slope=slope, length=length, drawn=drawn)


def _slider(axes: Axes, pin: Array, angle: float, thickness: float, rim: float, colour: str, zorder: float) -> None:
    """Two pins of a fork, one on each side of the leaf."""
    size = 0.016 * rim
    for side in (-1.0, 1.0):
        centre = pin + rotation(angle) @ np.array([0.0, side * (size + 0.5 * thickness)])
        disc(axes, centre, size, colour="white", edge=colour, width=1.7, zorder=zorder + 0.05)


def _groove(axes: Axes, view: View, actuator: SliderLeafJoint, pose: Pose) -> None:
    """The groove that holds each slider at its radius, on the stiffness disc turned to this setting."""
    if actuator.groove is None:
        return
    arc = _arc(actuator.groove)
    here = pose.setting if actuator.setting_unit == "rad" else detail(view, pose, "disc_angle")
    for index in range(actuator.count):
        # the point of the groove at the disc angle `here` lies on this leaf
        around = 2.0 * math.pi * index / actuator.count + arc[:, 1] - here
        axes.plot(arc[:, 0] * np.cos(around), arc[:, 0] * np.sin(around), color=PURPLE, linewidth=1.8, zorder=3.0)


def _arc(groove: Groove) -> Array:
    """Radius [mm] and disc angle [rad] along the groove from A to C, shape (N, 2)."""
    start = np.array([0.0, groove.inner_radius])
    end = groove.outer_radius * np.array([math.sin(groove.outer_angle), math.cos(groove.outer_angle)])
    chord = end - start
    size = float(np.hypot(*chord))
    height = math.sqrt(max(groove.arc_radius**2 - 0.25 * size**2, 0.0))
    normal = np.array([-chord[1], chord[0]]) / size
    centres = sorted(
        (0.5 * (start + end) + side * height * normal for side in (1.0, -1.0)),
        key=lambda point: float(np.hypot(*point)),
    )
    centre = centres[0] if groove.centre == "near" else centres[1]
    first, last = (math.atan2(*(point - centre)[::-1]) for point in (start, end))
    turn = (last - first + math.pi) % (2.0 * math.pi) - math.pi
    angles = first + turn * np.linspace(0.0, 1.0, 41)
    points = centre + groove.arc_radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return np.stack([np.hypot(points[:, 0], points[:, 1]) * MM, np.arctan2(points[:, 0], points[:, 1])], axis=1)
