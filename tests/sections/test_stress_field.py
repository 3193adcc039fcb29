"""Stress inside a section, against closed forms and against its own boundary values."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.sections import P3G, Circle, Ellipse, HollowCircle, Rectangle, Section, SplinedTube, Square
from varistiff.sections.polygon import polygon_of_points
from varistiff.sections.saint_venant import solve_torsion
from varistiff.sections.stress_field import stress_field

Points = np.ndarray
ROUNDING = 1e-10  # of the solved warping, relative to the size
FILLETED = SplinedTube(
    outer_radius=0.011, inner_radius=0.0087, rails=6, rail_width=0.004, rail_height=0.0025, root_fillet=0.0005
)
ANGLE = polygon_of_points([(0.0, 0.0), (0.02, 0.0), (0.02, 0.006), (0.006, 0.006), (0.006, 0.02), (0.0, 0.02)])


def _disc(count: int, inner: float = 0.0) -> Points:
    """Points of the unit disc or ring, up to 1e-6 from its edges."""
    numbers = np.random.default_rng(3)
    radius = inner + (1.0 - inner) * (1e-6 + (1.0 - 2e-6) * numbers.random(count))
    angle = 2.0 * math.pi * numbers.random(count)
    return radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)


@pytest.mark.parametrize(
    ("section", "inner"),
    [(Circle(radius=0.01), 0.0), (HollowCircle(outer_radius=0.01, inner_radius=0.008), 0.8)],
)
def test_circles_turn_without_warping(section: Section, inner: float) -> None:
    points = 0.01 * _disc(400, inner)
    found = stress_field(solve_torsion(section.outline()), points)
    np.testing.assert_allclose(found, points[:, ::-1] * [-1.0, 1.0], rtol=0.0, atol=0.01 * ROUNDING)


def test_ellipse() -> None:
    """tau_x = -2 a^2 y/(a^2 + b^2), tau_y = 2 b^2 x/(a^2 + b^2)."""
    a, b = 0.01, 0.006
    points = _disc(400) * [a, b]
    expected = 2.0 * points[:, ::-1] * [-(a**2), b**2] / (a**2 + b**2)
    found = stress_field(solve_torsion(Ellipse(semi_major=a, semi_minor=b).outline()), points)
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=a * ROUNDING)


def test_square_against_its_series() -> None:
    h = 1.0
    numbers = np.random.default_rng(5)
    x, y = numbers.uniform(-0.95, 0.95, (2, 300))
    n = np.arange(1, 500, 2)[:, None]
    k = 0.5 * math.pi * n
    share = 16.0 * h / (math.pi**2 * n**2) * (-1.0) ** ((n - 1) // 2)
    # cosh(k y)/cosh(k) and sinh(k y)/cosh(k) without overflow
    rise, fall = np.exp(k * (np.abs(y) - h)), np.exp(-2.0 * k * np.abs(y))
    cosh, sinh = (rise * (1.0 + way * fall) / (1.0 + np.exp(-2.0 * k * h)) for way in (1.0, -1.0))
    tau_x = (-share * np.sign(y) * sinh * np.cos(k * x)).sum(axis=0)
    tau_y = 2.0 * x - (share * cosh * np.sin(k * x)).sum(axis=0)
    found = stress_field(solve_torsion(Square(across_flats=2.0 * h).outline()), np.stack([x, y], axis=1))
    np.testing.assert_allclose(found, np.stack([tau_x, tau_y], axis=1), rtol=0.0, atol=1e-7)  # the corners' grading


@pytest.mark.parametrize("section", [FILLETED, P3G(mean_diameter=0.02, eccentricity=0.001), ANGLE])
def test_boundary_carries_its_own_stress_and_none_across(section: Section) -> None:
    solution = solve_torsion(section.outline())
    nodes = solution.nodes
    size = float(np.abs(nodes.position).max())
    on = stress_field(solution, nodes.position + np.array(solution.centroid))
    scale = size * (1.0 + np.abs(solution.edge_stress) / size)
    # beside a corner, where the field is not resolved, the rounding of a place counts too: nodes are 1e-10 apart
    corners = np.array([corner.point for corner in solution.corners]).reshape(-1, 2) - np.array(solution.centroid)
    apart = np.hypot(*(nodes.position[:, None] - corners).transpose(2, 0, 1)).min(axis=1, initial=np.inf) > 1e-3 * size
    along = ((on * nodes.tangent).sum(axis=1) - solution.edge_stress) / scale
    np.testing.assert_allclose(along[apart], 0.0, atol=1e-12)
    np.testing.assert_allclose((on * nodes.normal).sum(axis=1)[apart] / scale[apart], 0.0, atol=1e-12)
    inside = nodes.position - 1e-9 * size * nodes.normal
    near = stress_field(solution, inside + np.array(solution.centroid))
    if section is not ANGLE:  # at its sharp corner the stress changes over any distance
        np.testing.assert_allclose((near - on) / scale[:, None], 0.0, atol=1e-6)


def test_torque_of_the_field_is_the_torsion_constant() -> None:
    """J = integral of x tau_y - y tau_x over the area, on a fine grid of a rectangle."""
    wide, tall, count = 0.02, 0.01, 200
    x, y = ((np.arange(count) + 0.5) / count - 0.5) * wide, ((np.arange(count) + 0.5) / count - 0.5) * tall
    points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    section = Rectangle(width=wide, height=tall)
    field = stress_field(solve_torsion(section.outline(), order=6, tolerance=1e-5), points)
    found = (points[:, 0] * field[:, 1] - points[:, 1] * field[:, 0]).mean() * wide * tall
    assert found == pytest.approx(section.torsion_constant, rel=2e-5)  # midpoint rule, 200 cells across
