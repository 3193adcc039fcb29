"""Roller beam in motion, in the frame of the link that carries the beam."""

from __future__ import annotations

import math

import numpy as np

from varistiff.actuators.roller_beam import RollerBeam
from varistiff.actuators.rollers import FixedPair, SwivellingPair
from varistiff.report.mechanism.roller_beam import NOMINAL_ROLLER
from varistiff.report.mechanism.sheet import MM, rotation
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.scene import ELEMENT, LINK, SETTING, Builder, Scene, resampled
from varistiff.report.style import FAINT, INK, METAL, METAL_LIGHT
from varistiff.report.view import Array

POINTS = 40  # of the beam


def build(actuator: RollerBeam, frames: Frames) -> Scene:
    """Build link 1 with the clamped beam, and link 2 with the shuttle and its rollers."""
    # the joint angle is the link's position where no drive turns link 1
    angle = frames.link if frames.drive is None else frames.deflection
    base = np.zeros(frames.count) if frames.drive is None else frames.link
    pairs = zip(frames.deflection, frames.setting, strict=True)
    beam = np.stack([resampled(actuator.element_shapes(d, s)[0] * MM, POINTS) for d, s in pairs])
    along, size = frames.setting * MM, float(np.abs(beam).max())
    upright = frames.upright - actuator.mounting_angle if frames.upright else 0.0
    builder = Builder(frames.count, upright)
    clamp = np.array([actuator.clamp_offset_along, actuator.clamp_offset_across])
    origin = rotation(actuator.mounting_angle) @ -clamp * MM
    turned = actuator.mounting_angle + angle
    shank = builder.body(turned + base, **_place(origin, base))
    first = builder.body(base)
    behind = origin - rotation(actuator.mounting_angle) @ np.array([0.1 * size, 0.0])
    builder.line(first, np.stack([behind, origin]), METAL, pixels=4.0, width=0.03 * size)
    builder.line(first, np.stack([origin, np.zeros(2)]), METAL, pixels=3.0, width=0.016 * size)
    reach = 1.08 * float(along.max())
    if frames.wanted is not None:
        aim = builder.body(actuator.mounting_angle + np.nan_to_num(frames.wanted) + base, **_place(origin, base))
        builder.dashes(aim, np.array([[0.0, 0.0], [1.04 * reach, 0.0]]), INK)
    builder.beam(shank, 0.0, reach, 0.02 * size)
    if frames.upright:
        builder.disc(shank, (reach, 0.0), 0.02 * size, fill=LINK)
    builder.line(first, beam, ELEMENT, pixels=2.4, width=actuator.beam.thickness * MM)
    builder.block(first, (-0.016 * size, 0.0), 0.032 * size, 0.05 * size, METAL)
    _shuttle(builder, actuator, frames, (origin, turned, base), beam)
    builder.joint(builder.body(0.0, **_place(origin, base)), 0.012 * size)
    key = (
        ("link 1, with the clamp", METAL, "line"),
        ("link 2", LINK, "line"),
        ("beam", ELEMENT, "line"),
        ("shuttle with its rollers", SETTING, "patch"),
    )
    caption = (
        "The mechanism to scale, in the frame of link 1, which carries the clamped beam and ends in the joint. Link 2"
        " turns about the joint; the shuttle moves along it with the setting, and its rollers bend the beam."
    )
    if isinstance(actuator.rollers, SwivellingPair):
        caption += " The size of swivelling rollers has no effect, so they are drawn at a nominal one."
    return Scene(tuple(builder.parts), key, caption)


def _place(point: Array, angle: Array) -> dict[str, Array]:
    c, s = np.cos(angle), np.sin(angle)
    return {"x": c * point[0] - s * point[1], "y": s * point[0] + c * point[1]}


def _shuttle(
    builder: Builder, actuator: RollerBeam, frames: Frames, frame: tuple[Array, Array, Array], beam: Array
) -> None:
    """Block on link 2 and its rollers; a swivelling pair follows the slope of the beam at its free end."""
    origin, turned, base = frame
    rollers, size = actuator.rollers, float(np.abs(beam).max())
    along = frames.setting * MM
    offset = float(rollers.offset) * MM  # type: ignore[attr-defined]  # every arrangement has one; the base has no fields
    c, s = np.cos(turned), np.sin(turned)
    centre = np.stack([origin[0] + along * c, origin[1] + along * s], axis=1)
    slider = builder.body(turned + base, **_turned(centre, base))
    builder.block(slider, (0.0, 0.0), 0.03 * size, 0.022 * size, SETTING)
    half = 0.5 * actuator.beam.thickness * MM
    if isinstance(rollers, SwivellingPair):
        pivot = centre + offset * np.stack([-s, c], axis=1)
        last = beam[:, -1] - beam[:, -2]
        slope = np.arctan2(last[:, 1], last[:, 0])
        pair, radius = builder.body(slope + base, **_turned(pivot, base)), NOMINAL_ROLLER * size
        spread = rollers.clearance * MM + half + radius
        builder.line(pair, np.array([[0.0, -spread], [0.0, spread]]), INK, pixels=1.2)
    else:
        pair = builder.body(turned + base, **_turned(centre, base))
        radius = float(rollers.radius) * MM  # type: ignore[attr-defined]  # as above
        spread = radius + half + rollers.clearance * MM if isinstance(rollers, FixedPair) else math.nan
    aside = 0.0 if isinstance(rollers, SwivellingPair) else offset
    sides = (-spread, spread) if math.isfinite(spread) else (0.0,)
    for side in sides:
        builder.disc(pair, (0.0, aside + side), radius, fill=METAL_LIGHT, edge=SETTING, pixels=2.0)
    builder.disc(slider, (0.0, 0.0), 0.004 * size, fill=FAINT)


def _turned(points: Array, angle: Array) -> dict[str, Array]:
    c, s = np.cos(angle), np.sin(angle)
    return {"x": c * points[:, 0] - s * points[:, 1], "y": s * points[:, 0] + c * points[:, 1]}
