"""Roller beam in motion, in the frame of the link that carries the beam."""

from __future__ import annotations

import numpy as np

from varistiff.actuators.roller_beam import RollerBeam
from varistiff.actuators.rollers import FixedPair, SwivellingPair
from varistiff.report.mechanism.roller_beam import NOMINAL_ROLLER
from varistiff.report.mechanism.sheet import MM, rotation
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.scene import ELEMENT, LINK, SETTING, Builder, Scene, resampled
from varistiff.report.style import INK, METAL, METAL_LIGHT
from varistiff.report.view import Array

POINTS = 40  # of the beam


def build(actuator: RollerBeam, frames: Frames) -> Scene:
    """Build link 1 with the clamped beam, and link 2 with the shuttle and its rollers."""
    pairs = zip(frames.deflection, frames.setting, strict=True)
    beam = np.stack([resampled(actuator.element_shapes(d, s)[0] * MM, POINTS) for d, s in pairs])
    along, size, mounting = frames.setting * MM, float(np.abs(beam).max()), actuator.mounting_angle
    builder = Builder(frames.count, frames.upright - mounting if frames.upright else 0.0)
    clamp = np.array([actuator.clamp_offset_along, actuator.clamp_offset_across])
    joint = rotation(mounting) @ -clamp * MM
    first = builder.body()
    behind = joint - rotation(mounting) @ np.array([0.1 * size, 0.0])
    builder.line(first, np.stack([behind, joint]), METAL, pixels=4.0, width=0.03 * size)
    builder.line(first, np.stack([joint, np.zeros(2)]), METAL, pixels=3.0, width=0.016 * size)
    shank = builder.body(mounting + frames.deflection, x=joint[0], y=joint[1])
    reach, wide = 1.08 * float(along.max()), 0.02 * size
    if frames.wanted is not None:
        aim = builder.body(mounting + np.nan_to_num(frames.wanted), x=joint[0], y=joint[1])
        builder.dashes(aim, np.array([[0.0, 0.0], [1.04 * reach, 0.0]]), INK)
    for side, angle in zip((-1.0, 1.0), frames.stops, strict=True):
        if np.isfinite(angle):
            stop = builder.body(mounting + angle, x=joint[0], y=joint[1])
            builder.block(stop, (0.55 * reach, 1.2 * side * wide), 0.1 * reach, wide, INK)
    builder.beam(shank, 0.0, reach, wide)
    if frames.upright:
        builder.disc(shank, (reach, 0.0), wide, fill=LINK)
    builder.line(first, beam, ELEMENT, pixels=2.4, width=actuator.beam.thickness * MM)
    builder.block(first, (-0.016 * size, 0.0), 0.032 * size, 0.05 * size, METAL)
    turned = mounting + frames.deflection
    centre = joint + along[:, None] * np.stack([np.cos(turned), np.sin(turned)], axis=1)
    _shuttle(builder, actuator, (centre, turned), beam)
    builder.joint(builder.body(x=joint[0], y=joint[1]), 0.012 * size)
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


def _shuttle(builder: Builder, actuator: RollerBeam, place: tuple[Array, Array], beam: Array) -> None:
    """Block on link 2 and its rollers; a swivelling pair follows the slope of the beam at its free end."""
    (centre, turned), rollers = place, actuator.rollers
    size, half = float(np.abs(beam).max()), 0.5 * actuator.beam.thickness * MM
    offset = float(rollers.offset) * MM  # type: ignore[attr-defined]  # every arrangement has one; the base has no fields
    slider = builder.body(turned, x=centre[:, 0], y=centre[:, 1])
    builder.block(slider, (0.0, 0.0), 0.03 * size, 0.022 * size, SETTING)
    if isinstance(rollers, SwivellingPair):
        pivot = centre + offset * np.stack([-np.sin(turned), np.cos(turned)], axis=1)
        last = beam[:, -1] - beam[:, -2]
        pair = builder.body(np.arctan2(last[:, 1], last[:, 0]), x=pivot[:, 0], y=pivot[:, 1])
        radius = NOMINAL_ROLLER * size
        spread = rollers.clearance * MM + half + radius
        builder.line(pair, np.array([[0.0, -spread], [0.0, spread]]), INK, pixels=1.2)
        heights = [-spread, spread]
    else:
        pair, radius = slider, float(rollers.radius) * MM  # type: ignore[attr-defined]  # as above
        spread = radius + half + rollers.clearance * MM if isinstance(rollers, FixedPair) else 0.0
        heights = [offset - spread, offset + spread] if spread else [offset]
    for height in heights:
        builder.disc(pair, (0.0, height), radius, fill=METAL_LIGHT, edge=SETTING, pixels=2.0)
