"""Exact solutions of shapes that no class of the project knows: holes, curves without symmetry, near-cusps."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.sections.outline import Outline
from varistiff.sections.polygon import polygon_of_points
from varistiff.sections.saint_venant import solve_torsion
from varistiff.sections.solved import largest_stress, solved_properties

from . import shapes
from .oracles.circular_sector import SEMICIRCLE_SHEAR_CENTRE, sector_torsion_constant
from .oracles.eccentric_tube import eccentric_tube
from .oracles.mapped_disk import MappedDisk


@pytest.mark.parametrize(("hole", "offset"), [(0.5, 0.1), (0.5, 0.3), (0.3, 0.6), (0.7, 0.25), (0.2, 0.0)])
def test_eccentric_tube(hole: float, offset: float) -> None:
    """J to 1e-11, W to 1e-9; the thinnest wall is 5 % of the radius."""
    exact = eccentric_tube(hole, offset)
    found = solved_properties(shapes.eccentric_tube(hole, offset))
    assert found.torsion_constant == pytest.approx(exact.torsion_constant, rel=1e-11)
    peak = max(exact.outer_stress, exact.hole_stress)
    assert found.torsion_constant / found.torsion_modulus == pytest.approx(peak, rel=1e-9)


def test_eccentric_tube_meets_roark_for_a_small_offset() -> None:
    """Table 10.1, eccentric hollow circle: K = pi (D^4 - d^4)/(32 C), C = 1 + 16 n^2 l^2/((1 - n^2)(1 - n^4)) + ...

    n = d/D, l = e/D; the next term is of the order l^4, 3e-6 here.
    """
    n, share = 0.5, 0.01
    c = 1.0 + 16.0 * n**2 * share**2 / ((1.0 - n**2) * (1.0 - n**4))
    roark = 0.5 * math.pi * (1.0 - n**4) / c
    assert eccentric_tube(n, 2.0 * share).torsion_constant == pytest.approx(roark, rel=1e-5)


@pytest.mark.parametrize("share", [0.2, 0.6, 0.9])
def test_elliptical_ring(share: float) -> None:
    """A hole along a line of stress takes its own J away and leaves the rest as it was."""
    a, b = 1.5, 0.8
    found = solved_properties(shapes.elliptical_ring(a, b, share))
    whole = math.pi * a**3 * b**3 / (a**2 + b**2)
    assert found.torsion_constant == pytest.approx(whole * (1.0 - share**4), rel=1e-11 if share < 0.9 else 1e-10)
    stress = 2.0 * a**2 * b / (a**2 + b**2)
    assert found.torsion_constant / found.torsion_modulus == pytest.approx(stress, rel=1e-7)


SMOOTH = {
    "limacon": (0, 1, 0.3),
    "tight limacon": (0, 1, 0.42),
    "four lobes": (0, 1, 0, 0, 0, 0.15),
    "no symmetry": (0.3, 1, 0.2, 0.1j),
    "off the axis": (-0.2 + 0.5j, 1, 0.15 + 0.1j, 0, -0.08j),
}


@pytest.mark.parametrize("coefficients", SMOOTH.values(), ids=SMOOTH.keys())
@pytest.mark.parametrize("segments", [1, 3])
def test_image_of_a_disk(coefficients: tuple[complex, ...], segments: int) -> None:
    """J and moments of any smooth curve, also where three pieces join smoothly.

    The stress is a derivative along the boundary: to 5e-3 where the curve is run through unevenly, at its tightest
    bends, and by finer pieces as well as J.
    """
    exact = MappedDisk(coefficients)
    found = solved_properties(exact.outline(segments))
    size = exact.torsion_constant**0.25
    assert found.torsion_constant == pytest.approx(exact.torsion_constant, rel=1e-7)
    assert found.area == pytest.approx(exact.area, rel=1e-12)
    assert found.centroid == pytest.approx((exact.centroid.real, exact.centroid.imag), abs=1e-12 * size)
    assert found.second_moments == pytest.approx(exact.second_moments, abs=1e-11 * size**4)
    centre = exact.shear_centre
    assert found.shear_centre == pytest.approx((centre.real, centre.imag), abs=1e-7 * size)
    assert found.torsion_constant / found.torsion_modulus == pytest.approx(exact.largest_stress, rel=5e-3)
    if segments == 1:
        fine, _ = largest_stress(solve_torsion(exact.outline(16)))
        assert fine == pytest.approx(exact.largest_stress, rel=1e-5)


def test_stated_error_covers_a_near_cusp() -> None:
    """A re-entrant radius of 4e-4 of the size: J is still known to 1e-3, and the section says so."""
    exact = MappedDisk((0, 1, 0.49))
    found = solved_properties(exact.outline(3))
    assert abs(found.torsion_constant / exact.torsion_constant - 1.0) < found.error < 2e-3


@pytest.mark.parametrize("degrees", [45.0, 60.0, 120.0, 180.0, 300.0])
def test_sector_of_a_circle(degrees: float) -> None:
    """The apex is sharp, re-entrant beyond 180 degrees: 1e-11 for convex ones, 1e-9 for the re-entrant one."""
    angle = math.radians(degrees)
    found = solve_torsion(shapes.sector(angle))
    tolerance = 1e-11 if degrees <= 180.0 else 1e-9
    assert found.torsion_constant == pytest.approx(sector_torsion_constant(angle), rel=tolerance)


def test_semicircle() -> None:
    """J = (pi/2 - 4/pi) R^4 and the shear centre are known exactly."""
    found = solved_properties(shapes.sector(math.pi, apex=(0.4, -0.7)))
    assert found.torsion_constant == pytest.approx(0.5 * math.pi - 4.0 / math.pi, rel=1e-11)
    assert found.centroid == pytest.approx((0.4 + 4.0 / (3.0 * math.pi), -0.7), abs=1e-12)
    assert found.shear_centre == pytest.approx((0.4 + SEMICIRCLE_SHEAR_CENTRE, -0.7), abs=1e-11)


def test_reentrant_corner_at_the_origin() -> None:
    """The place of the unbounded stress is the origin itself."""
    found = solved_properties(shapes.sector(math.radians(300.0)))
    assert found.torsion_modulus == 0.0
    assert found.stress_points == ((0.0, 0.0),)


def test_thin_channel() -> None:
    """J = sum of l t^3/3, the shear centre 3 b^2/(h + 6 b) behind the web: both off by the order of t."""
    width, height = 1.0, 2.0
    gap, excess = [], []
    for wall in (0.2, 0.1):
        outline = polygon_of_points(shapes.channel(width, height, wall)).outline()
        found = solve_torsion(outline, order=6, tolerance=1e-5)
        thin = -3.0 * width**2 / (height + 6.0 * width)
        gap.append(abs(found.shear_centre[0] / thin - 1.0))
        assert found.shear_centre[1] == pytest.approx(0.0, abs=1e-6)
        excess.append(abs(found.torsion_constant / ((2.0 * width + height) * wall**3 / 3.0) - 1.0))
    assert gap[1] < 0.6 * gap[0] < 0.06
    assert excess[1] < 0.6 * excess[0] < 0.06


def test_thin_tube_meets_bredt() -> None:
    """A square tube: J = 4 A^2 t/length, exact but for the corners, whose share goes with t."""

    def square(side: float) -> list[tuple[float, float]]:
        h = 0.5 * side
        return [(-h, -h), (h, -h), (h, h), (-h, h)]

    excess = []
    for wall in (0.2, 0.1):
        found = polygon_of_points(square(1.0 + wall), [square(1.0 - wall)])
        solution = solve_torsion(found.outline(), order=6, tolerance=1e-5)
        excess.append(solution.torsion_constant / wall - 1.0)
    assert 0.0 < excess[1] < 0.55 * excess[0] < 0.07
    corners = {(round(x, 9), round(y, 9)): one.is_reentrant for one in solution.corners for x, y in [one.point]}
    assert sorted(corners.values()) == [False] * 4 + [True] * 4


def test_edge_stress_carries_the_torque() -> None:
    """The circulation of the shear flow is 2 A around the section, and 2 A of the hole, backwards, around a hole."""
    exact = MappedDisk(SMOOTH["no symmetry"])
    outline = Outline(exact.outline(1).loops)
    solution = solve_torsion(outline)
    circulation = float((solution.edge_stress * solution.nodes.weight).sum())
    assert circulation == pytest.approx(2.0 * exact.area, rel=1e-9)
    ring = solve_torsion(shapes.eccentric_tube(0.5, 0.3))
    inner = np.hypot(*(ring.nodes.position + np.array(ring.centroid) - [0.3, 0.0]).T) < 0.6
    around = float((ring.edge_stress * ring.nodes.weight)[inner].sum())
    assert around == pytest.approx(-2.0 * math.pi * 0.5**2, rel=1e-9)
