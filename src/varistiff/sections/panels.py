"""Quadrature nodes on a boundary: Gauss-Legendre panels, graded to corners and to near neighbours."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.sections.outline import Image, Outline, Points, Segment, is_straight

GRADING = 3.0  # ratio of neighbouring panels towards a corner
TURN = math.pi / 3.0  # largest change of direction along one panel
PACE = 2.0  # largest ratio of speeds along one panel
SEPARATION = 1.7  # largest panel length over the distance to the rest of the boundary
SMOOTH = 1e-3  # a corner flatter than this [rad] is a tangent joint, which drawings round to 1e-6 of a length
ENDS = np.array([0.0, 1.0])
SAMPLES = np.array([0.0, 0.07, 0.25, 0.5, 0.75, 0.93, 1.0])  # of a panel, to see what is near it
NODES_MAX = 6000  # a dense matrix of 290 MB
CROWDED = "has walls or gaps too thin, or too many corners, to be solved; allowed are thicker walls, or fewer corners"


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


Breaks = list[NDArray[np.float64]]  # panel ends along each segment, from 0 to 1


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


class Boundary(NamedTuple):
    """What every placing of nodes on an outline needs to know of it, for its fundamental segments.

    ``starts``, from ``origin``, and ``chords`` [m], shape (n, 2); ``curved`` tells which are not their chords;
    ``angles`` holds the interior ones at both ends, and ``neighbours`` the numbers of the segments there, shape (n, 2);
    ``lengths`` [m] shape (n,); what a place costs of J goes with its share of ``size`` [m].
    """

    outline: Outline
    segments: list[Segment]
    curved: list[int]
    starts: Points
    chords: Points
    lengths: NDArray[np.float64]
    angles: NDArray[np.float64]
    neighbours: NDArray[np.int_]
    corners: tuple[Corner, ...]
    origin: Points
    size: float

    def traced(self, parameters: Sequence[NDArray[np.float64]]) -> tuple[Points, Points]:
        """Points from the origin and velocities at t on each segment, one after another, shapes (m, 2)."""
        counts = [t.size for t in parameters]
        velocity = np.repeat(self.chords, counts, axis=0)
        point = np.repeat(self.starts, counts, axis=0) + np.concatenate(parameters)[:, None] * velocity
        first = np.cumsum([0, *counts])
        for number in self.curved:
            own, segment, t = slice(*first[number : number + 2]), self.segments[number], parameters[number]
            point[own], velocity[own] = segment.point(t) - self.origin, segment.velocity(t)
        return point, velocity


def boundary_of(outline: Outline) -> Boundary:
    """The boundary of an outline, from an origin within it so that nothing is lost where it lies far away."""
    segments: list[Segment] = []
    ends: list[Points] = []
    angles: list[NDArray[np.float64]] = []
    corners: list[Corner] = []
    for number, piece in enumerate(outline.pieces):
        joints = _interior_angles(outline, number)
        points = np.array([segment.point(ENDS) for segment in piece])
        segments += piece
        ends.append(points)
        angles.append(np.stack([joints[:-1], joints[1:]], axis=1))
        places = [*points[:, 0].tolist(), points[-1, 1].tolist()]
        corners += [Corner((x, y), angle) for (x, y), angle in zip(places, joints.tolist(), strict=True)]
    starts, stops = np.concatenate(ends).transpose(1, 0, 2)
    lengths = np.hypot(*(stops - starts).T)
    curved = [number for number, segment in enumerate(segments) if not is_straight(segment)]
    for number in curved:
        lengths[number] = np.hypot(*np.diff(segments[number].point(np.linspace(0.0, 1.0, 9)), axis=0).T).sum()
    found = Boundary(
        outline=outline,
        segments=segments,
        curved=curved,
        starts=starts,
        chords=stops - starts,
        lengths=lengths,
        angles=np.concatenate(angles),
        neighbours=_neighbouring(outline),
        corners=tuple(corner for corner in corners if corner.is_sharp),
        origin=np.zeros(2),
        size=0.0,
    )
    if outline.rotations == 1 and not outline.mirror:
        origin = starts.mean(axis=0)
        found = found._replace(starts=starts - origin, origin=origin)
    return found._replace(size=_size(found))


def _neighbouring(outline: Outline) -> NDArray[np.int_]:
    """Numbers of the segments before and after each one; beyond a mirror line lies the segment itself."""
    found, first = [], 0
    for piece in outline.pieces:
        own = first + np.arange(len(piece))
        before, after = np.roll(own, 1), np.roll(own, -1)
        if outline.mirror:
            before[0], after[-1] = own[0], own[-1]
        found.append(np.stack([before, after], axis=1))
        first += own.size
    return np.concatenate(found)


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
    return nodes_between(boundary, _separated(boundary, breaks, tolerance, limit // order), order)


def nodes_between(boundary: Boundary, breaks: Breaks, order: int) -> Nodes:
    """Gauss-Legendre nodes on panels with these ends."""
    t, w = gauss(order)
    parameters, width = _spread(breaks, t)
    position, velocity = boundary.traced(parameters)
    speed = np.hypot(*velocity.T)
    weight = (width[:, None] * w).ravel() * speed
    tangent = velocity / speed[:, None]
    return Nodes(tuple(parameters), position, tangent, weight, order, boundary.corners, boundary.origin)


def _spread(breaks: Breaks, shares: NDArray[np.float64]) -> tuple[list[NDArray[np.float64]], NDArray[np.float64]]:
    """The same places on every panel as t of each segment, and the widths of all panels."""
    low = np.concatenate([marks[:-1] for marks in breaks])
    width = np.concatenate([marks[1:] for marks in breaks]) - low
    first = np.cumsum([marks.size - 1 for marks in breaks])[:-1]
    return np.split((low[:, None] + width[:, None] * shares).ravel(), first * shares.size), width


def sharp_corners(outline: Outline) -> tuple[Corner, ...]:
    """Corners of an outline's fundamental pieces."""
    return boundary_of(outline).corners


