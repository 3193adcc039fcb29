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


def contains(loops: list[Array], points: Array) -> npt.NDArray[np.bool_]:
    """Whether points of shape (..., 2) lie in the section and not in a hole; matplotlib fills holes here."""
    flat = points.reshape(-1, 2)
    inside = Path(loops[0]).contains_points(flat)
    for hole in loops[1:]:
        inside &= ~Path(hole).contains_points(flat)
    found: npt.NDArray[np.bool_] = inside.reshape(points.shape[:-1])
    return found


def _codes(count: int) -> npt.NDArray[np.uint8]:
    codes = np.full(count, Path.LINETO, np.uint8)
    codes[0], codes[-1] = Path.MOVETO, Path.CLOSEPOLY
    return codes
