"""A cross-section as a path to fill or to clip with."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
from matplotlib.path import Path

from varistiff.report.view import Array
from varistiff.sections.section import Section

MM = 1e3


def section_loops(section: Section) -> list[Array]:
    """Closed polylines of the boundary about the shear centre, which it turns about [mm], the outer one first."""
    axis = np.array(section.properties().shear_centre)
    return [(loop - axis) * MM for loop in section.outline().polylines()]


def section_path(loops: list[Array], *, angle: float = 0.0, centre: tuple[float, float] = (0.0, 0.0)) -> Path:
    """Path of a section turned by an angle [rad] about its own axis, which lies at ``centre``; holes stay open."""
    c, s = math.cos(angle), math.sin(angle)
    turn = np.array([[c, s], [-s, c]])
    points = np.concatenate([loop @ turn + centre for loop in loops])
    codes = np.concatenate([_codes(len(loop)) for loop in loops])
    return Path(points, codes)


def contains(loops: list[Array], x: Array, y: Array) -> npt.NDArray[np.bool_]:
    """Whether the points of a grid, x ascending, lie in the section and not in a hole; shape (y.size, x.size).

    Each row counts how often it crosses the boundary up to a point: far quicker than asking point by point.
    """
    starts, ends = (np.concatenate([loop[part] for loop in loops]) for part in (slice(None, -1), slice(1, None)))
    found = np.empty((y.size, x.size), dtype=np.bool_)
    for row, height in enumerate(y):
        crossing = (starts[:, 1] <= height) != (ends[:, 1] <= height)
        a, b = starts[crossing], ends[crossing]
        at = a[:, 0] + (height - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
        found[row] = np.searchsorted(np.sort(at), x) % 2 == 1
    return found


def _codes(count: int) -> npt.NDArray[np.uint8]:
    codes = np.full(count, Path.LINETO, np.uint8)
    codes[0], codes[-1] = Path.MOVETO, Path.CLOSEPOLY
    return codes
