"""The condensed corner and the close panel, against angles that are known and quadrature by brute force."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.sections.boundary import boundary_of, gauss
from varistiff.sections.close_panels import close_kernels
from varistiff.sections.panels import place_nodes
from varistiff.sections.polygon import polygon_of_points
from varistiff.sections.wedge import DEGREES, NARROW, wedge


@pytest.mark.parametrize("degrees", [45.0, 90.0, 135.0, 179.0, 225.0, 270.0, 315.0])
def test_constants(degrees: float) -> None:
    """(pi - K) 1 is pi less the angle under which the other side is seen, negative from behind.

    Polynomials of this order miss up to 1e-4 of that angle.
    """
    angle = math.radians(degrees)
    s, _ = gauss(DEGREES)
    found = wedge(np.array([angle]), DEGREES).matrix[0].sum(axis=1)
    seen = math.pi - np.abs(np.angle(np.exp(1j * angle) - s))
    expected = math.pi - math.copysign(1.0, math.pi - angle) * seen
    assert found == pytest.approx(np.concatenate([expected, expected]), abs=1e-4)


@pytest.mark.parametrize("order", [3, 5, 8])
def test_straight_corner_is_none(order: int) -> None:
    """At 180 degrees the sides do not see each other; the interpolation over the angle leaves 1e-7."""
    found = wedge(np.array([math.pi]), order)
    assert found.matrix[0] == pytest.approx(math.pi * np.eye(2 * order), abs=1e-7)
    t, _ = gauss(order)
    # along one line (|y|^2 - |x|^2)/2 ds/(y - x) is (y + x)/2 ds: exact for the square of the distance
    square = found.loads[0, :, 2]
    assert square == pytest.approx(np.concatenate([0.25 - 0.5 * t, -(0.25 - 0.5 * t)]), abs=1e-6)


def test_sides_are_alike() -> None:
    """The reflection that swaps them turns the tangents round: the matrix stays, the loads change their sign."""
    order = 4
    swap = np.r_[order : 2 * order, 0:order]
    for found in (wedge(np.array([angle]), order) for angle in (NARROW, 1.0, 4.0, 2.0 * math.pi - NARROW)):
        matrix, loads = found.matrix[0], found.loads[0]
        assert matrix[np.ix_(swap, swap)] == pytest.approx(matrix, abs=1e-14)
        assert loads[swap][:, [1, 0, 2]] == pytest.approx(-loads, abs=1e-14)


def test_batch_is_each() -> None:
    angles = np.array([0.5, 2.0, 4.5])
    many = wedge(angles, 6)
    for number, angle in enumerate(angles):
        one = wedge(np.array([angle]), 6)
        assert many.matrix[number] == pytest.approx(one.matrix[0], abs=1e-13)
        assert many.loads[number] == pytest.approx(one.loads[0], abs=1e-13)
    assert wedge(np.empty(0), 5).matrix.shape == (0, 10, 10)


@pytest.mark.parametrize("order", [3, 6, 10])
def test_close_panels_against_fine_quadrature(order: int) -> None:
    """A bar 3 % as thick as long: (y - x) ds/|y - x|^2 of close pairs, integrated with the panel's own polynomials."""
    outline = polygon_of_points([(0.2, 0.1), (1.2, 0.3), (1.194, 0.33), (0.194, 0.13)]).outline()
    nodes = place_nodes(boundary_of(outline), order=order, tolerance=1e-1)
    found = close_kernels(nodes)
    assert (np.diff(found.points) >= 0).all()
    at = nodes.position @ [1.0, 1.0j]
    t, _ = gauss(order)
    fine, weight = gauss(400)
    checked = 0
    for point, panel, vectors in zip(*found, strict=True):
        own = at[panel * order : (panel + 1) * order]
        chord = (own[-1] - own[0]) / (t[-1] - t[0])
        gap = own[0] + (fine - t[0]) * chord - at[point]
        if np.abs(gap).min() < 0.02 * abs(chord):
            continue  # for the fine quadrature too
        kernel = weight * abs(chord) * gap / np.abs(gap) ** 2
        misses = [abs((vectors * t**power).sum() - (kernel * fine**power).sum()) for power in range(order)]
        assert max(misses) < 1e-9 * np.abs(kernel).sum()
        checked += 1
    assert checked > order
