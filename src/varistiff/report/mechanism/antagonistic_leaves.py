"""Antagonistic leaves: four leaves between two nuts on a screw and four rollers on the other bar."""

from __future__ import annotations

import math

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patches import Wedge

from varistiff.actuators.antagonistic_leaves import AntagonisticLeaves
from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.report.mechanism.leaf_shape import between_horizontals
from varistiff.report.mechanism.sheet import (
    MM,
    Bounds,
    Pose,
    axis_line,
    bar,
    block,
    disc,
    end_rows,
    legend,
    panels,
    poses_at,
    strip,
)
from varistiff.report.style import FAINT, METAL, METAL_LIGHT, SOFT, Drawing, styled
from varistiff.report.view import Array, View

GAP = 0.09  # between a leaf at its roller and the axis, in clamp heights: not published, and without effect
NOMINAL = 0.25  # radius of rollers without protection, in clamp heights


def draw(actuator: AntagonisticLeaves, dataset: xr.Dataset) -> Drawing:
    """Draw the frame of bar 1 with its nuts; bar 2 with its rollers moves along the screw by the deflection."""
    view = View.of(dataset)
    rows = end_rows(view)
    states = [poses_at(view, row) for row in rows]
    radius = _protection(actuator)
    size = radius if radius is not None else NOMINAL * actuator.clamp_height * MM
    tail = 0.12 * actuator.roller_distance * MM
    wide = (
        0.5 * actuator.roller_distance * MM
        + max(size, tail)
        + 1.1 * max(abs(pose.deflection) for pose in states[0]) * MM
    )
    high = max(_line(actuator, 0.0) + 2.0 * size, _line(actuator, actuator.clamp_height))
    bounds = Bounds(-wide, wide, -1.06 * high, 1.06 * high)
    with styled():
        titles = [f"Nut distance {view.setting_text(row)}" for row in rows]
        figure, axes = panels(bounds, len(rows), titles=titles, poses=states)
        for part, poses in zip(axes, states, strict=True):
            _bar_one(part, actuator, poses[0], radius)
            for order, pose in enumerate(poses):
                _state(part, actuator, pose, size, tail, zorder=4.0 + order)
        parts = [
            ("nuts on the screw (bar 1)", METAL, "patch"),
            ("rollers on bar 2", "white", "round"),
            ("screw", SOFT, "dash"),
        ]
        legend(figure, parts)
    caption = (
        "The mechanism to scale, in the frame of bar 1, whose screw sets the distance of the nuts."
        " Bar 2 carries the rollers"
        " and moves along the screw: one pair of leaves is squeezed, the other stretched. Grey: the"
        " deflection nearest to zero; colours:"
        " half and whole usable deflection, at the softest and the stiffest usable setting. The"
        " leaves' distance from the"
        " screw is not part of the design."
    )
    if radius is None:
        caption += " Without a protection radius the rollers are drawn at a nominal size."
    return Drawing("mechanism", "The mechanism to scale", figure, caption)


def _protection(actuator: AntagonisticLeaves) -> float | None:
    """Radius of the protecting cylinders [mm], None where the design has none."""
    radius = getattr(actuator.law, "protection_radius", None)
    return None if radius is None else float(radius) * MM


def _line(actuator: AntagonisticLeaves, rise: float) -> float:
    """Height over the screw [mm] of a point of a leaf that has risen by so much from its roller."""
    return (GAP * actuator.clamp_height + rise) * MM


def _leaves(actuator: AntagonisticLeaves, pose: Pose, tail: float) -> list[Array]:
    """Centrelines [mm] from beyond the roller to the clamp, the clamps on the outside as the nuts need it."""
    rest = 0.5 * (actuator.roller_distance - pose.setting)
    lines = []
    for side in (-1.0, 1.0):
        curve = _curve(actuator, rest + side * pose.deflection)
        x = (pose.deflection + side * (0.5 * actuator.roller_distance - curve[:, 0])) * MM
        outward = np.concatenate([[x[0] + side * tail], x])
        height = np.concatenate([[curve[0, 1]], curve[:, 1]])
        line = np.stack([outward, (GAP * actuator.clamp_height + height) * MM], axis=1)
        lines += [line, line * np.array([1.0, -1.0])]
    return lines


def _curve(actuator: AntagonisticLeaves, span: float) -> Array:
    """One leaf from its roller (0, 0) to its clamp (span, rise) [m]."""
    if isinstance(actuator.law, GuidedLeaf):
        return np.asarray(actuator.law.centreline(actuator.leaf, span, actuator.clamp_height, 61), float)
    radius = getattr(actuator.law, "protection_radius", math.inf)
    return between_horizontals(span, actuator.clamp_height, radius=radius)


def _bar_one(axes: Axes, actuator: AntagonisticLeaves, pose: Pose, radius: float | None) -> None:
    nut, top = 0.5 * pose.setting * MM, _line(actuator, actuator.clamp_height)
    left, right = axes.get_xlim()
    axis_line(axes, np.array([[left, 0.0], [right, 0.0]]))
    for side in (-1.0, 1.0):
        if radius is not None:
            # half cylinders, round towards the rollers; the fill comes last, so that the two look like one nut
            turn = 0.0 if side > 0.0 else 180.0
            for edge, zorder in ((METAL, 2.0), ("none", 2.1)):
                for up in (-1.0, 1.0):
                    centre = (side * nut, up * (top - radius))
                    half = Wedge(centre, radius, turn - 90.0, turn + 90.0, facecolor=METAL_LIGHT, edgecolor=edge)
                    half.set(zorder=zorder, linewidth=1.6)
                    axes.add_patch(half)
        block(axes, np.array([side * nut, 0.0]), 0.16 * top, 2.0 * top, colour=METAL, zorder=6.0)


def _state(axes: Axes, actuator: AntagonisticLeaves, pose: Pose, size: float, tail: float, *, zorder: float) -> None:
    for leaf in _leaves(actuator, pose, tail):
        strip(axes, leaf, actuator.leaf.thickness * MM, colour=pose.colour, zorder=zorder)
    height = _line(actuator, 0.0) + size
    for side in (-1.0, 1.0):
        x = pose.deflection * MM + side * 0.5 * actuator.roller_distance * MM
        bar(axes, np.array([[x, -height], [x, height]]), 0.12 * size, colour=FAINT, zorder=0.8)
        for up in (-1.0, 1.0):
            disc(axes, np.array([x, up * height]), size, edge=pose.colour, width=1.7, fill=False, zorder=zorder)
            disc(
                axes,
                np.array([x, up * height]),
                0.06 * size,
                colour=pose.colour,
                edge=pose.colour,
                zorder=zorder,
            )
