"""Series elastic joint in motion: a sketch, for it has no dimensions."""

from __future__ import annotations

import math

import numpy as np

from varistiff.actuators.series_elastic import SeriesElastic
from varistiff.report.mechanism.series_elastic import INNER, OUTER, TURNS
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.marks import arm, stops, wanted_arm
from varistiff.report.simulation.mechanism.scene import DRIVE, ELEMENT, LINK, Builder, Scene
from varistiff.report.style import METAL_LIGHT

SIZE = 40.0  # of the sketch
POINTS = 160  # of the spiral


def build(actuator: SeriesElastic, frames: Frames) -> Scene:
    """Build drive shaft, spiral spring and the housing with the link."""
    builder = Builder(frames.count, frames.upright)
    builder.dial(1.25 * SIZE)
    link, drive = builder.body(frames.link), builder.body(frames.driven)
    stops(builder, frames, 1.5 * SIZE, 1.9 * SIZE, 0.16 * SIZE)
    arm(builder, link, SIZE, 2.2 * SIZE, 0.16 * SIZE)
    wanted_arm(builder, frames, 1.15 * SIZE, 2.3 * SIZE)
    builder.disc(link, (0.0, 0.0), 1.12 * SIZE, fill="#f4f6f7", edge=LINK, pixels=2.6)
    part = np.linspace(0.0, 1.0, POINTS)
    # the inner end turns with the drive, the outer one stays with the link
    angle = 2.0 * math.pi * TURNS * (part - 1.0) + np.outer(frames.deflection, 1.0 - part)
    radius = SIZE * (INNER + (OUTER - INNER) * part)
    spiral = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=2)
    builder.line(link, spiral, ELEMENT, pixels=2.6)
    hub = 2.0 * math.pi * TURNS * -1.0
    tip = np.array([math.cos(hub), math.sin(hub)])
    pointer = np.stack([np.zeros(2), INNER * SIZE * tip, 1.06 * SIZE * tip])
    builder.line(drive, pointer[:2], DRIVE, pixels=5.0)
    builder.line(drive, pointer[1:], DRIVE, pixels=1.6)
    builder.area(drive, np.array([[1.24, 0.0], [1.13, 0.045], [1.13, -0.045]]) * SIZE, DRIVE)
    builder.disc(drive, (0.0, 0.0), 0.14 * SIZE, fill=METAL_LIGHT, edge=DRIVE, pixels=2.2)
    key = (("link, housing", LINK, "line"), ("drive shaft", DRIVE, "line"), ("spring", ELEMENT, "line"))
    caption = (
        f"Sketch of the joint in the fixed frame, spring stiffness {actuator.stiffness:.4g} N m/rad: no dimensions are"
        " given, but the angles are true; a tick every 10 degrees."
    )
    return Scene(tuple(builder.parts), key, caption, scaled=False)
