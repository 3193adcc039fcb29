"""Polygons of many corners: few nodes for each, and still J, the largest stress and an honest stated error."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.sections.boundary import boundary_of
from varistiff.sections.outline import Outline
from varistiff.sections.panels import place_nodes
from varistiff.sections.polygon import Polygon, polygon_of_points
from varistiff.sections.rungs import QUICK, RUNGS, difference, rung_nodes
from varistiff.sections.saint_venant import SaintVenant, solve_torsion

from .oracles.regular_polygon import regular_polygon
from .shapes import Corners, channel, even, ring, star


def facets(radius: float, count: int, x: float = 0.0) -> Corners:
    return [(x + a, b) for a, b in ring(radius, even(count))]


def ellipse(count: int, share: float) -> Corners:
    return [(x, share * y) for x, y in ring(1.0, even(count))]


def bean(count: int) -> Corners:
    angles = even(count)
    return ring(1.0 + 0.25 * np.cos(2.0 * angles) + 0.05 * np.sin(3.0 * angles), angles)


def uneven(count: int) -> Corners:
    """On a circle, at random."""
    return ring(1.0, np.sort(np.random.default_rng(count).uniform(0.0, 2.0 * np.pi, count)))


def solved(outline: Outline, order: int, tolerance: float) -> SaintVenant:
    return solve_torsion(outline, order=order, tolerance=tolerance)


@pytest.mark.parametrize("sides", [20, 40, 64, 100, 256])
def test_regular_polygons_as_the_conformal_map_has_them(sides: int) -> None:
    """The whole outline, without its symmetry: J to 1e-7, better than stated; the stress to 2e-4."""
    exact = regular_polygon(sides)
    found = polygon_of_points(ring(1.0, 0.1 + even(sides))).properties()
    error = abs(found.torsion_constant / exact.torsion_constant - 1.0)
    assert error < min(found.error, 1e-7)
    assert found.error < 2e-6
    assert found.torsion_constant / found.torsion_modulus == pytest.approx(exact.largest_stress, rel=2e-4)
    middle = math.cos(math.pi / sides)  # of a side, where the stress is largest
    assert [math.hypot(*point) for point in found.stress_points] == pytest.approx([middle], rel=1e-4)


SHAPES: dict[str, tuple[Polygon, float]] = {
    "40 facets of an ellipse": (polygon_of_points(ellipse(40, 0.55)), 1e-6),
    "100 facets of an ellipse": (polygon_of_points(ellipse(100, 0.3)), 1e-6),
    "20 corners at random": (polygon_of_points(uneven(20)), 1e-6),
    "60 corners at random": (polygon_of_points(uneven(60)), 1e-6),
    "bean of 40 facets": (polygon_of_points(bean(40)), 1e-6),
    "bean of 100 facets": (polygon_of_points(bean(100)), 1e-6),
    "15 points": (polygon_of_points(star(15, 0.6)), 1e-4),
    "off-centre bore of 24 facets": (polygon_of_points(facets(1.0, 40), [facets(0.5, 24, x=0.2)]), 1e-6),
    "thin channel": (polygon_of_points(channel(1.0, 2.0, 0.04)), 2e-5),
}


@pytest.mark.parametrize(("section", "tolerance"), SHAPES.values(), ids=SHAPES.keys())
def test_error_is_below_the_stated_one(section: Polygon, tolerance: float) -> None:
    """Against a finer solution, and no more nodes than are quick."""
    fine = solved(section.outline(), 8, 1e-7)
    found = section.properties()
    assert fine.nodes.weight.size > 1.2 * rung_nodes(section.outline())[0].weight.size
    error = abs(found.torsion_constant / fine.torsion_constant - 1.0)
    assert error < min(found.error, tolerance)
    assert found.error < 300.0 * tolerance


@pytest.mark.parametrize("corners", [20, 40, 64, 100, 150, 256])
def test_nodes_stay_few(corners: int) -> None:
    for outline in (ring(1.0, even(corners)), ellipse(corners, 0.5), uneven(min(corners, 100)), bean(corners)):
        fine, coarse = rung_nodes(polygon_of_points(outline).outline())
        assert coarse.weight.size < fine.weight.size <= QUICK


def test_flat_corners_need_no_grading() -> None:
    """Panels on each side of a regular polygon: fewer as its corners flatten, and one from 100 sides on."""
    panels = []
    for sides in (8, 20, 40, 100):
        boundary = boundary_of(polygon_of_points(ring(1.0, even(sides))).outline())
        panels.append(place_nodes(boundary, order=6, tolerance=1e-6).weight.size / (6 * sides))
    assert panels == sorted(panels, reverse=True)
    assert panels[0] >= 9
    assert panels[-1] == 1


def test_difference_of_two_solutions_does_not_cancel() -> None:
    """The corners of a bean err in both senses: at this rung J itself differs by less than its error."""
    outline = polygon_of_points(bean(40)).outline()
    exact = solved(outline, 8, 1e-7).torsion_constant
    rung = ((4, 1e-5), (3, 1e-4))
    assert rung in [one[:2] for one in RUNGS]
    fine, coarse = (solved(outline, order, share) for order, share in rung)
    error = abs(fine.torsion_constant / exact - 1.0)
    assert abs(coarse.torsion_constant / fine.torsion_constant - 1.0) < error < difference(fine, coarse)
