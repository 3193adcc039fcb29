"""Loops of a cross-section: what is taken, and one line for each thing that is not."""

from __future__ import annotations

import math
import subprocess
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from varistiff.core.errors import InputError
from varistiff.sections.bezier import Bezier
from varistiff.sections.loops import check_loops, loop_area
from varistiff.sections.outline import Arc, Line, Loop
from varistiff.sections.polygon import Polygon
from varistiff.sections.polygon_loops import loop_of_points

Corners = list[tuple[float, float]]

SQUARE: Corners = [(0.0, 0.0), (0.04, 0.0), (0.04, 0.04), (0.0, 0.04)]
L_SHAPE: Corners = [(0.0, 0.0), (0.02, 0.0), (0.02, 0.01), (0.01, 0.01), (0.01, 0.02), (0.0, 0.02)]


def box(x: float, y: float, width: float, height: float | None = None) -> Corners:
    top = y + (width if height is None else height)
    return [(x, y), (x + width, y), (x + width, top), (x, top)]


def circle(x: float, y: float, radius: float) -> Loop:
    return (Arc((x, y), radius, 0.0, math.pi), Arc((x, y), radius, math.pi, math.pi))


def shoelace(corners: Corners) -> float:
    following = corners[1:] + corners[:1]
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, following, strict=True))


def refused(*loops: Corners | Loop) -> InputError:
    made = [loop if isinstance(loop, tuple) else loop_of_points(loop) for loop in loops]
    with pytest.raises(InputError) as caught:
        check_loops(made)
    assert "\n" not in str(caught.value)
    assert "allowed" in caught.value.problem
    assert len(str(caught.value)) < 300
    return caught.value


@st.composite
def stars(draw: st.DrawFn) -> Corners:
    count = draw(st.integers(4, 14))
    radii = draw(st.lists(st.floats(0.6, 1.4), min_size=count, max_size=count))
    shift, first = draw(st.floats(-50.0, 50.0)), draw(st.floats(0.0, 6.0))
    angles = [first + 2.0 * math.pi * k / count for k in range(count)]
    return [(0.01 * (r * math.cos(a) + shift), 0.01 * r * math.sin(a)) for r, a in zip(radii, angles, strict=True)]


@given(stars(), st.booleans(), st.booleans())
@settings(max_examples=60)
def test_a_star_is_taken_in_either_sense(corners: Corners, reverse: bool, close: bool) -> None:
    given_corners = corners[::-1] if reverse else corners
    (loop,) = check_loops([loop_of_points(given_corners + given_corners[:1] * close)])
    assert loop_area(loop) == pytest.approx(shoelace(corners), rel=1e-9)
    assert len(loop) <= len(corners)
    for one, two in zip(loop, loop[1:] + loop[:1], strict=True):
        assert isinstance(one, Line)
        assert isinstance(two, Line)
        assert one.end == two.start


def test_either_sense_gives_the_same_torsion_constant() -> None:
    forth, back = (Polygon(check_loops([loop_of_points(corners)])) for corners in (L_SHAPE, L_SHAPE[::-1]))
    assert forth.torsion_constant == pytest.approx(back.torsion_constant, rel=1e-10)


def test_holes_run_clockwise() -> None:
    for hole in (box(0.01, 0.01, 0.01), box(0.01, 0.01, 0.01)[::-1]):
        outer, inner = check_loops([loop_of_points(SQUARE[::-1]), loop_of_points(hole)])
        assert loop_area(outer) == pytest.approx(16e-4)
        assert loop_area(inner) == pytest.approx(-1e-4)


def test_curves_are_turned_exactly() -> None:
    bore: Loop = (
        Arc((0.02, 0.02), 0.01, 0.0, math.pi),
        Bezier((0.01, 0.02), (0.01, 0.01), (0.03, 0.01), (0.03, 0.02)),
    )
    _, inner = check_loops([loop_of_points(SQUARE), bore])
    assert loop_area(inner) == pytest.approx(-loop_area(bore), rel=1e-6)
    bezier, arc = inner
    assert isinstance(bezier, Bezier)
    assert bezier.end == (0.01, 0.02)
    assert isinstance(arc, Arc)
    assert arc.sweep == -math.pi