def _size(boundary: Boundary) -> float:
    """Length that goes with J by the fourth root [m]: 2.3 (A^4/(40 Ip))^(1/4), which is the diagonal of a square.

    Saint-Venant's estimate of J from the area and the polar moment is low for tubes: the size is rather too small.
    """
    t, w = gauss(16)
    placed = images(boundary.outline, *boundary.traced([t] * len(boundary.segments)))
    velocity = np.concatenate([one.tangent for one in placed])
    point = np.concatenate([one.position for one in placed])
    point -= point.mean(axis=0)  # the origin may lie anywhere
    flux = (point[:, 0] * velocity[:, 1] - point[:, 1] * velocity[:, 0]) * np.tile(w, len(point) // w.size)
    area = 0.5 * float(flux.sum())
    centroid = (point * flux[:, None]).sum(axis=0) / (3.0 * area)
    polar = 0.25 * float(((point**2).sum(axis=1) * flux).sum()) - area * float(centroid @ centroid)
    return 2.3 * area / (40.0 * polar) ** 0.25


def _neighbours(outline: Outline, piece: tuple[Segment, ...], way: float) -> tuple[Segment, Segment]:
    """The segments before and after a fundamental piece, as the symmetry continues it."""
    step = 2.0 * math.pi / outline.rotations
    if not outline.mirror:
        return Image(piece[-1], -way * step), Image(piece[0], way * step)
    low, high = Image(piece[0], 0.0, mirrored=True), Image(piece[-1], step, mirrored=True)
    if way > 0.0:
        return low, high
    return Image(piece[0], step, mirrored=True), Image(piece[-1], 0.0, mirrored=True)


def _interior_angles(outline: Outline, number: int) -> NDArray[np.float64]:
    """At the joints of a fundamental piece's segments, from its start to its end."""
    piece = outline.pieces[number]
    before, after = _neighbours(outline, piece, 1.0 if number == 0 else -1.0)
    velocity = np.array([segment.velocity(ENDS) for segment in (before, *piece, after)]) @ [1.0, 1.0j]
    found: NDArray[np.float64] = math.pi - np.angle(velocity[1:, 0] / velocity[:-1, 1])
    return found


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


def _separated(boundary: Boundary, breaks: Breaks, tolerance: float, limit: int) -> Breaks:
    """Split panels until none is long beside its distance to the parts of the boundary that it does not touch."""
    for _ in range(60):
        if sum(marks.size - 1 for marks in breaks) > limit:
            break
        split = overlong_panels(boundary, breaks, tolerance)
        if not split.any():
            return breaks
        breaks = halved(breaks, split)
    raise InputError(CROWDED)


def halved(breaks: Breaks, split: NDArray[np.bool_]) -> Breaks:
    """The panel ends with some of all panels split in their middles."""
    cuts = np.cumsum([marks.size - 1 for marks in breaks])[:-1]
    return [
        np.sort(np.concatenate([marks, (0.5 * (marks[:-1] + marks[1:]))[mask]]))
        for marks, mask in zip(breaks, np.split(split, cuts), strict=True)
    ]


def overlong_panels(
    boundary: Boundary, breaks: Breaks, tolerance: float, ignored: NDArray[np.bool_] | None = None
) -> NDArray[np.bool_]:
    """Which panels of all are long beside their distance to another, but of pairs ``ignored[target, source]``."""
    points, tangents = boundary.traced(_spread(breaks, SAMPLES)[0])
    tangents /= np.hypot(*tangents.T)[:, None]
    shape = (-1, SAMPLES.size, 2)
    samples = points.reshape(shape)
    length = np.hypot(*np.diff(samples, axis=1).transpose(2, 0, 1)).sum(axis=1)
    long = np.zeros(length.size, dtype=bool)
    for placed in images(boundary.outline, points, tangents):
        source, tangent = placed.position.reshape(shape), placed.tangent.reshape(shape)
        # the middles tell which pairs can be near enough at all
        middle = samples[:, None, SAMPLES.size // 2] - source[None, :, SAMPLES.size // 2]
        gap = np.hypot(middle[..., 0], middle[..., 1]) - 0.5 * (length[:, None] + length)
        near = length > SEPARATION * gap
        if ignored is not None:
            near &= ~ignored
        targets, sources = np.nonzero(near)
        reach = _reach(samples[targets], source[sources], tangent[sources], 1e-9 * float(length.max()))
        long[sources[length[sources] > SEPARATION * reach]] = True
    owner = np.repeat(np.arange(len(breaks)), [marks.size - 1 for marks in breaks])
    if long.any():
        long[long] = ~_spared(boundary, samples[long], owner[long], tolerance)
    return long


def _spared(boundary: Boundary, samples: Points, owner: NDArray[np.int_], tolerance: float) -> NDArray[np.bool_]:
    """Which panels lie, whole, so near to a convex corner of their segment that what is there does not count.

    The share of the energy there is below the tolerance. Samples have the shape (n, m, 2).
    """
    angles = boundary.angles
    shorter = np.minimum(boundary.lengths[:, None], boundary.lengths[boundary.neighbours])
    reach = np.minimum(boundary.size * tolerance ** (angles / (2.0 * math.pi)), shorter)
    reach[angles > math.pi - SMOOTH] = 0.0
    ends, _ = boundary.traced([ENDS] * len(boundary.segments))
    distance = np.hypot(*(samples[:, None] - ends.reshape(-1, 2, 2)[owner][:, :, None]).transpose(3, 0, 1, 2))
    found: NDArray[np.bool_] = (distance.max(axis=2) < reach[owner]).any(axis=1)
    return found


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
