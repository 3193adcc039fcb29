"""Closed loops of lines, arcs and Bezier curves from a DXF drawing."""

from __future__ import annotations

import io
import logging
import math
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from varistiff.core.errors import InputError
from varistiff.core.suggest import printable
from varistiff.core.textfile import printable_path, printable_problem, read_bytes
from varistiff.sections.bezier import Bezier
from varistiff.sections.loops import SEGMENTS_MAX, loop_area, shown
from varistiff.sections.outline import Arc, Line, Loop, Segment

if TYPE_CHECKING:
    from ezdxf.document import Drawing

Point = tuple[float, float]

DXF_LIMIT = 20_000_000  # bytes
JOINT = 1e-6  # share of the drawing's size within which two ends meet
FITTED = 1e-6  # share of a spline's size by which its Bezier curves may differ
_TURN = math.pi / 8.0  # of an ellipse by one Bezier curve, which then differs by 1e-7 of its axes
_UNITS = {1: 0.0254, 2: 0.3048, 4: 1e-3, 5: 1e-2, 6: 1.0, 9: 2.54e-5, 10: 0.9144, 13: 1e-6, 14: 0.1}  # by $INSUNITS
_INSUNITS = re.compile(r"\$INSUNITS\s+70\s+([0-9]{1,4})\s")
_NOTES = frozenset(  # what a drawing has beside its outline
    {
        "ACAD_TABLE",
        "ARC_DIMENSION",
        "ATTDEF",
        "ATTRIB",
        "DIMENSION",
        "HATCH",
        "IMAGE",
        "LARGE_RADIAL_DIMENSION",
        "LEADER",
        "MTEXT",
        "MULTILEADER",
        "MLEADER",
        "POINT",
        "RAY",
        "TEXT",
        "TOLERANCE",
        "VIEWPORT",
        "WIPEOUT",
        "XLINE",
    }
)
_ALLOWED = "allowed are LINE, ARC, CIRCLE, ELLIPSE, SPLINE and flat polylines that form closed loops"


class _Piece(NamedTuple):
    """A line, an arc (``bulge`` is the tangent of a quarter of its sweep) or a Bezier curve between two points [m]."""

    start: Point
    end: Point
    bulge: float = 0.0
    controls: tuple[Point, Point] | None = None

    def turned(self) -> _Piece:
        controls = (self.controls[1], self.controls[0]) if self.controls else None
        return _Piece(self.end, self.start, -self.bulge, controls)

    def scaled(self, x: float, y: float) -> _Piece:
        def scale(point: Point) -> Point:
            return x * point[0], y * point[1]

        controls = (scale(self.controls[0]), scale(self.controls[1])) if self.controls else None
        return _Piece(scale(self.start), scale(self.end), math.copysign(1.0, x * y) * self.bulge, controls)

    def segment(self) -> Segment:
        if self.controls:
            return Bezier(self.start, *self.controls, self.end)
        (x, y), (dx, dy), bulge = self.start, np.subtract(self.end, self.start).tolist(), self.bulge
        if abs(bulge) < 1e-9:
            return Line(self.start, self.end)
        side = (1.0 - bulge * bulge) / (4.0 * bulge)  # of the centre, left of the chord
        centre = (x + 0.5 * dx - side * dy, y + 0.5 * dy + side * dx)
        radius = math.hypot(dx, dy) * (1.0 + bulge * bulge) / (4.0 * abs(bulge))
        return Arc(centre, radius, math.atan2(y - centre[1], x - centre[0]), 4.0 * math.atan(bulge))