def test_lines_in_one_line_are_one() -> None:
    corners = [(0.02, 0.0), (0.03, 0.0), (0.04, 0.0), (0.04, 0.04), (0.0, 0.04), (0.0, 0.01), (0.0, 0.0), (0.01, 0.0)]
    (loop,) = check_loops([loop_of_points(corners)])
    assert len(loop) == 4
    assert loop_area(loop) == pytest.approx(16e-4)


def test_a_facet_is_no_line_in_one_line() -> None:
    angles = [2.0 * math.pi * k / 1000 for k in range(1000)]
    (loop,) = check_loops([loop_of_points([(0.01 * math.cos(a), 0.01 * math.sin(a)) for a in angles])])
    assert len(loop) == 1000


@pytest.mark.parametrize(
    "corners, said",
    [
        ([], "has fewer than 3 corners"),
        ([(0.0, 0.0)], "has fewer than 3 corners"),
        ([(0.0, 0.0), (0.01, 0.0)], "has fewer than 3 corners"),
        ([(0.0, 0.0), (0.01, 0.0), (0.0, 0.0)], "has fewer than 3 corners"),
        ([(0.0, 0.0), (0.01, 0.0), (0.02, 0.0)], "encloses no area"),
        ([(0.0, 0.0), (0.01, 0.005), (0.02, 0.01), (0.006, 0.003)], "encloses no area"),
        ([*SQUARE[:2], SQUARE[1], *SQUARE[2:]], "repeats the point (40, 0) mm"),
        ([*SQUARE, SQUARE[0], SQUARE[0]], "repeats the point (0, 0) mm"),
        ([*SQUARE[:2], (0.06, 0.0), *SQUARE[1:]], "spike or slit of no thickness at (60, 0) mm"),
        ([*SQUARE[:2], (0.02, 0.0), *SQUARE[2:]], "spike or slit of no thickness at (40, 0) mm"),
        ([*SQUARE[:2], (0.04, 0.02), (0.02, 0.02), (0.04, 0.02), *SQUARE[2:]], "at (20, 20) mm"),
        ([(0.0, 0.0), (0.04, 0.0), (0.0, 0.001)], "corners with 5 deg or more"),
        ([(0.0, 0.0), (0.02, 0.02), (0.02, 0.0), (0.0, 0.02)], "crosses or touches itself at (10, 10) mm"),
        ([(0.0, 0.0), (0.02, 0.0), (0.01, 0.01), (0.02, 0.02), (0.0, 0.02), (0.01, 0.01)], "at (10, 10) mm"),
        ([(0.0, 0.0), (0.02, 0.0), (0.02, 0.02), (0.01, 0.0), (0.0, 0.02)], "at (10, 0) mm"),
        ([(0.0, 0.0), (math.nan, 0.0), (0.01, 0.01)], "not finite"),
        ([(0.0, 0.0), (math.inf, 0.0), (0.01, 0.01)], "not finite"),
        ([(0.0, 0.0), (1e308, -1e308), (-1e308, 1e308)], "not finite"),
        ([(1e-12 * x, 1e-12 * y) for x, y in SQUARE], "mm across"),
        ([(1e5 * x, 1e5 * y) for x, y in SQUARE], "mm across"),
        ([(0.01 * math.cos(k), 0.01 * math.sin(k)) for k in range(1001)], "has 1001 segments"),
    ],
)
def test_a_wrong_loop_is_one_line(corners: Corners, said: str) -> None:
    error = refused(corners)
    assert said in error.problem
    assert error.field == "points"


@pytest.mark.parametrize(
    "holes, field, said",
    [
        ([box(0.01, 0.01, 0.01), box(0.05, 0.0, 0.01)], "holes[1]", "lies outside points at (50, 0) mm"),
        ([box(-0.01, -0.01, 0.06)], "holes[0]", "lies outside points at (-10, -10) mm"),
        ([box(0.03, 0.01, 0.02)], "holes[0]", "crosses or touches points at (40,"),
        ([SQUARE], "holes[0]", "crosses or touches points"),
        ([[(0.0, 0.02), (0.02, 0.01), (0.02, 0.03)]], "holes[0]", "crosses or touches points at (0, 20) mm"),
        ([box(0.01, 0.01, 0.01), box(0.015, 0.015, 0.01)], "holes[1]", "crosses or touches holes[0]"),
        ([box(0.01, 0.01, 0.01), box(0.02, 0.02, 0.01)], "holes[1]", "crosses or touches holes[0] at (20, 20) mm"),
        ([box(0.01, 0.01, 0.02), box(0.015, 0.015, 0.01)], "holes[1]", "lies inside the hole holes[0] at (15, 15) mm"),
        ([box(0.00005, 0.01, 0.01)], "holes[0]", "comes closer to points than 0.08 mm at (0, "),
        ([box(0.01, 0.01, 0.01), box(0.02005, 0.01, 0.01)], "holes[1]", "comes closer to holes[0] than 0.08 mm"),
        ([circle(0.02, 0.02, 0.02)], "holes[0]", "points"),
        ([box(0.01, 0.01, 0.01)[:2]], "holes[0]", "has fewer than 3 corners"),
    ],
)
def test_a_wrong_hole_is_one_line(holes: list[Corners | Loop], field: str, said: str) -> None:
    error = refused(SQUARE, *holes)
    assert said in error.problem
    assert error.field == field


