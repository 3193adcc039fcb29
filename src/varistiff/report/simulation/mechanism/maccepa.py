"""MACCEPA in motion."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np

from varistiff.actuators.maccepa import Maccepa
from varistiff.report.mechanism.maccepa import COILS
from varistiff.report.mechanism.sheet import MM
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.marks import arm, stops, wanted_arm
from varistiff.report.simulation.mechanism.scene import DRIVE, ELEMENT, LINK, SETTING, Builder, Scene
from varistiff.report.style import INK, METAL_LIGHT


def build(actuator: Maccepa, frames: Frames) -> Scene:
    """Build lever, cable, spring and link; the link carries anchor and spring."""
    lever, anchor = actuator.lever_length * MM, actuator.anchor_distance * MM
    elongation = actuator.elongation(jnp.asarray(frames.deflection), jnp.asarray(frames.setting))
    pull = np.maximum(np.asarray(elongation), 0.0) * MM
    size = max(lever, anchor)
    tail = anchor + 0.45 * size + float(pull.max())
    builder = Builder(frames.count, frames.upright)
    builder.dial(1.18 * lever)
    link, drive, fixed = builder.body(frames.link), builder.body(frames.driven), builder.body()
    stops(builder, frames, 0.7 * tail, 0.9 * tail, 0.12 * size)
    builder.beam(link, 0.0, tail, 0.12 * size)
    arm(builder, link, tail, 1.1 * tail, 0.08 * size)
    wanted_arm(builder, frames, 1.3 * lever, 1.15 * tail)
    builder.line(drive, np.array([[0.0, 0.0], [lever, 0.0]]), DRIVE, pixels=4.0, width=0.05 * size)
    tip, guide = (_at(frames, place) for place in ((frames.driven, lever), (frames.link, anchor)))
    builder.line(fixed, np.stack([tip, guide], axis=1), INK, pixels=1.6)
    builder.disc(drive, (lever, 0.0), 0.022 * size, fill=METAL_LIGHT)
    steps = np.linspace(0.0, 1.0, 12 * COILS)
    ends = tail - pull
    wave = np.broadcast_to(0.055 * size * np.sin(2.0 * np.pi * COILS * steps), (frames.count, steps.size))
    builder.line(link, np.stack([anchor + np.outer(ends - anchor, steps), wave], axis=2), ELEMENT, pixels=2.0)
    builder.block(link, (anchor, 0.0), 0.035 * size, 0.16 * size)
    plate = builder.body(frames.link, x=ends * np.cos(frames.link), y=ends * np.sin(frames.link))
    builder.block(plate, (0.0, 0.0), 0.02 * size, 0.15 * size, SETTING)
    builder.joint(fixed, 0.035 * size)
    key = (
        ("link with the anchor", LINK, "line"),
        ("drive, lever", DRIVE, "line"),
        ("spring", ELEMENT, "line"),
        ("plate that the cable pulls", SETTING, "patch"),
    )
    caption = (
        "Lever, anchor and cable to scale, in the fixed frame; a tick every 10 degrees. The lever turns with the drive,"
        " the cable runs from its tip through the anchor to the spring. Of the spring only its elongation is to scale."
    )
    return Scene(tuple(builder.parts), key, caption)


def _at(frames: Frames, place: tuple[np.ndarray, float]) -> np.ndarray:
    angle, radius = place
    return radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
