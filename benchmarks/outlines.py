"""Polygons with re-entrant corners, some of them many times the same part."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from varistiff.sections.outline import Line, Outline
from varistiff.sections.polygon import polygon_of_points

Corners = list[tuple[float, float]]
SIZE = 0.01  # radius [m]
ELL = [(0.0, 0.0), (0.02, 0.0), (0.02, 0.01), (0.01, 0.01), (0.01, 0.02), (0.0, 0.02)]


def _ring(radii: np.ndarray, angles: np.ndarray) -> Corners:
    points = SIZE * radii.ravel() * np.exp(1j * angles.ravel())
    return [(float(z.real), float(z.imag)) for z in points]


def _repeated(radii: list[float], places: list[float], parts: int) -> Corners:
    """One part of a ring, its corners at shares of its angle, again and again."""
    angles = 2.0 * np.pi / parts * (np.arange(parts)[:, None] + np.array(places))
    return _ring(np.tile(radii, parts), angles)


def _jagged(corners: int, parts: int) -> Corners:
    """Distances between 0.7 and 1 and angles at random."""
    draw = np.random.default_rng(corners)
    count = corners // parts
    places = (np.arange(count) + draw.uniform(-0.3, 0.3, count)) / count
    return _repeated(draw.uniform(0.7, 1.0, count).tolist(), places.tolist(), parts)


def _channel(wall: float) -> Corners:
    """Flanges as long as half the web, which is twice SIZE; lengths of the outer edges."""
    a, b = SIZE, wall * SIZE
    outer = [(0.0, 0.0), (a, 0.0), (a, b), (b, b)]
    return [*outer, *((x, 2.0 * a - y) for x, y in reversed(outer))]


# corners, and for the reference the number of equal parts and of sides in one
RE_ENTRANT = {
    "channel, walls of 4 %": (_channel(0.04), 1, 8),
    "star of 20 points, roots at 0.6": (_repeated([1.0, 0.6], [0.0, 0.5], 20), 20, 2),
    "gear of 25 teeth": (_repeated([0.88, 1.0, 1.0, 0.88], [0.0, 0.06, 0.44, 0.5], 25), 25, 4),
    "ring of 60 corners at random": (_jagged(60, 4), 4, 15),
    "ring of 100 corners at random": (_jagged(100, 4), 4, 25),
}


def part(corners: Corners, parts: int, sides: int) -> Outline:
    """The outline as one of its parts and their number."""
    if parts == 1:
        return polygon_of_points(corners).outline()
    return Outline((tuple(Line(one, two) for one, two in pairwise(corners[: sides + 1])),), rotations=parts)