def dxf_loops(path: str | os.PathLike[str], *, unit: float | None = None) -> tuple[Loop, ...]:
    """Return the closed loops in the model space of a DXF file [m], the largest first.

    Lines and arcs, also those of polylines, come over exactly, ellipses within 1e-7 of their axes, splines within 1e-6
    of their size. Ends meet within 1e-6 of the drawing's size. Text, dimensions, hatches, and what lies on a layer that
    is frozen or off, are left out.

    Parameters
    ----------
    unit : what 1 in the file stands for [m]; None for what the file states in $INSUNITS

    Raises
    ------
    InputError : ezdxf is not installed; unreadable, not a DXF file; no unit or two that differ; open ends; anything
        that is no part of a flat outline
    """
    file = printable_path(os.fspath(path))
    try:
        text = _text(path)
        drawing = _drawing(text)
    except InputError as error:
        raise error.located(file=file) from None
    scale = _unit(text, unit)
    try:
        loops = _chained(_all_pieces(drawing, scale))
    except InputError as error:
        raise error.located(file=file) from None
    return tuple(sorted(loops, key=lambda loop: -abs(loop_area(loop))))


def _drawing(text: str) -> Drawing:
    with _quiet():
        try:
            from ezdxf.filemanagement import read
        except ImportError:
            raise InputError("reading DXF needs ezdxf; install it with: pip install 'varistiff[dxf]'") from None
        try:
            return read(io.StringIO(text, newline=None))
        except Exception as error:  # a damaged file makes the reader fail in any way
            raise InputError(f"is not a DXF file that can be read: {_said(error)}") from None


def _text(path: str | os.PathLike[str]) -> str:
    """The file's text, in whatever encoding: only names, which are not used, are ever beyond ASCII."""
    data = read_bytes(path, limit=DXF_LIMIT)
    if not data.strip():
        raise InputError("is empty")
    if b"\0" in data:
        raise InputError("is a binary file; allowed is a DXF file saved as text (ASCII DXF)")
    return data.decode("utf-8", errors="surrogateescape")


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep ezdxf's log, which would reach the screen, silent."""
    logger = logging.getLogger("ezdxf")
    before, logger.disabled = logger.disabled, True
    try:
        yield
    finally:
        logger.disabled = before


def _said(error: Exception) -> str:
    return printable_problem(str(error)) or type(error).__name__


def _unit(text: str, unit: float | None) -> float:
    found = _INSUNITS.search(text)  # ezdxf says metres where the file says nothing
    stated = _UNITS.get(int(found[1])) if found else None
    if unit is None and stated is None:
        raise InputError(
            "is missing, and the DXF file states none; allowed is a unit of length such as mm", field="unit"
        )
    if unit is None or stated is None:
        return unit or stated or 1.0
    if abs(unit - stated) > 1e-9 * stated:
        raise InputError(
            f"is {1e3 * unit:g} mm, but the DXF file states {1e3 * stated:g} mm; allowed is the same, or no unit here",
            field="unit",
        )
    return unit


def _all_pieces(drawing: Drawing, scale: float) -> list[_Piece]:
    found: list[_Piece] = []
    hidden = {layer.dxf.name.casefold() for layer in drawing.layers if layer.is_off() or layer.is_frozen()}
    for entity in drawing.modelspace():
        kind = entity.dxftype()
        if kind in _NOTES or str(entity.dxf.get("layer", "0")).casefold() in hidden:
            continue
        if kind not in _READERS:
            hint = "; explode the block first" if kind == "INSERT" else ""
            raise InputError(f"holds {printable(kind)}; {_ALLOWED}{hint}")
        try:
            with _quiet():
                pieces = _READERS[kind](entity)
        except InputError:
            raise
        except Exception as error:  # tags that are missing or make no sense
            raise InputError(f"holds a {kind} that cannot be read: {_said(error)}") from None
        found += [piece.scaled(scale, scale) for piece in pieces]
        if len(found) > SEGMENTS_MAX:
            raise InputError(f"has more than {SEGMENTS_MAX} lines and curves; allowed are {SEGMENTS_MAX}")
    numbers = [
        number for start, end, bulge, controls in found for number in (*start, *end, bulge, *sum(controls or (), ()))
    ]
    if not all(abs(number) < 1e9 for number in numbers):
        raise InputError("has coordinates that are not finite or too large; allowed are lengths of a cross-section")
    return found


def _flat_point(point: Any) -> Point:
    return float(point[0]), float(point[1])


def _check_level(*heights: float) -> None:
    if max(heights) - min(heights) > 1e-9 * max(1.0, *map(abs, heights)):
        raise InputError(f"is not flat; {_ALLOWED}")


