"""Quadrature nodes on a boundary: Gauss-Legendre panels, graded to corners and to near neighbours."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.sections.outline import Image, Outline, Points, Segment

GRADING = 3.0  # ratio of neighbouring panels towards a corner
TURN = math.pi / 3.0  # largest change of direction along one panel
PACE = 2.0  # largest ratio of speeds along one panel
SEPARATION = 1.7  # largest panel length over the distance to the rest of the boundary
SMOOTH = 1e-3  # a corner flatter than this [rad] is a tangent joint, which drawings round to 1e-6 of a length
SAMPLES = np.array([0.0, 0.07, 0.25, 0.5, 0.75, 0.93, 1.0])  # of a panel, to see what is near it
NODES_MAX = 6000  # a dense matrix of 290 MB


@dataclass(frozen=True)
class Corner:
    """Joint of two segments: where, and the angle inside the material [rad]."""

    point: tuple[float, float]
    interior_angle: float

    @property
    def is_reentrant(self) -> bool:
        """Whether the ideal stress is unbounded here."""
        return self.interior_angle > math.pi + SMOOTH

    @property
    def is_sharp(self) -> bool:
        """Whether the tangent jumps."""
        return abs(self.interior_angle - math.pi) > SMOOTH


class Nodes(NamedTuple):
    """Quadrature nodes of the fundamental pieces, panel after panel.

    ``position``, ``tangent`` of shape (n, 2); ``weight`` (n,) holds ds; ``parameters`` holds t, one array a segment.
    """

    parameters: tuple[NDArray[np.float64], ...]
    position: Points
    tangent: Points
    weight: NDArray[np.float64]
    order: int
    corners: tuple[Corner, ...]

    @property
    def normal(self) -> Points:
        """Normal out of the material, shape (n, 2)."""
        return np.stack([self.tangent[:, 1], -self.tangent[:, 0]], axis=1)


class Placed(NamedTuple):
    """All nodes as one element of the symmetry group places them; ``sign`` is -1 for a reflection."""

    position: Points
    tangent: Points
    sign: float


@cache
def gauss(order: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Gauss-Legendre nodes and weights on [0, 1]."""
    nodes, weights = np.polynomial.legendre.leggauss(order)
    return 0.5 * (nodes + 1.0), 0.5 * weights


def images(outline: Outline, position: Points, tangent: Points) -> list[Placed]:
    """Place nodes by every element of the outline's symmetry group, the identity first."""
    found = []
    for turn in range(outline.rotations):
        angle = 2.0 * math.pi * turn / outline.rotations
        c, s = math.cos(angle), math.sin(angle)
        rotation = np.array([[c, s], [-s, c]])
        found.append(Placed(position @ rotation, tangent @ rotation, 1.0))
        if outline.mirror:
            flipped = np.array([1.0, -1.0])
            found.append(Placed((position * flipped) @ rotation, -(tangent * flipped) @ rotation, -1.0))
    return found


