"""Torsion tube in motion: from the side, and along its axis."""

from __future__ import annotations

import math

import jax.numpy as jnp
import numpy as np

from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.report.mechanism.element_view import edges_of, evenly_spread, seen_from_the_side, silhouette
from varistiff.report.mechanism.sheet import MM
from varistiff.report.mechanism.torsion_tube import BEARING
from varistiff.report.section_path import section_loops
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.marks import arm, stops, wanted_arm
from varistiff.report.simulation.mechanism.scene import DRIVE, ELEMENT, LINK, Builder, Scene, resampled
from varistiff.report.view import Array

STATIONS = 25  # along the element
OUTLINE = 90  # points of the section that are drawn
LIGHT = "#cfeade"


def build(actuator: TorsionTube, frames: Frames) -> Scene:
    """Build the element between flange and bearing, and beside it the view along the axis."""
    loops = section_loops(actuator.section)
    outer = float(np.hypot(*loops[0].T).max())
    length = (actuator.length if math.isfinite(actuator.length) else float(frames.setting.max())) * MM
    flange = frames.link + _twist(actuator, frames)  # the bearing turns with the link
    side = Builder(frames.count)
    _side_view(side, frames, loops[0], length, flange)
    along = Builder(frames.count, frames.upright, origin=(length + 5.4 * outer, 0.0))
    _axis_view(along, frames, loops, outer)
    key = (
        ("link, counter bearing", LINK, "patch"),
        ("drive, flange", DRIVE, "patch"),
        ("elastic element", LIGHT, "patch"),
    )
    caption = (
        "The mechanism to scale, in the fixed frame. Left, from the side: the element between its flange and the"
        " counter bearing, which the setting moves along it; lines that are straight at rest show the twist. Right,"
        " along the axis: the section at the bearing, the link's arm and the drive's pointer; a tick every 10 degrees."
    )
    if math.isfinite(actuator.series_stiffness):
        caption += " The pointer is ahead of the flange by what the drive train in series is twisted."
    return Scene((*side.parts, *along.parts), key, caption)


def _twist(actuator: TorsionTube, frames: Frames) -> Array:
    """Part of the deflection that twists the element itself [rad]; the rest is in the drive train."""
    active = np.maximum(np.asarray(actuator.effective_length(jnp.asarray(frames.setting))), 0.0)
    own = active / (actuator.shear_modulus * actuator.torsion_constant)
    return np.asarray(frames.deflection * own / np.maximum(own + 1.0 / actuator.series_stiffness, 1e-300))


def _side_view(builder: Builder, frames: Frames, outline: Array, length: float, flange: Array) -> None:
    """The element seen along its section's x axis, y up; it is straight beyond the bearing."""
    outer = float(np.hypot(*outline.T).max())
    active = frames.setting * MM
    fixed, bearing = builder.body(), builder.body(x=active)
    builder.block(fixed, (-0.45 * outer, 0.0), 0.9 * outer, 3.1 * outer, DRIVE)
    builder.block(bearing, (0.0, 0.0), 0.5 * outer, 2.0 * BEARING * outer, LINK)
    edges = edges_of(outline)
    edges = evenly_spread(outline) if edges.points.shape[0] < 3 else edges
    places = np.linspace(0.0, length, STATIONS)
    areas, lines = [], []
    for here, start, end in zip(active, flange, frames.link, strict=True):
        turned = start + (end - start) * np.clip(places / here, 0.0, 1.0)
        low, high = silhouette(outline, turned)
        areas.append(np.stack([np.tile(places, 2), np.concatenate([low, high[::-1]])], axis=1))
        areas[-1][STATIONS:, 0] = places[::-1]
        seen = seen_from_the_side(outline, edges, turned)
        lines.append(np.stack([np.broadcast_to(places, seen.shape), seen], axis=2))
    builder.area(fixed, np.stack(areas), LIGHT, ELEMENT, pixels=1.4)
    for edge in range(edges.points.shape[0]):
        builder.line(fixed, np.stack([line[edge] for line in lines]), ELEMENT, pixels=1.2)
    builder.dashes(fixed, np.array([[-1.2 * outer, 0.0], [length + 0.6 * outer, 0.0]]))


def _axis_view(builder: Builder, frames: Frames, loops: list[Array], outer: float) -> None:
    ring = BEARING * outer
    builder.dial(1.2 * ring)
    link, drive = builder.body(frames.link), builder.body(frames.driven)
    builder.line(drive, np.array([[ring, 0.0], [2.0 * ring, 0.0]]), DRIVE, pixels=3.0, width=0.12 * outer)
    stops(builder, frames, 1.7 * ring, 2.3 * ring, 0.25 * outer)
    arm(builder, link, ring, 2.6 * ring, 0.25 * outer)
    wanted_arm(builder, frames, 1.25 * ring, 2.7 * ring)
    builder.disc(link, (0.0, 0.0), ring, fill=LINK)
    for number, loop in enumerate(loops):
        builder.area(link, resampled(loop, OUTLINE), "#ffffff" if number else LIGHT, ELEMENT, pixels=1.6)
    builder.line(link, np.array([[0.0, 0.0], [outer, 0.0]]), LINK, pixels=2.0)