def _in_world(entity: Any, pieces: list[_Piece]) -> list[_Piece]:
    """Pieces given in the entity's own plane, which may look at the drawing from behind."""
    x, y, z = entity.dxf.get("extrusion", (0.0, 0.0, 1.0))
    if math.hypot(x, y) > 1e-9 * abs(z):
        raise InputError(f"is not flat; {_ALLOWED}")
    return [piece.scaled(math.copysign(1.0, z), 1.0) for piece in pieces]


def _line(entity: Any) -> list[_Piece]:
    start, end = entity.dxf.start, entity.dxf.end
    _check_level(start.z, end.z)
    return [_Piece(_flat_point(start), _flat_point(end))]


def _arc(entity: Any) -> list[_Piece]:
    """An arc or circle in two halves, so that no chord is short beside its arc."""
    (x, y), radius = _flat_point(entity.dxf.center), float(entity.dxf.radius)
    start, sweep = 0.0, 2.0 * math.pi
    if entity.dxftype() == "ARC":
        start, end = math.radians(entity.dxf.start_angle), math.radians(entity.dxf.end_angle)
        sweep = (end - start) % (2.0 * math.pi) or 2.0 * math.pi
    angles = (start, start + 0.5 * sweep, start + sweep)
    one, two, three = ((x + radius * math.cos(angle), y + radius * math.sin(angle)) for angle in angles)
    bulge = math.tan(0.125 * sweep)
    return _in_world(entity, [_Piece(one, two, bulge), _Piece(two, three, bulge)])


def _light_polyline(entity: Any) -> list[_Piece]:
    return _in_world(entity, _polyline_pieces(list(entity.get_points("xyb")), closed=bool(entity.closed)))


def _polyline(entity: Any) -> list[_Piece]:
    if not entity.is_2d_polyline:
        raise InputError(f"holds a POLYLINE that is not flat; {_ALLOWED}")
    frame = 16  # flag of the control points of a curve that the polyline itself follows
    vertices = [one.dxf for one in entity.vertices if not one.dxf.get("flags", 0) & frame]
    points = [(one.location.x, one.location.y, one.get("bulge", 0.0)) for one in vertices]
    return _in_world(entity, _polyline_pieces(points, closed=bool(entity.is_closed)))


def _polyline_pieces(points: list[tuple[float, float, float]], *, closed: bool) -> list[_Piece]:
    following = points[1:] + points[:1] if closed else points[1:]
    return [
        _Piece(_flat_point(one), _flat_point(two), float(one[2]))
        for one, two in zip(points, following, strict=False)
        if one[:2] != two[:2]
    ]


def _ellipse(entity: Any) -> list[_Piece]:
    _check_level(entity.dxf.major_axis.z, 0.0)
    _check_level(entity.minor_axis.z, 0.0)
    centre, major, minor = (
        np.array(_flat_point(one)) for one in (entity.dxf.center, entity.dxf.major_axis, entity.minor_axis)
    )
    start = float(entity.dxf.start_param)
    sweep = (float(entity.dxf.end_param) - start) % (2.0 * math.pi)
    if sweep < 1e-9 or sweep > 2.0 * math.pi - 1e-9:
        sweep = 2.0 * math.pi
    count = math.ceil(sweep / _TURN - 1e-9)
    at = start + np.linspace(0.0, sweep, count + 1)[:, None]
    points = centre + np.cos(at) * major + np.sin(at) * minor
    arms = 4.0 / 3.0 * math.tan(0.25 * sweep / count) * (np.cos(at) * minor - np.sin(at) * major)
    return _beziers(points, points[:-1] + arms[:-1], points[1:] - arms[1:])


def _beziers(points: Any, first: Any, second: Any) -> list[_Piece]:
    ends = pairwise(points)
    return [
        _Piece(_flat_point(start), _flat_point(end), 0.0, (_flat_point(one), _flat_point(two)))
        for (start, end), one, two in zip(ends, first, second, strict=True)
    ]