def place_nodes(outline: Outline, *, order: int, tolerance: float) -> Nodes:
    """Return quadrature nodes for the fundamental pieces of a boundary.

    Parameters
    ----------
    order : nodes a panel
    tolerance : share of the result that the innermost panels at a corner may cost

    Raises
    ------
    InputError : the boundary comes so close to itself that too many panels would be needed
    """
    segments, ends, corners = _segments_and_corners(outline)
    size = _size(outline)
    breaks = [_breaks(segment, pair, tolerance, size) for segment, pair in zip(segments, ends, strict=True)]
    breaks = _separated(outline, segments, breaks, _Rest(corners, size, tolerance, NODES_MAX // order))
    t, w = gauss(order)
    parameters, position, tangent, weight = [], [], [], []
    for segment, marks in zip(segments, breaks, strict=True):
        low, width = marks[:-1], np.diff(marks)
        at = (low[:, None] + width[:, None] * t).ravel()
        parameters.append(at)
        velocity = segment.velocity(at)
        speed = np.hypot(velocity[:, 0], velocity[:, 1])
        position.append(segment.point(at))
        tangent.append(velocity / speed[:, None])
        weight.append((width[:, None] * w).ravel() * speed)
    return Nodes(
        tuple(parameters), np.concatenate(position), np.concatenate(tangent), np.concatenate(weight), order, corners
    )


def sharp_corners(outline: Outline) -> tuple[Corner, ...]:
    """Corners of an outline's fundamental pieces."""
    return _segments_and_corners(outline)[2]


def _size(outline: Outline) -> float:
    """Diagonal of the section's bounding box, wherever its origin lies [m]."""
    t = np.linspace(0.0, 1.0, 17)
    points = np.concatenate([segment.point(t) for segment in outline.pieces[0]])
    whole = np.concatenate([placed.position for placed in images(outline, points, points)])
    return float(np.hypot(*np.ptp(whole, axis=0)))


def _segments_and_corners(outline: Outline) -> tuple[list[Segment], list[tuple[float, float]], tuple[Corner, ...]]:
    """All fundamental segments, the interior angles at both ends of each, and the corners."""
    segments: list[Segment] = []
    ends: list[tuple[float, float]] = []
    corners: list[Corner] = []
    for number, piece in enumerate(outline.pieces):
        before, after = _neighbours(outline, piece, 1.0 if number == 0 else -1.0)
        chain = [before, *piece, after]
        angles = [_interior_angle(one, two) for one, two in pairwise(chain)]
        segments += piece
        ends += list(pairwise(angles))
        for segment, angle in zip(chain[1:], angles, strict=True):
            x, y = segment.point(np.zeros(1))[0]
            corners.append(Corner((float(x), float(y)), angle))
    sharp = tuple(corner for corner in corners if corner.is_sharp)
    return segments, ends, sharp


def _neighbours(outline: Outline, piece: tuple[Segment, ...], way: float) -> tuple[Segment, Segment]:
    """The segments before and after a fundamental piece, as the symmetry continues it."""
    step = 2.0 * math.pi / outline.rotations
    if not outline.mirror:
        return Image(piece[-1], -way * step), Image(piece[0], way * step)
    low, high = Image(piece[0], 0.0, mirrored=True), Image(piece[-1], step, mirrored=True)
    if way > 0.0:
        return low, high
    return Image(piece[0], step, mirrored=True), Image(piece[-1], 0.0, mirrored=True)


def _interior_angle(one: Segment, two: Segment) -> float:
    (ax, ay), (bx, by) = one.velocity(np.ones(1))[0], two.velocity(np.zeros(1))[0]
    return math.pi - math.atan2(ax * by - ay * bx, ax * bx + ay * by)


def _breaks(segment: Segment, angles: tuple[float, float], tolerance: float, size: float) -> NDArray[np.float64]:
    """Panel ends along one segment: short turns at an even pace, and geometric grading to both ends."""
    share = _lengths(segment, np.array([0.0, 1.0]))[0] / size
    first, last = (GRADING ** -np.arange(_levels(angle, tolerance, share), 0.0, -1.0) for angle in angles)
    count = 2 if first.size or last.size else 1
    marks = np.linspace(0.0, 1.0, count + 1)
    marks = np.concatenate([[0.0], first / count, marks[1:-1], 1.0 - last[::-1] / count, [1.0]])
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


def _lengths(segment: Segment, marks: NDArray[np.float64]) -> NDArray[np.float64]:
    points = segment.point(_inside(marks, 9)).reshape(-1, 9, 2)
    return np.hypot(*np.diff(points, axis=1).transpose(2, 0, 1)).sum(axis=1)


def _levels(angle: float, tolerance: float, share: float) -> int:
    """Gradings to an end: the energy within a distance h of a corner goes with h^(2 pi/angle).

    ``share`` is the segment's length over the size of the section.
    """
    bend = abs(angle - math.pi)
    if bend <= SMOOTH:
        return 2  # the curvature may jump
    exponent = 2.0 * math.pi / angle
    energy = min(1.0, bend) * min(1.0, share) ** exponent
    return max(0, math.ceil(math.log(energy / tolerance) / (exponent * math.log(GRADING))))


class _Rest(NamedTuple):
    """When splitting ends: at ``limit`` panels, and so near to a convex corner that what is there does not count."""

    corners: tuple[Corner, ...]
    size: float
    tolerance: float
    limit: int

    def spared(self, outline: Outline, samples: Points) -> NDArray[np.bool_]:
        """Which panels lie, whole, where the share of the energy is below the tolerance; samples of shape (n, m, 2)."""
        found = np.zeros(len(samples), dtype=bool)
        for corner in self.corners:
            if not corner.is_reentrant:
                reach = self.size * self.tolerance ** (corner.interior_angle / (2.0 * math.pi))
                point = np.array([corner.point])
                for placed in images(outline, point, point):
                    found |= np.hypot(*(samples - placed.position[0]).transpose(2, 0, 1)).max(axis=1) < reach
        return found


def _separated(
    outline: Outline, segments: list[Segment], breaks: list[NDArray[np.float64]], rest: _Rest
) -> list[NDArray[np.float64]]:
    """Split panels until none is long beside its distance to the parts of the boundary that it does not touch."""
    for _ in range(60):
        if sum(marks.size - 1 for marks in breaks) > rest.limit:
            break
        split = _too_long(outline, segments, breaks, rest)
        if not any(mask.any() for mask in split):
            return breaks
        breaks = [
            np.sort(np.concatenate([marks, (0.5 * (marks[:-1] + marks[1:]))[mask]]))
            for marks, mask in zip(breaks, split, strict=True)
        ]
    raise InputError(
        "has walls or gaps too thin, or too many corners, to be solved; allowed are thicker walls, or fewer corners"
    )


def _too_long(
    outline: Outline, segments: list[Segment], breaks: list[NDArray[np.float64]], rest: _Rest
) -> list[NDArray[np.bool_]]:
    at = [(marks[:-1, None] + np.diff(marks)[:, None] * SAMPLES).ravel() for marks in breaks]
    points = np.concatenate([segment.point(t) for segment, t in zip(segments, at, strict=True)])
    tangents = np.concatenate([segment.velocity(t) for segment, t in zip(segments, at, strict=True)])
    tangents /= np.hypot(*tangents.T)[:, None]
    shape = (-1, SAMPLES.size, 2)
    samples = points.reshape(shape)
    length = np.hypot(*np.diff(samples, axis=1).transpose(2, 0, 1)).sum(axis=1)
    long = np.zeros(length.size, dtype=bool)
    for placed in images(outline, points, tangents):
        source, tangent = placed.position.reshape(shape), placed.tangent.reshape(shape)
        # the middles tell which pairs can be near enough at all
        middle = samples[:, None, SAMPLES.size // 2] - source[None, :, SAMPLES.size // 2]
        gap = np.hypot(middle[..., 0], middle[..., 1]) - 0.5 * (length[:, None] + length)
        targets, sources = np.nonzero(length > SEPARATION * gap)
        reach = _reach(samples[targets], source[sources], tangent[sources], 1e-9 * float(length.max()))
        long[sources[length[sources] > SEPARATION * reach]] = True
    long &= ~rest.spared(outline, samples)
    cuts = np.cumsum([marks.size - 1 for marks in breaks])[:-1]
    return list(np.split(long, cuts))


def _reach(target: Points, source: Points, tangent: Points, touching: float) -> NDArray[np.float64]:
    """How far each source panel's kernel is from singular at its target panel; samples (n, m, 2), result (n,) [m].

    It is |d|^2/|d.n|: the distance itself across a gap, the diameter of curvature along one smooth curve.
    """
    dx, dy = (source[:, None, :, axis] - target[:, :, None, axis] for axis in (0, 1))
    square = dx * dx + dy * dy
    across = np.abs(dx * tangent[:, None, :, 1] - dy * tangent[:, None, :, 0])
    # panels that share an end meet at a joint: the grading there deals with them
    meet = square[:, [0, 0, -1, -1], [0, -1, 0, -1]].min(axis=1) < touching**2
    with np.errstate(divide="ignore", invalid="ignore"):
        reach = np.where(across > 1e-12 * np.sqrt(square), square / across, np.inf)
    found: NDArray[np.float64] = np.where(meet, np.inf, reach.min(axis=(1, 2)))
    return found