def test_thin_walls_and_slits_are_named() -> None:
    slit = [
        (0.0, 0.0),
        (0.04, 0.0),
        (0.04, 0.02),
        (0.02, 0.02),
        (0.02, 0.02005),
        (0.04, 0.02005),
        (0.04, 0.04),
        (0.0, 0.04),
    ]
    assert "comes closer to itself than 0.08 mm" in refused(slit).problem
    fin = [*SQUARE[:2], (0.04, 0.02), (0.08, 0.02), (0.08, 0.02005), (0.04, 0.02005), *SQUARE[2:]]
    assert "comes closer to itself than 0.16 mm" in refused(fin).problem
    assert "walls and gaps of 0.2 %" in refused(circle(0.0, 0.0, 0.01), circle(0.0, 0.0, 0.00998)).problem


def test_corners_and_small_details_are_not_thin() -> None:
    needle = [(0.0, 0.0), (0.04, 0.0), (0.04, 0.04 * math.tan(math.radians(5.5)))]
    fillet: Loop = (
        Line((0.0, 0.0), (0.04, 0.0)),
        Line((0.04, 0.0), (0.04, 0.03997)),
        Arc((0.03997, 0.03997), 0.00003, 0.0, 0.5 * math.pi),
        Line((0.03997, 0.04), (0.0, 0.04)),
        Line((0.0, 0.04), (0.0, 0.0)),
    )
    for loop in (loop_of_points(needle), fillet):
        assert check_loops([loop]) == (loop,)
    check_loops([loop_of_points(SQUARE), circle(0.02, 0.02, 0.00002)])


def test_an_open_outline_says_where() -> None:
    loop: Loop = (Line((0.0, 0.0), (0.04, 0.0)), Line((0.04, 0.0), (0.04, 0.04)), Line((0.04, 0.03), (0.0, 0.0)))
    assert "is open: there are 10 mm between an end at (40, 40) mm" in refused(loop).problem


def test_curves_that_cross_or_stand_still_are_refused() -> None:
    knot: Loop = (
        Bezier((0.0, 0.0), (0.04, 0.03), (-0.03, 0.03), (0.01, 0.0)),
        Line((0.01, 0.0), (0.0, 0.0)),
    )
    assert "crosses or touches itself" in refused(knot).problem
    still: Loop = (Bezier((0.0, 0.0), (0.0, 0.0), (0.01, 0.01), (0.01, 0.0)), Line((0.01, 0.0), (0.0, 0.0)))
    assert "has a curve without a direction at (0, 0) mm" in refused(still).problem


def test_one_curve_can_be_a_whole_loop() -> None:
    (loop,) = check_loops([(Arc((0.0, 0.0), 0.01, 0.0, -2.0 * math.pi),)])
    assert loop == (Arc((0.0, 0.0), 0.01, -2.0 * math.pi, 2.0 * math.pi),)


def test_a_comb_is_refused_in_seconds() -> None:
    teeth = [(x + 4e-5 * k, y) for k in range(249) for x, y in ((0.0, 0.0), (0.0, 0.01), (2e-5, 0.01), (2e-5, 0.0))]
    assert "comes closer to itself" in refused([*teeth, (0.01, -0.001), (0.0, -0.001)]).problem


def test_reading_outlines_needs_no_jax() -> None:
    heavy = "{'jax', 'equinox', 'shapely', 'scipy'}"
    code = f"import sys, varistiff.sections.loops; sys.exit(bool({heavy} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
