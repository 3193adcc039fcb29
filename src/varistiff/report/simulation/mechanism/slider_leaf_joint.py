"""Slider leaf joint in motion, seen along its axis."""

from __future__ import annotations

import math

import jax.numpy as jnp
import numpy as np

from varistiff.actuators.slider_leaf_joint import SliderLeafJoint
from varistiff.report.mechanism.sheet import MM
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.marks import arm, stops, wanted_arm
from varistiff.report.simulation.mechanism.scene import DRIVE, ELEMENT, LINK, SETTING, Builder, Scene, resampled
from varistiff.report.style import FAINT, INK, METAL, METAL_LIGHT
from varistiff.report.view import Array

POINTS = 30  # of a leaf
MOST_SHOWN = 1.25  # of the longest active length: what a leaf shows beyond its slider


def build(actuator: SliderLeafJoint, frames: Frames) -> Scene:
    """Build output disc with leaves, input disc with sliders, and the groove where there is one."""
    active = np.asarray(actuator.active_length(jnp.asarray(frames.setting))) * MM
    radius = actuator.clamp_radius * MM
    rim = radius + MOST_SHOWN * float(active.max())
    builder = Builder(frames.count, frames.upright)
    builder.dial(1.1 * rim)
    link, drive = builder.body(frames.link), builder.body(frames.driven)
    stops(builder, frames, 1.25 * rim, 1.5 * rim, 0.1 * rim)
    arm(builder, link, 0.5 * rim, 1.65 * rim, 0.1 * rim)
    wanted_arm(builder, frames, 1.02 * rim, 1.7 * rim)
    builder.disc(drive, (0.0, 0.0), rim, fill="#f4f6f7", edge=DRIVE, pixels=2.6)
    pointer = np.array([[1.09, 0.0], [0.99, 0.04], [0.99, -0.04]]) * rim
    builder.area(drive, pointer, DRIVE)
    if actuator.groove is not None:
        _grooves(builder, actuator, frames, active)
    builder.disc(link, (0.0, 0.0), radius, fill=METAL_LIGHT, edge=LINK, pixels=2.6)
    _leaves(builder, actuator, frames, rim, active)
    builder.joint(builder.body(), 0.05 * rim)
    key = [
        ("link, output disc", LINK, "line"),
        ("drive, input disc", DRIVE, "line"),
        ("leaf", ELEMENT, "line"),
    ]
    if actuator.groove is not None:
        key.append(("groove of the stiffness disc", SETTING, "line"))
    caption = (
        "The joint to scale along its axis, in the fixed frame; a tick every 10 degrees. The leaves are clamped on the"
        " output disc, which carries the link; the sliders turn with the input disc and move along it with the setting."
    )
    return Scene(tuple(builder.parts), tuple(key), caption)


def _leaves(builder: Builder, actuator: SliderLeafJoint, frames: Frames, rim: float, active: Array) -> None:
    link = builder.body(frames.link)
    thickness, count = actuator.leaf.thickness * MM, actuator.count
    pairs = zip(frames.deflection, frames.setting, strict=True)
    first = np.stack([_visible(actuator.element_shapes(d, s)[0] * MM, rim) for d, s in pairs])
    for index in range(count):
        turn = 2.0 * math.pi * index / count
        c, s = math.cos(turn), math.sin(turn)
        turned = np.array([[c, s], [-s, c]])
        builder.line(link, first @ turned, ELEMENT, pixels=2.2, width=thickness)
        radius = actuator.clamp_radius * MM
        seat = np.array([[-0.06, -0.05], [0.0, -0.05], [0.0, 0.05], [-0.06, 0.05]]) * rim + (radius, 0.0)
        builder.area(link, seat @ turned, METAL)
        angle, place = frames.driven + turn, actuator.clamp_radius * MM + active
        slider = builder.body(angle, x=place * np.cos(angle), y=place * np.sin(angle))
        size = 0.017 * rim
        for side in (-1.0, 1.0):
            builder.disc(slider, (0.0, side * (size + 0.5 * thickness)), size, fill="#ffffff", edge=INK)


def _visible(line: Array, rim: float) -> Array:
    """What lies inside the rim."""
    inside = np.hypot(line[:, 0], line[:, 1]) <= rim
    inside[:2] = True
    return resampled(line[inside], POINTS)


def _grooves(builder: Builder, actuator: SliderLeafJoint, frames: Frames, active: Array) -> None:
    """Grooves of the stiffness disc, which turns against the input disc by the disc angle of the setting."""
    groove = actuator.groove
    assert groove is not None  # asked by the caller
    travel = groove.outer_radius - groove.inner_radius
    here = np.asarray(groove.angle(jnp.asarray(np.clip(active / MM, 0.0, travel))))  # a stop is drawn as passed
    angles = np.linspace(0.0, groove.outer_angle, 41)
    along = (groove.inner_radius + np.asarray(groove.active_length(jnp.asarray(angles)))) * MM
    disc = builder.body(frames.driven - here)
    for index in range(actuator.count):
        around = angles + 2.0 * math.pi * index / actuator.count
        curve = np.stack([along * np.cos(around), along * np.sin(around)], axis=1)
        builder.line(disc, curve, FAINT, pixels=5.0)
        builder.line(disc, curve, SETTING, pixels=2.0)
