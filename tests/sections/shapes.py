"""Outlines that several tests need."""

from __future__ import annotations

import math

import numpy as np

from varistiff.sections.outline import Arc, Curve, Line, Loop, Outline, Points

Corners = list[tuple[float, float]]
L_CORNERS = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]
SPLINED = {"outer_radius": 0.011, "inner_radius": 0.0087, "rails": 6, "rail_width": 0.004, "rail_height": 0.0025}


def circle(centre: tuple[float, float], radius: float, *, hole: bool = False) -> Loop:
    """Four quarters, counter-clockwise or, for a hole, clockwise."""
    quarter = -0.5 * math.pi if hole else 0.5 * math.pi
    return tuple(Arc(centre, radius, k * quarter, quarter) for k in range(4))


def eccentric_tube(hole_radius: float, offset: float) -> Outline:
    """Outer radius 1 about the origin."""
    return Outline((circle((0.0, 0.0), 1.0), circle((offset, 0.0), hole_radius, hole=True)))


def elliptical_ring(a: float, b: float, share: float) -> Outline:
    """Ellipse with a hole that is its smaller copy."""

    def loop(scale: float, way: float) -> Loop:
        def curve(t: Points) -> tuple[Points, Points]:
            angle = 2.0 * np.pi * way * t
            point = scale * np.stack([a * np.cos(angle), b * np.sin(angle)], axis=1)
            return point, 2.0 * np.pi * way * scale * np.stack([-a * np.sin(angle), b * np.cos(angle)], axis=1)

        return (Curve(curve),)

    return Outline((loop(1.0, 1.0), loop(share, -1.0)))


def sector(angle: float, apex: tuple[float, float] = (0.0, 0.0)) -> Outline:
    """Sector of a circle of radius 1, symmetric about a line parallel to x."""
    x, y = apex
    low, high = ((x + math.cos(half), y + math.sin(half)) for half in (-0.5 * angle, 0.5 * angle))
    return Outline(((Line(apex, low), Arc(apex, 1.0, -0.5 * angle, angle), Line(high, apex)),))


def flattened_shaft(flats: int, depth: float) -> Outline:
    """Circular shaft of radius 1 with two or four flats, one of them facing the x axis."""
    edge = math.acos(1.0 - depth)
    flat = Line((1.0 - depth, 0.0), (1.0 - depth, math.sin(edge)))
    return Outline(((flat, Arc((0.0, 0.0), 1.0, edge, math.pi / flats - edge)),), rotations=flats, mirror=True)


def channel(width: float, height: float, wall: float) -> list[tuple[float, float]]:
    """Channel open to +x; width and height between the middles of its walls, the web's middle at x = 0."""
    h, t = 0.5 * wall, 0.5 * height
    return [
        (-h, -t - h),
        (width, -t - h),
        (width, -t + h),
        (h, -t + h),
        (h, t - h),
        (width, t - h),
        (width, t + h),
        (-h, t + h),
    ]


def filleted_angle(leg: float, wall: float, radius: float) -> Outline:
    """Equal angle with its outer corner at the origin and a fillet in the inner one."""
    c, r, e = wall, radius, wall + radius
    return Outline(
        (
            (
                Line((0.0, 0.0), (leg, 0.0)),
                Line((leg, 0.0), (leg, c)),
                Line((leg, c), (e, c)),
                Arc((e, e), r, -0.5 * math.pi, -0.5 * math.pi),
                Line((c, e), (c, leg)),
                Line((c, leg), (0.0, leg)),
                Line((0.0, leg), (0.0, 0.0)),
            ),
        )
    )


def ring(radii: np.ndarray | float, angles: np.ndarray) -> Corners:
    """Corners at distances from the origin."""
    points = radii * np.exp(1j * angles)
    return [(float(z.real), float(z.imag)) for z in points]


def even(count: int) -> np.ndarray:
    """Angles, evenly round."""
    return 2.0 * np.pi * np.arange(count) / count


def star(points: int, root: float) -> Corners:
    """Points at the distance 1, roots between them."""
    return ring(np.tile([1.0, root], points), even(2 * points))


def gear(teeth: int) -> Corners:
    """Straight-sided teeth from 0.88 to 1, a little narrower at the top."""
    angles = even(teeth)[:, None] + 2.0 * np.pi / teeth * np.array([0.0, 0.06, 0.44, 0.5])
    return ring(np.tile([0.88, 1.0, 1.0, 0.88], teeth), angles.ravel())


def jagged(corners: int, seed: int, lowest: float = 0.7) -> Corners:
    """A ring with distances and angles at random, one quarter of it repeated four times."""
    draw = np.random.default_rng(seed)
    count = corners // 4
    radii, angles = draw.uniform(lowest, 1.0, count), (np.arange(count) + draw.uniform(-0.3, 0.3, count)) / count
    return ring(np.tile(radii, 4), 0.5 * np.pi * (np.arange(4)[:, None] + angles).ravel())


def comb(teeth: int) -> Corners:
    """Plate of width 1 with slots as wide as the teeth between them, 0.6 deep."""
    pitch = 1.0 / (2 * teeth - 1)
    corners = [(0.0, -0.5), (1.0, -0.5)]
    for tooth in range(teeth):
        right = 1.0 - 2 * tooth * pitch
        corners += [(right, 0.6), (right - pitch, 0.6)]
        if tooth < teeth - 1:
            corners += [(right - pitch, 0.0), (right - 2.0 * pitch, 0.0)]
    return corners
