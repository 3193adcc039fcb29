"""Whether closed loops of segments bound one cross-section."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.sections.bezier import Bezier
from varistiff.sections.outline import Arc, Curve, Line, Loop, Points, Segment, is_straight

SEGMENTS_MAX = 1000  # the solver's dense matrix has room for no more
SAME = 1e-9  # share of the size within which two points are one
THIN = 2e-3  # share of the size under which a wall or gap is too thin
THIN_POINTS = 100_000  # that look for thin places; a boundary 50 times as long as the section is wide has so many
SPIKE = math.radians(5.0)  # smallest angle between the two sides of a corner
CHORD_TURN = 0.0125  # change of direction along one chord of a flattened curve [rad]
SIZES = (1e-6, 1e2)  # of a loop [m]
FARTHEST = 1e4  # coordinate [m]


def check_loops(loops: Sequence[Loop], names: Sequence[str] | None = None) -> tuple[Loop, ...]:
    """Return the loops of a cross-section with the material on their left, neighbouring lines in one line merged.

    Parameters
    ----------
    loops : the outer loop, then the holes, in either sense of rotation; a last line of no length is left out
    names : of the loops, for the errors; by default the fields of a design file: points, holes[0], holes[1], ...

    Raises
    ------
    InputError : a loop that is open, degenerate or crosses itself; loops that touch or do not lie in the outer one;
        walls or gaps thinner than 0.2 % of the size. Its field is the loop's name, and it says where, in mm
    """
    names = names or ["points", *(f"holes[{number}]" for number in range(len(loops) - 1))]
    count = sum(len(loop) for loop in loops)
    if count > SEGMENTS_MAX:
        raise InputError(
            f"has {count} segments with its holes; allowed are {SEGMENTS_MAX}, curves as arcs instead of short lines",
            field=names[0],
        )
    checked: list[Loop] = []
    for number, (loop, name) in enumerate(zip(loops, names, strict=True)):
        try:
            checked.append(_checked(loop, counter_clockwise=number == 0))
        except InputError as error:
            raise error.located(field=name) from None
    rings = [_flat(loop) for loop in checked]
    _check_places(rings, names)
    _check_thickness(rings, names)
    return tuple(checked)


def loop_area(loop: Loop) -> float:
    """Area inside a loop [m^2], above zero if it runs counter-clockwise; curves as fine chords."""
    x, y = _flat(loop).T
    x, y = x - x.mean(), y - y.mean()
    return 0.5 * float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())


def shown(point: NDArray[np.float64] | Sequence[float]) -> str:
    """A place [m] as messages say it."""
    x, y = (round(1e3 * float(value), 9) + 0.0 for value in point)
    return f"({x:.6g}, {y:.6g}) mm"


def _checked(loop: Loop, *, counter_clockwise: bool) -> Loop:
    """One loop alone, checked, merged and turned."""
    loop = _closed(loop)
    ring = _flat(loop)
    if _is_flat(ring):
        raise InputError(f"encloses no area at {shown(ring[0])}; allowed are points that are not all on one line")
    _check_corners(loop)
    loop = _merged(loop)
    _check_simple(ring)
    if (loop_area(loop) > 0.0) != counter_clockwise:
        return tuple(_reversed(segment) for segment in reversed(loop))
    return loop


def _closed(loop: Loop) -> Loop:
    """The loop without a closing point, with its joints and size checked."""
    with np.errstate(all="ignore"):
        starts, ends = _ends(loop, 0.0), _ends(loop, 1.0)
    if not (np.abs([starts, ends]) <= FARTHEST).all():
        raise InputError(f"has a point that is not finite or too far away; allowed are {FARTHEST:g} m at most")
    size = float(np.ptp(_flat(loop), axis=0).max()) if loop else 0.0
    lone = np.array([is_straight(segment) for segment in loop], dtype=bool)
    lone &= np.hypot(*(ends - starts).T) <= SAME * size
    if loop and lone[-1]:  # the closing point
        loop, starts, ends, lone = loop[:-1], starts[:-1], ends[:-1], lone[:-1]
    if len(loop) < 3 and all(is_straight(segment) for segment in loop):
        raise InputError("has fewer than 3 corners; allowed are 3 or more")
    if lone.any():
        raise InputError(f"repeats the point {shown(starts[np.argmax(lone)])}; allowed is each point once")
    gaps = np.hypot(*(np.roll(starts, -1, axis=0) - ends).T)
    worst = int(np.argmax(gaps))
    if gaps[worst] > SAME * size:
        raise InputError(
            f"is open: there are {1e3 * gaps[worst]:.3g} mm between an end at {shown(ends[worst])} and the next start; "
            "allowed is a closed outline"
        )
    if not SIZES[0] <= size <= SIZES[1]:
        raise InputError(
            f"is {1e3 * size:.3g} mm across; allowed is from {1e3 * SIZES[0]:g} mm to {1e3 * SIZES[1]:g} mm"
        )
    return loop


def _ends(loop: Loop, t: float) -> Points:
    return np.array([segment.point(np.array([t]))[0] for segment in loop]).reshape(-1, 2)


def _flat(loop: Loop) -> Points:
    """Corners of a fine polyline along the loop, the first not repeated, shape (n, 2)."""
    parts = []
    for segment in loop:
        count = 1
        if not is_straight(segment):
            velocity = segment.velocity(np.linspace(0.0, 1.0, 33))
            turns = np.abs(np.diff(np.unwrap(np.arctan2(velocity[:, 1], velocity[:, 0])))).sum()
            count = 8 + min(1000, math.ceil(float(turns) / CHORD_TURN))
        # the end is the next one's start: joints that are apart by rounding make no false crossing
        parts.append(segment.point(np.arange(count) / count))
    return np.concatenate(parts) if parts else np.zeros((0, 2))


def _is_flat(ring: Points) -> bool:
    singular = np.linalg.svd(ring - ring.mean(axis=0), compute_uv=False)
    return bool(singular[-1] <= SAME * singular[0])


def _check_corners(loop: Loop) -> None:
    """Refuse corners whose sides lie on each other, inside or outside."""
    after = np.array([segment.velocity(np.zeros(1))[0] for segment in loop])
    before = np.roll([segment.velocity(np.ones(1))[0] for segment in loop], 1, axis=0)
    starts = _ends(loop, 0.0)
    size = float(np.ptp(_flat(loop), axis=0).max())
    still = np.minimum(np.hypot(*after.T), np.hypot(*before.T)) <= SAME * size
    if still.any():
        raise InputError(
            f"has a curve without a direction at {shown(starts[np.argmax(still)])}; allowed are curves whose control "
            "points do not repeat their ends"
        )
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    turn = np.abs(np.arctan2(cross, (before * after).sum(axis=1)))
    sharpest = int(np.argmax(turn))
    if turn[sharpest] > math.pi - SPIKE:
        raise InputError(
            f"has a spike or slit of no thickness at {shown(starts[sharpest])}; allowed are corners with "
            f"{math.degrees(SPIKE):g} deg or more between their sides"
        )


def _merged(loop: Loop) -> Loop:
    """The loop with each run of lines along one straight line as one line."""
    kept: list[Segment] = []
    for segment in loop:
        if kept and (line := _joined(kept[-1], segment)):
            kept[-1] = line
        else:
            kept.append(segment)
    while len(kept) > 1 and (line := _joined(kept[-1], kept[0])):
        kept = [line, *kept[1:-1]]
    return tuple(kept)


def _joined(one: Segment, two: Segment) -> Line | None:
    if not (isinstance(one, Line) and isinstance(two, Line)):
        return None
    (x, y), (px, py) = np.subtract(two.end, one.start), np.subtract(one.end, one.start)
    length = math.hypot(x, y)
    # the corners are no spikes, so a middle point on the line lies between its ends
    return Line(one.start, two.end) if abs(x * py - y * px) <= SAME * length * length else None


def _reversed(segment: Segment) -> Segment:
    if isinstance(segment, Line):
        return Line(segment.end, segment.start)
    if isinstance(segment, Arc):
        return Arc(segment.centre, segment.radius, segment.start_angle + segment.sweep, -segment.sweep)
    if isinstance(segment, Bezier):
        return Bezier(segment.end, segment.control_two, segment.control_one, segment.start)
    return Curve(lambda t: (segment.point(1.0 - t), -segment.velocity(1.0 - t)))


def _check_simple(ring: Points) -> None:
    import shapely

    if shapely.LinearRing(ring).is_simple:
        return
    found = re.search(r"\[(\S+) (\S+)\]", shapely.is_valid_reason(shapely.Polygon(ring)))
    where = f" at {shown((float(found[1]), float(found[2])))}" if found else ""
    raise InputError(f"crosses or touches itself{where}; allowed is an outline that meets itself nowhere")


def _check_places(rings: Sequence[Points], names: Sequence[str]) -> None:
    """Refuse loops that meet, holes outside the outer loop, and holes in holes."""
    import shapely

    lines, solids = [shapely.LinearRing(ring) for ring in rings], [shapely.Polygon(ring) for ring in rings]
    allowed = "allowed are holes apart from each other and inside the outer loop"
    for one, two in _pairs(lines, "intersects"):
        if one < two:
            where = shapely.get_coordinates(lines[one].intersection(lines[two]))[0]
            raise InputError(f"crosses or touches {names[one]} at {shown(where)}; {allowed}", field=names[two])
    inside = set(_pairs(solids, "contains"))
    for number, ring in enumerate(rings[1:], start=1):
        if (0, number) not in inside:
            raise InputError(f"lies outside {names[0]} at {shown(ring[0])}; {allowed}", field=names[number])
    for one, two in sorted(inside):
        if 0 < one != two:
            where = rings[two][0]
            raise InputError(f"lies inside the hole {names[one]} at {shown(where)}; {allowed}", field=names[two])


def _pairs(shapes: Sequence[object], relation: str) -> Iterator[tuple[int, int]]:
    import shapely

    for one, two in shapely.STRtree(shapes).query(shapes, predicate=relation).T:
        yield int(one), int(two)


def _check_thickness(rings: Sequence[Points], names: Sequence[str]) -> None:
    """Refuse places where the boundary comes back to itself, or to another loop, closer than ``THIN``.

    Points every quarter of that distance tell: near each other across the gap, and far apart along the loop.
    """
    from scipy.spatial import cKDTree

    limit = THIN * float(np.ptp(rings[0], axis=0).max())
    closed = [np.concatenate([ring, ring[:1]]) for ring in rings]
    marks = [np.append(0.0, np.cumsum(np.hypot(*np.diff(ring, axis=0).T))) for ring in closed]
    lengths = np.array([mark[-1] for mark in marks])
    step = max(0.25 * limit, float(lengths.sum()) / THIN_POINTS)
    along = [np.linspace(0.0, length, max(8, math.ceil(length / step)), endpoint=False) for length in lengths]
    points = [
        np.stack([np.interp(at, mark, column) for column in ring.T], axis=1)
        for at, mark, ring in zip(along, marks, closed, strict=True)
    ]
    loops = [np.full(at.size, number) for number, at in enumerate(along)]
    place = np.concatenate(points)
    loop, distance = np.concatenate(loops), np.concatenate(along)
    one, two = cKDTree(place).query_pairs(limit, output_type="ndarray").T
    gap = np.hypot(*(place[one] - place[two]).T)
    apart = np.abs(distance[one] - distance[two])
    apart = np.minimum(apart, lengths[loop[one]] - apart)
    corner = 0.5 * math.sin(0.5 * SPIKE)  # sides of a corner that is allowed are never this close
    close = (loop[one] != loop[two]) | (gap < corner * apart)
    if not close.any():
        return
    first = int(np.argmin(np.where(close, gap, np.inf)))
    pair = sorted((int(loop[one[first]]), int(loop[two[first]])))
    other = "itself" if pair[0] == pair[1] else names[pair[0]]
    raise InputError(
        f"comes closer to {other} than {1e3 * limit:.3g} mm at {shown(place[one[first]])}; allowed are walls and gaps "
        f"of {100.0 * THIN:g} % of the size or more",
        field=names[pair[1]],
    )
