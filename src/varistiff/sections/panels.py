"""Quadrature nodes on a boundary: Gauss-Legendre panels, graded to corners and to near neighbours."""

from __future__ import annotations

import math
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.sections.boundary import SMOOTH, Boundary, Corner, gauss
from varistiff.sections.outline import Points, Segment, is_straight
from varistiff.sections.separation import CROWDED, Breaks, overlong_panels, split_overlong, spread

GRADING = 3.0  # ratio of neighbouring panels towards a corner
TURN = math.pi / 3.0  # largest change of direction along one panel
PACE = 2.0  # largest ratio of speeds along one panel
NODES_MAX = 6000  # a dense matrix of 290 MB


class Condensed(NamedTuple):
    """Corners that stand on one panel of each side, see ``wedge``.

    ``rows`` of shape (m, 2 n) are their nodes: of the side before the corner, outward from it, then of the side after.
    ``angle`` [rad] and the panels' ``length`` [m] have the shape (m,), ``point`` [m] (m, 2).
    """

    rows: NDArray[np.int_]
    angle: NDArray[np.float64]
    length: NDArray[np.float64]
    point: Points


class Nodes(NamedTuple):
    """Quadrature nodes of the fundamental pieces, panel after panel.

    ``position``, from ``origin``, and ``tangent`` of shape (n, 2); ``weight`` (n,) holds ds; ``parameters`` holds t,
    one array a segment; ``condensed`` the corners that no panel is graded to, where there are such.
    """

    parameters: tuple[NDArray[np.float64], ...]
    position: Points
    tangent: Points
    weight: NDArray[np.float64]
    order: int
    corners: tuple[Corner, ...]
    origin: Points
    condensed: Condensed | None = None

    @property
    def normal(self) -> Points:
        """Normal out of the material, shape (n, 2)."""
        return np.stack([self.tangent[:, 1], -self.tangent[:, 0]], axis=1)


def place_nodes(boundary: Boundary, *, order: int, tolerance: float, limit: int = NODES_MAX) -> Nodes:
    """Return quadrature nodes for the fundamental pieces of a boundary.

    Parameters
    ----------
    order : nodes a panel
    tolerance : share of the result that the innermost panels at a corner may cost
    limit : of the number of nodes

    Raises
    ------
    InputError : the boundary has so many corners, or comes so close to itself, that more nodes would be needed
    """
    levels = grading_levels(boundary, tolerance)
    if levels.sum() + len(levels) > limit // order:
        raise InputError(CROWDED)
    breaks = [panel_ends(segment, *pair) for segment, pair in zip(boundary.segments, levels.tolist(), strict=True)]
    overlong = partial(overlong_panels, boundary=boundary, tolerance=tolerance)
    return nodes_between(boundary, split_overlong(breaks, overlong, limit // order), order)


def nodes_between(boundary: Boundary, breaks: Breaks, order: int) -> Nodes:
    """Gauss-Legendre nodes on panels with these ends."""
    t, w = gauss(order)
    parameters, width = spread(breaks, t)
    position, velocity = boundary.traced(parameters)
    speed = np.hypot(*velocity.T)
    weight = (width[:, None] * w).ravel() * speed
    tangent = velocity / speed[:, None]
    return Nodes(tuple(parameters), position, tangent, weight, order, boundary.corners, boundary.origin)


def panel_ends(segment: Segment, first: int, last: int) -> NDArray[np.float64]:
    """Panel ends along one segment: short turns at an even pace, and so many geometric gradings to its ends."""
    # the panel in the middle is as long beside its distance to a graded end as the others
    outermost = 1.0 / (GRADING + 1.0) if first and last else 1.0 / GRADING
    low, high = (outermost * GRADING ** np.arange(1.0 - levels, 1.0) for levels in (first, last))
    marks = np.concatenate([[0.0], low, 1.0 - high[::-1], [1.0]])
    if is_straight(segment):
        return marks
    if first or last:  # a curve bends in the middle too
        marks = np.insert(marks, first + 1, 0.5 * (marks[first] + marks[first + 1]))
    for _ in range(40):
        uneven = _uneven(segment, marks)
        if not uneven.any():
            break
        marks = np.sort(np.concatenate([marks, (0.5 * (marks[:-1] + marks[1:]))[uneven]]))
    return marks


def _inside(marks: NDArray[np.float64], count: int) -> NDArray[np.float64]:
    return (marks[:-1, None] + np.diff(marks)[:, None] * np.linspace(0.0, 1.0, count)).ravel()


def _uneven(segment: Segment, marks: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which panels turn too far, or run at too uneven a pace for their polynomial."""
    velocity = segment.velocity(_inside(marks, 17)).reshape(-1, 17, 2)
    speed = np.hypot(velocity[..., 0], velocity[..., 1])
    angle = np.unwrap(np.arctan2(velocity[..., 1], velocity[..., 0]), axis=1)
    turn = np.abs(np.diff(angle, axis=1)).sum(axis=1)
    found: NDArray[np.bool_] = (turn > TURN) | (speed.max(axis=1) > PACE * speed.min(axis=1))
    return found


def grading_levels(boundary: Boundary, tolerance: float) -> NDArray[np.int_]:
    """Gradings to both ends of each segment, shape (n, 2).

    The energy within a distance h of a corner goes with h^(2 pi/angle). What a panel there costs of it goes with the
    cube of a small bend: so weak is the singularity in the warping, its share of J, and what the two straight sides,
    whose kernels vanish along themselves, see of each other.
    """
    bend = np.abs(boundary.angles - math.pi)
    exponent = 2.0 * math.pi / boundary.angles
    share = np.minimum(1.0, boundary.lengths / boundary.size)[:, None]
    loss = np.minimum(1.0, bend**3) * share**exponent
    levels = np.ceil(np.log(np.maximum(loss / tolerance, 1.0)) / (exponent * math.log(GRADING)))
    return np.where(bend > SMOOTH, levels, 2).astype(int)  # at a smooth joint the curvature may jump
