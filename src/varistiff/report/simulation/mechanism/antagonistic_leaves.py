"""Antagonistic leaves in motion: a linear device, so both bars slide along the screw."""

from __future__ import annotations

import numpy as np

from varistiff.actuators.antagonistic_leaves import AntagonisticLeaves
from varistiff.report.mechanism.antagonistic_leaves import GAP, NOMINAL
from varistiff.report.mechanism.sheet import MM
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.scene import (
    DRIVE,
    ELEMENT,
    LINK,
    SETTING,
    Body,
    Builder,
    Scene,
    resampled,
)
from varistiff.report.style import INK, METAL_LIGHT, SOFT
from varistiff.report.view import Array

POINTS = 30  # of a leaf


def build(actuator: AntagonisticLeaves, frames: Frames) -> Scene:
    """Build bar 1 (link) with its nuts, bar 2 (drive) with its rollers, and the four leaves."""
    builder = Builder(frames.count)
    height, middle = actuator.clamp_height * MM, 0.5 * actuator.roller_distance * MM
    protection = float(getattr(actuator.law, "protection_radius", np.nan)) * MM
    radius = protection if np.isfinite(protection) else NOMINAL * height
    top = (1.0 + GAP) * height
    link = builder.body(x=frames.link * MM)
    drive = builder.body(x=frames.driven * MM)
    reach = middle + 1.6 * max(radius, 0.24 * middle)
    low = -(GAP * height + 2.0 * radius + 0.2 * height)
    _ruler(builder, frames, reach, low)
    builder.dashes(link, np.array([[-reach, 0.0], [reach, 0.0]]))
    for side in (-1.0, 1.0):
        axle = GAP * height + radius
        builder.line(drive, np.array([[side * middle, -axle], [side * middle, axle]]), DRIVE, width=0.12 * radius)
        if np.isfinite(protection):
            nut = builder.body(x=(frames.link + 0.5 * side * frames.setting) * MM)
            _cylinders(builder, nut, side, radius, top)
    pairs = zip(frames.deflection, frames.setting, strict=True)
    shapes = [[_drawn(line * MM, height) for line in actuator.element_shapes(d, s)] for d, s in pairs]
    for leaf in range(4):
        lines = np.stack([frame[leaf] for frame in shapes])
        builder.line(link, lines, ELEMENT, pixels=2.0, width=actuator.leaf.thickness * MM)
    for side in (-1.0, 1.0):
        nut = builder.body(x=(frames.link + 0.5 * side * frames.setting) * MM)
        builder.block(nut, (0.0, 0.0), 0.16 * top, 2.06 * top, SETTING)
        for up in (-1.0, 1.0):
            builder.disc(drive, (side * middle, up * (GAP * height + radius)), radius, edge=DRIVE, pixels=2.4)
    builder.block(link, (0.0, 0.0), 0.1 * middle, 0.12 * top, LINK)
    key = (
        ("link, bar 1", LINK, "patch"),
        ("drive, bar 2 with rollers", DRIVE, "line"),
        ("nuts of the setting", SETTING, "patch"),
        ("leaf", ELEMENT, "line"),
    )
    caption = (
        "The mechanism to scale, in the fixed frame; a tick every 10 mm. Bar 1 carries the screw with the nuts, bar 2"
        " the rollers. The leaves' distance from the screw is not part of the design."
    )
    if not np.isfinite(protection):
        caption += " Without a protection radius the rollers are drawn at a nominal size."
    return Scene(tuple(builder.parts), key, caption)


def _drawn(line: Array, height: float) -> Array:
    """A leaf of ``element_shapes`` with its clamp on the outside, as the nuts need it, and a tail past its roller."""
    rise = height - np.abs(line[:, 1])  # from the roller
    up = np.sign(line[np.argmax(np.abs(line[:, 1])), 1])
    curve = np.stack([line[:, 0], up * (GAP * height + rise)], axis=1)
    tail = curve[0] + np.array([0.24 * height * np.sign(curve[0, 0] - curve[-1, 0]), 0.0])
    return np.concatenate([tail[None], resampled(curve, POINTS)])


def _cylinders(builder: Builder, nut: Body, side: float, radius: float, top: float) -> None:
    """Half cylinders on a nut, round towards the rollers, that a leaf wraps on."""
    angles = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 25)
    half = radius * np.stack([side * np.cos(angles), np.sin(angles)], axis=1)
    for edge in (INK, ""):  # the fills last, so that the two look like one nut
        for up in (-1.0, 1.0):
            builder.area(nut, half + (0.0, up * (top - radius)), METAL_LIGHT, edge)


def _ruler(builder: Builder, frames: Frames, reach: float, low: float) -> None:
    """A fixed scale below: a tick every 10 mm, a longer one every 50."""
    moved = np.concatenate([frames.link, frames.driven]) * MM
    first, last = float(moved.min()) - reach, float(moved.max()) + reach
    fixed = builder.body()
    builder.line(fixed, np.array([[first, low], [last, low]]), SOFT, pixels=1.0)
    ticks = []
    for step in range(int(np.ceil(first / 10.0)), int(last // 10.0) + 1):
        tall = 0.02 if step % 5 else 0.04
        ticks += [np.array([10.0 * step, low]), np.array([10.0 * step, low - tall * reach]), np.full(2, np.nan)]
    builder.line(fixed, np.array(ticks), INK, pixels=1.0)
