"""J lies between the bounds of two energy principles, from finite elements of order 4.

Relative widths: L 5e-6, rectangle with an off-centre hole 7e-6, splined tube 1.4e-4 sharp and 5e-7 filleted.
"""

from __future__ import annotations

import pytest

from varistiff.sections import HollowCircle, SplinedTube
from varistiff.sections.polygon import polygon_of_points
from varistiff.sections.solved import solved_properties

from .oracles.brackets import rectangles_bracket, ring_bracket
from .shapes import L_CORNERS, SPLINED


def test_l_shape() -> None:
    bounds = rectangles_bracket([0.0, 1.0, 2.0], [0.0, 1.0, 2.0], [(1.0, 2.0, 1.0, 2.0)], hole=False, levels=3)
    assert bounds.width < 1e-5
    assert polygon_of_points(L_CORNERS).torsion_constant in bounds


def test_rectangle_with_an_off_centre_hole() -> None:
    x0, x1, y0, y1 = hole = (0.5, 2.0, 0.5, 1.2)
    bounds = rectangles_bracket([0.0, x0, x1, 3.0], [0.0, y0, y1, 2.0], [hole], hole=True, levels=2)
    section = polygon_of_points(
        [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)], [[(x0, y0), (x1, y0), (x1, y1), (x0, y1)]]
    )
    assert bounds.width < 1e-5
    assert section.torsion_constant in bounds


@pytest.mark.parametrize(
    ("fillet", "levels", "layers", "splits", "width"), [(0.0, 3, 2, 1, 2e-4), (5e-4, 0, 1, 2, 1e-6)]
)
def test_splined_tube(fillet: float, levels: int, layers: int, splits: int, width: float) -> None:
    tube = SplinedTube(**SPLINED, root_fillet=fillet)
    bounds = ring_bracket(tube.outline(), levels=levels, layers=layers, splits=splits)
    assert bounds.width < width
    assert tube.torsion_constant in bounds


def test_bounds_hold_for_a_known_tube() -> None:
    """The bracket itself: a circular tube, whose quadratic edges cost 3e-9."""
    tube = HollowCircle(outer_radius=1.0, inner_radius=0.5)
    bounds = ring_bracket(tube.outline(), levels=1, layers=0, splits=2)
    assert bounds.lower == pytest.approx(tube.torsion_constant, rel=1e-7)
    assert bounds.upper == pytest.approx(tube.torsion_constant, rel=1e-7)
    assert solved_properties(tube.outline()).torsion_constant == pytest.approx(tube.torsion_constant, rel=1e-12)