def _spline(entity: Any) -> list[_Piece]:
    tool = entity.construction_tool()
    corners = np.array([tuple(point) for point in tool.control_points])
    _check_level(*corners[:, 2])
    knots, degree = tool.knots(), tool.degree
    spans = sorted(set(knots[degree : len(knots) - degree]))
    tolerance = FITTED * float(np.ptp(corners, axis=0).max())
    found: list[_Piece] = []
    for low, high in pairwise(spans):
        found += _fitted(tool, low, high, tolerance, halvings=8)
        if len(found) > SEGMENTS_MAX:
            raise InputError(f"has a SPLINE of more than {SEGMENTS_MAX} spans; allowed are {SEGMENTS_MAX}")
    return found


def _fitted(tool: Any, low: float, high: float, tolerance: float, halvings: int) -> list[_Piece]:
    """Bezier curves with a spline's points and velocities at their ends; of degree 3 or less they are exact."""
    width = high - low
    inside = 1e-9 * width  # at a knot the velocity may jump
    start, *middle, end = (np.array(tuple(one)[:2]) for one in tool.points(np.linspace(low, high, 5).tolist()))
    velocities = [np.array(tuple(one[1])[:2]) for one in tool.derivatives([low + inside, high - inside], n=1)]
    one, two = start + width / 3.0 * velocities[0], end - width / 3.0 * velocities[1]
    curve = Bezier(*(_flat_point(point) for point in (start, one, two, end)))
    apart = np.hypot(*(curve.point(np.array([0.25, 0.5, 0.75])) - np.array(middle)).T).max()
    if apart <= tolerance or halvings == 0:
        return [_Piece(curve.start, curve.end, 0.0, (curve.control_one, curve.control_two))]
    half = 0.5 * (low + high)
    return [
        *_fitted(tool, low, half, tolerance, halvings - 1),
        *_fitted(tool, half, high, tolerance, halvings - 1),
    ]


_READERS = {
    "LINE": _line,
    "ARC": _arc,
    "CIRCLE": _arc,
    "LWPOLYLINE": _light_polyline,
    "POLYLINE": _polyline,
    "ELLIPSE": _ellipse,
    "SPLINE": _spline,
}


def _chained(pieces: list[_Piece]) -> list[Loop]:
    """Loops of pieces, in whatever order and direction they are drawn."""
    from scipy.spatial import cKDTree

    if not pieces:
        raise InputError(f"holds no outline in its model space; {_ALLOWED}")
    ends = np.array([point for piece in pieces for point in piece[:2]])
    near = JOINT * float(np.ptp(ends, axis=0).max())
    pieces = [piece for piece in pieces if piece.controls or math.dist(piece.start, piece.end) > near]
    if not pieces:
        raise InputError(f"holds no outline in its model space; {_ALLOWED}")
    ends = np.array([point for piece in pieces for point in piece[:2]])
    partners: list[list[int]] = [[] for _ in ends]
    for one, two in sorted(cKDTree(ends).query_pairs(near)):
        partners[one].append(two)
        partners[two].append(one)
    _check_partners(partners, ends)
    loops: list[Loop] = []
    left = set(range(len(pieces)))
    while left:
        first = way = 2 * min(left)  # even: a start, odd: an end
        chain: list[_Piece] = []
        while not chain or way != first:
            left.remove(way // 2)
            piece = pieces[way // 2]
            chain.append(piece if way % 2 == 0 else piece.turned())
            way = partners[way ^ 1][0]
        # ends within the tolerance become one point
        loops.append(tuple(two._replace(start=one.end).segment() for one, two in pairwise([chain[-1], *chain])))
    return loops


def _check_partners(partners: list[list[int]], ends: Any) -> None:
    lone = [shown(ends[number]) for number, found in enumerate(partners) if not found]
    if lone:
        more = f" and {len(lone) - 4} more places" if len(lone) > 4 else ""
        raise InputError(f"is open at {', '.join(lone[:4])}{more}; allowed are closed loops")
    for number, found in enumerate(partners):
        if len(found) > 1:
            raise InputError(
                f"has {len(found) + 1} ends that meet at {shown(ends[number])}; allowed are loops apart from each other"
            )
