"""Polygons against a method that shares nothing with ours: rational functions fitted to a Dirichlet problem."""

from __future__ import annotations

import pytest

from varistiff.sections import Hexagon, Octagon, Square
from varistiff.sections.polygon import polygon_of_points
from varistiff.sections.regular_polygon import regular_polygon, unit_polygon

from .oracles import rational
from .shapes import L_CORNERS


@pytest.mark.parametrize(("sides", "shape"), [(4, Square), (6, Hexagon), (8, Octagon)])
def test_regular_polygons(sides: int, shape: type) -> None:
    """J to 2e-11: the two methods' conditioning."""
    fitted = rational.regular_polygon(sides, poles=40)
    assert fitted.misfit < 1e-10
    assert shape(across_flats=1.0).torsion_constant == pytest.approx(fitted.torsion_constant, rel=2e-11)
    assert shape(across_flats=0.02).torsion_constant == pytest.approx(fitted.torsion_constant * 0.02**4, rel=2e-11)


@pytest.mark.parametrize("sides", [3, 5, 7, 12])
def test_other_regular_polygons(sides: int) -> None:
    fitted = rational.regular_polygon(sides, poles=40)
    assert unit_polygon(sides).torsion_constant == pytest.approx(fitted.torsion_constant, rel=1e-10)
    assert regular_polygon(sides, 1.0).rotations == sides


@pytest.mark.parametrize(
    ("corners", "tolerance"),
    [
        (L_CORNERS, 1e-9),
        ([(0.0, 0.0), (3.0, 0.2), (2.5, 1.7), (0.4, 1.1)], 1e-9),
        ([(0.0, 0.0), (1.0, 0.0), (0.2, 0.9)], 1e-9),
        ([(0.0, 0.0), (1.0, -0.268), (1.0, 0.268)], 1e-9),
        ([(0.0, 0.0), (2.0, 0.0), (1.4, 0.8), (2.0, 1.8), (0.0, 1.3)], 1e-8),
    ],
    ids=["L", "quadrilateral", "triangle", "acute triangle", "re-entrant pentagon"],
)
def test_polygons(corners: list[tuple[float, float]], tolerance: float) -> None:
    """The fit's own error at 40 poles a corner is the larger one; the misfit bounds it."""
    fitted = rational.polygon([complex(*corner) for corner in corners], poles=40)
    assert polygon_of_points(corners).torsion_constant == pytest.approx(fitted.torsion_constant, rel=tolerance)
