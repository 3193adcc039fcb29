"""Arms that show where link and wanted position point, and what stops the link."""

from __future__ import annotations

import math

import numpy as np

from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.scene import LINK, Body, Builder
from varistiff.report.style import INK


def arm(builder: Builder, body: Body, start: float, end: float, width: float, *, colour: str = LINK) -> None:
    """The link's arm, drawn as a bar of nominal length; where it has weight, with a bob at its end."""
    builder.line(body, np.array([[start, 0.0], [end, 0.0]]), colour, pixels=3.0, width=width)
    if builder.upright:
        builder.disc(body, (end, 0.0), 1.1 * width, fill=colour, edge=INK)


def stops(builder: Builder, frames: Frames, start: float, end: float, width: float) -> None:
    """Fixed blocks that the link's arm, so wide, lies against at the ends of its travel."""
    for side, angle in zip((-1.0, 1.0), frames.stops, strict=True):
        if math.isfinite(angle):
            centre = (0.5 * (start + end), side * 0.8 * width)
            builder.block(builder.body(angle), centre, end - start, 0.6 * width, INK)


def wanted_arm(builder: Builder, frames: Frames, start: float, end: float) -> None:
    """A broken line where the link should point."""
    if frames.wanted is not None:
        builder.dashes(builder.body(np.nan_to_num(frames.wanted)), np.array([[start, 0.0], [end, 0.0]]), INK)
