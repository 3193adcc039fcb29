"""Plane mesh of a cross-section, or of its symmetric sector, graded to its re-entrant corners."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.fe import import_ngsolve
from varistiff.sections.outline import Line, Outline, Segment, is_straight

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

RAYS = ("ray0", "ray1")  # the sector's sides, at the angles 0 and pi/rotations
_GROWTH = 0.7  # how fast an edge's length may grow with the distance from a shorter one
_CORNER = math.radians(1.0)  # turns below this are smooth
_SAMPLES = 33


@dataclass(frozen=True)
class Side:
    """One segment of the boundary of the meshed domain: what it is and which loop it belongs to."""

    segment: Segment
    name: str  # outer, hole, ray0, ray1
    straight: bool


@dataclass(frozen=True)
class Shifted:
    """A segment seen from another origin."""

    segment: Segment
    origin: tuple[float, float]

    def point(self, t: Floats) -> Floats:
        """See ``Segment``."""
        moved: Floats = self.segment.point(t) - np.array(self.origin)
        return moved

    def velocity(self, t: Floats) -> Floats:
        """See ``Segment``."""
        return self.segment.velocity(t)


@dataclass(frozen=True)
class PlaneMesh:
    """Straight-sided triangles of the section or its sector, with the boundary that they follow.

    Parameters
    ----------
    points : vertices [m], shape (n, 2); boundary vertices lie on the boundary
    triangles : counter-clockwise, shape (m, 3)
    edges : boundary edges with the material on their left, shape (b, 2)
    edge_sides, edge_spans : side of each edge, shape (b,), and its parameters t there, shape (b, 2)
    sides : the boundary
    corners : re-entrant corners [m], shape (c, 2): the ideal stress is unbounded there
    angle : of the sector [rad]; 0 for the whole section
    copies : how many sectors, each with its mirror image, make the section
    """

    points: Floats
    triangles: Integers
    edges: Integers
    edge_sides: Integers
    edge_spans: Floats
    sides: tuple[Side, ...]
    corners: Floats
    angle: float
    copies: int

    def curve_points(self, edge: Integers, fraction: Floats) -> Floats:
        """Points of the exact boundary at a fraction in [0, 1] along each given edge, shape (n, 2)."""
        found = np.empty((edge.size, 2))
        t = self.edge_spans[edge, 0] + fraction * np.diff(self.edge_spans[edge], axis=1)[:, 0]
        for side in np.unique(self.edge_sides[edge]):
            chosen = self.edge_sides[edge] == side
            found[chosen] = self.sides[side].segment.point(t[chosen])
        return found


def plane_mesh(
    outline: Outline, *, size: float, edge: float, root: float, turn: float, centre: tuple[float, float] = (0.0, 0.0),
    whole: bool = False,
) -> PlaneMesh:  # fmt: skip
    """Mesh the sector of a symmetric outline, or the whole section.

    Parameters
    ----------
    size : wanted length of an edge away from details [m]
    edge : the same on the outer boundary [m]
    root : the same at a re-entrant corner [m]
    turn : largest turn of the tangent along one edge [rad]
    centre : of rotation [m]; it becomes the origin
    whole : leave the symmetry unused

    Raises
    ------
    InputError : the section cannot be meshed
    """
    sector = outline.mirror and not whole
    angle = math.pi / outline.rotations if sector else 0.0
    loops = _sector_loops(outline, angle) if sector else _whole_loops(outline)
    if centre != (0.0, 0.0):
        loops = [[Side(Shifted(s.segment, centre), s.name, s.straight) for s in loop] for loop in loops]
    sides = tuple(itertools.chain.from_iterable(loops))
    corners = _reentrant(loops)
    grids = _boundary_grids(sides, corners, {"outer": edge}, size, root, turn)
    points, triangles, edges, edge_sides, spans = _triangulate(loops, sides, grids, size)
    copies = outline.rotations if sector else 1
    return PlaneMesh(points, triangles, edges, edge_sides, spans, sides, corners, angle, copies)


def thickness(outline: Outline) -> float:
    """Twice the area over the perimeter [m]: the wall of a tube, the radius of a circle."""
    area, perimeter = 0.0, 0.0
    t = np.arange(0.5, 256.0, dtype=np.float64) / 256.0
    for segment in itertools.chain.from_iterable(outline.loops):
        (x, y), (dx, dy) = segment.point(t).T, segment.velocity(t).T
        area += float(np.mean(x * dy - y * dx)) / 2.0
        perimeter += float(np.mean(np.hypot(dx, dy)))
    return 2.0 * area / perimeter


def _whole_loops(outline: Outline) -> list[list[Side]]:
    return [[_side(s, "hole" if number else "outer") for s in loop] for number, loop in enumerate(outline.loops)]


def _side(segment: Segment, name: str) -> Side:
    return Side(segment, name, is_straight(segment))


def _sector_loops(outline: Outline, angle: float) -> list[list[Side]]:
    """Close the sector: out along the angle 0, the outer boundary, in along the last angle, back along the hole."""
    if len(outline.pieces) > 2:
        raise InputError(
            "a symmetric section has at most one hole, about the origin; allowed is an outline without mirror"
        )
    outer = outline.pieces[0]
    hole = outline.pieces[1] if len(outline.pieces) == 2 else ()
    first, last = np.zeros(1), np.ones(1)
    start, end = outer[0].point(first)[0], outer[-1].point(last)[0]
    inside = (hole[0].point(first)[0], hole[-1].point(last)[0]) if hole else (np.zeros(2), np.zeros(2))
    chain = [_side(_line(inside[1], start), "ray0"), *(_side(s, "outer") for s in outer)]
    chain += [_side(_line(end, inside[0]), "ray1"), *(_side(s, "hole") for s in hole)]
    return [chain]


def _line(start: Floats, end: Floats) -> Line:
    return Line((float(start[0]), float(start[1])), (float(end[0]), float(end[1])))


def _reentrant(loops: list[list[Side]]) -> Floats:
    """Corners whose angle inside the material is more than 180 degrees, mirrored halves counted together."""
    found = []
    for loop in loops:
        for before, after in zip([loop[-1], *loop[:-1]], loop, strict=True):
            come, go = before.segment.velocity(np.ones(1))[0], after.segment.velocity(np.zeros(1))[0]
            turn = math.atan2(come[0] * go[1] - come[1] * go[0], float(come @ go))
            on_ray = (before.name in RAYS) + (after.name in RAYS)
            if on_ray == 2:
                continue
            inside = (math.pi - turn) * (2.0 if on_ray else 1.0)
            if inside > math.pi + _CORNER:
                found.append(after.segment.point(np.zeros(1))[0])
    return np.array(found).reshape(-1, 2)


def _boundary_grids(
    sides: tuple[Side, ...], corners: Floats, own: dict[str, float], size: float, root: float, turn: float
) -> list[Floats]:
    """Parameters t of the boundary vertices of every side: short edges at corners and on tight curves."""
    t = np.linspace(0.0, 1.0, _SAMPLES)
    points = np.stack([side.segment.point(t) for side in sides])
    speed = np.stack([np.hypot(*side.segment.velocity(t).T) for side in sides])
    wanted = np.stack([np.minimum(own.get(side.name, size), _curved_size(side.segment, t, turn)) for side in sides])
    source, allowed = points.reshape(-1, 2), wanted.reshape(-1)
    source, allowed = np.concatenate([source, corners]), np.concatenate([allowed, np.full(len(corners), root)])
    unique = np.argsort(allowed)
    flat = points.reshape(-1, 2)
    limit = np.full(len(flat), np.inf)
    for chunk in np.array_split(unique, max(1, len(unique) // 256)):
        reach = allowed[chunk] + _GROWTH * np.hypot(*(flat[:, None] - source[chunk]).transpose(2, 0, 1))
        limit = np.minimum(limit, reach.min(axis=1))
    density = speed / limit.reshape(points.shape[:2])
    grids = []
    for row in density:
        count = np.concatenate([[0.0], np.cumsum(0.5 * (row[1:] + row[:-1]) * np.diff(t))])
        number = max(1, math.ceil(count[-1] - 0.1))
        grids.append(np.interp(np.linspace(0.0, count[-1], number + 1), count, t))
    return grids


def _curved_size(segment: Segment, t: Floats, turn: float) -> Floats:
    """Length of the arc along which the tangent turns by the angle that one edge may turn."""
    step = 1e-4
    middle = np.clip(t, step, 1.0 - step)
    before, after = segment.velocity(middle - step), segment.velocity(middle + step)
    turned = np.abs(np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], np.sum(before * after, axis=1)))
    length: Floats = np.hypot(*segment.velocity(middle).T) * 2.0 * step * turn / np.maximum(turned, 1e-12)
    return length


def _triangulate(
    loops: list[list[Side]], sides: tuple[Side, ...], grids: list[Floats], size: float
) -> tuple[Floats, Integers, Integers, Integers, Floats]:
    """Mesh the polygon of the boundary vertices with netgen; vertices that netgen adds move onto the boundary."""
    import_ngsolve()
    from netgen.geom2d import SplineGeometry

    chords: list[tuple[int, float, float]] = []
    geometry, scale = SplineGeometry(), 1.0 / size  # netgen's tolerances are absolute: lengths of order 1
    number, rings = 0, []
    for loop in loops:
        starts = [(number + k, t) for k, _ in enumerate(loop) for t in grids[number + k][:-1]]
        ends = [t for k, _ in enumerate(loop) for t in grids[number + k][1:]]
        corner = [sides[side].segment.point(np.array([t]))[0] for side, t in starts]
        names = [geometry.AppendPoint(*(scale * point)) for point in corner]
        for k, ((side, begin), end) in enumerate(zip(starts, ends, strict=True)):
            after = (k + 1) % len(starts)
            length = scale * float(np.hypot(*(corner[after] - corner[k])))
            geometry.Append(["line", names[k], names[after]], bc=len(chords) + 1, maxh=1.5 * length)
            chords.append((side, begin, end))
        number += len(loop)
        rings.append(corner)
    _require_uncrossed(rings)
    try:
        mesh = geometry.GenerateMesh(maxh=1.0, grading=_GROWTH, quad_dominated=False)
    except Exception as error:  # netgen raises its own exceptions
        raise _unmeshed(f"Netgen says: {_first_line(error)}") from None
    points = np.array([point.p for point in mesh.Points()])[:, :2] / scale
    triangles = np.array([[v.nr - 1 for v in element.vertices] for element in mesh.Elements2D()], dtype=np.int64)
    if triangles.size == 0 or triangles.shape[1] != 3:
        raise _unmeshed("Netgen found no triangles")
    found = [
        (element.vertices[0].nr - 1, element.vertices[1].nr - 1, element.index - 1) for element in mesh.Elements1D()
    ]
    return _on_boundary(points, triangles, np.array(found, dtype=np.int64), sides, chords)


def _on_boundary(
    points: Floats,
    triangles: Integers,
    found: Integers,
    sides: tuple[Side, ...],
    chords: list[tuple[int, float, float]],
) -> tuple[Floats, Integers, Integers, Integers, Floats]:
    points = points.copy()
    edge_sides, spans = np.empty(len(found), dtype=np.int64), np.empty((len(found), 2))
    moved: dict[int, Floats] = {}
    for row, (a, b, chord) in enumerate(found):
        side, begin, end = chords[chord]
        segment = sides[side].segment
        ends = segment.point(np.array([begin, end]))
        along = ends[1] - ends[0]
        t = begin + (end - begin) * np.clip(((points[[a, b]] - ends[0]) @ along) / (along @ along), 0.0, 1.0)
        edge_sides[row], spans[row] = side, t
        moved.update(zip((int(a), int(b)), segment.point(t), strict=True))
    for vertex, place in moved.items():
        points[vertex] = place
    corner = points[triangles]
    (x1, y1), (x2, y2) = (corner[:, 1] - corner[:, 0]).T, (corner[:, 2] - corner[:, 0]).T
    twice = x1 * y2 - y1 * x2
    if np.any(np.abs(twice) <= 1e-12 * np.ptp(points) ** 2):
        raise _unmeshed("a triangle has no area")
    triangles = np.where(twice[:, None] > 0.0, triangles, triangles[:, ::-1])
    return points, triangles, found[:, :2], edge_sides, spans


def _require_uncrossed(rings: list[list[Floats]]) -> None:
    """Refuse a polygon whose edges cross, from which Netgen may not come back."""
    from shapely import Polygon

    if not Polygon(rings[0], rings[1:]).is_valid:
        raise _unmeshed("a straight edge along its boundary cuts through a wall or a gap")


def _unmeshed(reason: str) -> InputError:
    return InputError(
        f"the section cannot be meshed ({reason}); allowed is an outline without walls, gaps and details that are far "
        "smaller than the rest",
        field="actuator.section",
    )


def _first_line(error: BaseException) -> str:
    return (str(error).strip() or type(error).__name__).splitlines()[0]
