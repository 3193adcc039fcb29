"""A scene as compact JSON for the player of the page.

Lengths are whole hundredths of a millimetre, angles whole hundred-thousandths of a radian; points of a deforming line
are differences to the point before, with null where the pen is lifted.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.scene import Body, Part, Scene
from varistiff.report.view import Array

LENGTH = 100.0  # steps to the millimetre
ANGLE = 1e5  # steps to the radian
SCALE_ROOM = 0.055  # of the width, left free below for the scale bar
DIGITS = 5  # of a number that is read out


@dataclass(frozen=True)
class Readout:
    """A number shown beside the picture, one value per frame in the unit that is shown; NaN where it has none."""

    label: str
    unit: str
    values: Array

    @property
    def digits(self) -> int:
        """Digits after the point that show four in all of its largest value."""
        most = float(np.nanmax(np.abs(self.values)))
        return min(max(3 - math.floor(math.log10(most)), 0), 6) if most > 0.0 else 0


def encode(
    scene: Scene, frames: Frames, *, readouts: Sequence[Readout] = (), events: Sequence[tuple[float, str]] = ()
) -> str:
    """Text of a JSON object; safe inside a script element.

    Parameters
    ----------
    events : instants [s] with their names
    """
    bodies: list[Body] = []
    for part in scene.parts:
        if not any(part.body is body for body in bodies):
            bodies.append(part.body)
    bounds = scene.bounds
    below = SCALE_ROOM * bounds.width if scene.scaled else 0.0
    content = {
        "time": [round(float(time), 6) for time in frames.time],
        "view": [round(side, 2) for side in (bounds.left, bounds.right, bounds.bottom - below, bounds.top)],
        "scaled": scene.scaled,
        "bodies": [_poses(body) for body in bodies],
        "parts": [_part(part, next(i for i, body in enumerate(bodies) if body is part.body)) for part in scene.parts],
        "readouts": [{"digits": each.digits, "values": [_short(value) for value in each.values]} for each in readouts],
        "events": [[round(time, 6), name] for time, name in events],
    }
    text = json.dumps(content, separators=(",", ":"), allow_nan=False, ensure_ascii=False)
    # a name may hold what a page reads as the end of the script, or as the start of a comment in it
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def _poses(body: Body) -> list[Any]:
    """Series of x, y and angle; a single number for one that stays."""
    series = []
    for column, steps in enumerate((LENGTH, LENGTH, ANGLE)):
        values = np.rint(body.poses[:, column] * steps).astype(int)
        series.append(int(values[0]) if (values == values[0]).all() else values.tolist())
    return series


def _part(part: Part, body: int) -> dict[str, Any]:
    look: dict[str, Any] = {"b": body, "e": part.edge, "p": part.pixels}
    if part.fill:
        look["f"] = part.fill
    if part.width:
        look["w"] = round(part.width, 3)
    if part.closed:
        look["c"] = 1
    if part.dashed:
        look["d"] = 1
    if part.radius:
        look["r"] = round(part.radius, 3)
    if part.deforms:
        look["m"] = [_differences(points) for points in part.points]
    else:
        look["s"] = _differences(part.points)
    return look


def _differences(points: Array) -> list[int | None]:
    """x and y of each point less those of the last known one; a single null for a lifted pen."""
    whole = [None if not np.isfinite(point).all() else np.rint(point * LENGTH).astype(int).tolist() for point in points]
    flat: list[int | None] = []
    last = [0, 0]
    for point in whole:
        if point is None:
            flat.append(None)
            continue
        flat += [point[0] - last[0], point[1] - last[1]]
        last = point
    return flat


def _short(value: float) -> float | None:
    return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None
