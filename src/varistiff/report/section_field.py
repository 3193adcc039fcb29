"""Size of the shear stress in a twisted section on a grid of pixels."""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from matplotlib.path import Path
from scipy.ndimage import distance_transform_edt, map_coordinates

from varistiff.core.errors import InputError
from varistiff.report.section_path import contains, section_path
from varistiff.report.view import Array
from varistiff.sections.boundary import boundary_of
from varistiff.sections.outline import Outline
from varistiff.sections.panels import Nodes, place_nodes
from varistiff.sections.saint_venant import solve_torsion
from varistiff.sections.section import Section
from varistiff.sections.stress_field import stress_field

# nodes a panel and share given up at a corner, of the first solution that stays quick: a picture needs no more
RUNGS = ((6, 1e-4), (4, 1e-3), (3, 1e-2))
QUICK = 3200  # nodes, which take about a second
WORK = 1e7  # points times nodes, about a quarter of a second
PIXELS = 400  # along the longer side


@dataclass(frozen=True)
class SectionField:
    """Stress over torque [1/m^3] at pixel centres, shape (rows, columns), NaN outside; ``extent`` and ``path`` [m]."""

    values: Array
    extent: tuple[float, float, float, float]
    path: Path

    @property
    def filled(self) -> Array:
        """Values with those outside taken from the nearest inside: for a picture that the outline clips."""
        outside = np.isnan(self.values)
        nearest = distance_transform_edt(outside, return_distances=False, return_indices=True)
        found: Array = self.values[tuple(nearest)]
        return found


def section_field(section: Section) -> SectionField:
    """Solve the torsion of a section and evaluate its stress; one sector stands for all where there is a symmetry.

    Raises
    ------
    InputError : so many corners, or such thin walls, that not even the coarsest solution has room
    """
    outline = section.outline()
    solution = solve_torsion(outline, nodes=_nodes(outline))
    loops = outline.polylines()
    path = section_path(loops)
    low, high = loops[0].min(axis=0), loops[0].max(axis=0)
    pitch = float((high - low).max()) / PIXELS
    x, y = (np.arange(a + 0.5 * pitch, b, pitch) for a, b in zip(low, high, strict=True))
    grid = np.stack(np.meshgrid(x, y), axis=-1)
    inside = contains(loops, x, y)
    fine = solution.nodes.weight.size * float(inside.sum())  # the whole boundary, but one sector's points
    coarse = pitch * max(1.0, math.sqrt(fine / WORK))
    folded = _folded(outline, grid[inside])
    start, stop = folded.min(axis=0) - 2.0 * coarse, folded.max(axis=0) + 2.0 * coarse
    sample_x, sample_y = (np.arange(a, b + coarse, coarse) for a, b in zip(start, stop, strict=True))
    samples = np.stack(np.meshgrid(sample_x, sample_y), axis=-1)
    own = contains(loops, sample_x, sample_y)
    if outline.rotations > 1 or outline.mirror:  # points far outside the sector are of no use
        own &= _near_sector(outline, samples, 2.0 * coarse)
    size = np.full(own.shape, np.nan)
    size[own] = np.hypot(*stress_field(solution, samples[own]).T)
    size = SectionField(size, (0.0, 0.0, 0.0, 0.0), path).filled
    values = np.full(inside.shape, np.nan)
    at = (folded - start)[:, ::-1].T / coarse
    values[inside] = map_coordinates(size, at, order=1, mode="nearest") / solution.torsion_constant
    return SectionField(values, (x[0] - pitch / 2, x[-1] + pitch / 2, y[0] - pitch / 2, y[-1] + pitch / 2), path)


def _nodes(outline: Outline) -> Nodes:
    boundary = boundary_of(outline)
    for order, share in RUNGS[:-1]:
        with suppress(InputError):
            return place_nodes(boundary, order=order, tolerance=share, limit=QUICK)
    order, share = RUNGS[-1]
    return place_nodes(boundary, order=order, tolerance=share)


def _folded(outline: Outline, points: Array) -> Array:
    """Points moved by the symmetry into the fundamental sector."""
    if outline.rotations == 1 and not outline.mirror:
        return points
    radius, angle = np.hypot(*points.T), np.arctan2(points[:, 1], points[:, 0])
    step = 2.0 * math.pi / outline.rotations
    angle = np.mod(angle, step)
    if outline.mirror:
        angle = np.minimum(angle, step - angle)
    found: Array = radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return found


def _near_sector(outline: Outline, points: Array, reach: float) -> npt.NDArray[np.bool_]:
    """Whether points lie in the fundamental sector or within a distance of it."""
    end = (1.0 if outline.mirror else 2.0) * math.pi / outline.rotations
    x, y = points[..., 0], points[..., 1]
    above = y >= -reach
    if end < math.pi:
        above &= x * math.sin(end) - y * math.cos(end) >= -reach
    return np.asarray(above)
