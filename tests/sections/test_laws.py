"""Laws that hold for every cross-section, on polygons and tubes drawn at random."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from varistiff.sections import P3G, P4C, Hexagon, HollowCircle, Octagon, Rectangle, SplinedTube, Square
from varistiff.sections.boundary import boundary_of
from varistiff.sections.condensed import place_condensed
from varistiff.sections.outline import Image, Line, Outline
from varistiff.sections.panels import place_nodes
from varistiff.sections.polygon import polygon_of_points
from varistiff.sections.rungs import CONDENSED_RUNGS, RUNGS, stated_error
from varistiff.sections.saint_venant import SaintVenant, solve_torsion
from varistiff.sections.section import Section
from varistiff.sections.solved import largest_stress, solved_properties

from .shapes import L_CORNERS, SPLINED, circle

Corners = list[tuple[float, float]]
QUICK = {"order": 6, "tolerance": 1e-5}
NEAR = 1e-4  # ten times what that tolerance costs


@st.composite
def polygons(draw: st.DrawFn) -> Corners:
    """Star-shaped ones about the origin, convex or not, without needles."""
    count = draw(st.integers(3, 7))
    radii = draw(st.lists(st.floats(0.7, 1.2), min_size=count, max_size=count))
    shift = draw(st.floats(0.0, 6.0))
    angles = shift + 2.0 * math.pi * np.arange(count) / count
    return [(float(r * math.cos(a)), float(r * math.sin(a))) for r, a in zip(radii, angles, strict=True)]


def solved(corners: Corners, holes: tuple[Corners, ...] = ()) -> SaintVenant:
    return solve_torsion(polygon_of_points(corners, holes).outline(), **QUICK)


@settings(max_examples=6)
@given(corners=polygons(), scale=st.floats(1e-3, 10.0))
def test_scale(corners: Corners, scale: float) -> None:
    """J goes with the fourth power of the size, the stress with the first; rounding only."""
    one, other = solved(corners), solved([(scale * x, scale * y) for x, y in corners])
    assert other.torsion_constant == pytest.approx(one.torsion_constant * scale**4, rel=1e-10)
    assert other.edge_stress == pytest.approx(one.edge_stress * scale, rel=1e-6, abs=1e-6 * scale)


@settings(max_examples=6)
@given(corners=polygons(), angle=st.floats(-3.0, 3.0), x=st.floats(-5.0, 5.0), y=st.floats(-5.0, 5.0))
def test_motion(corners: Corners, angle: float, x: float, y: float) -> None:
    """Moving and turning a section moves and turns its points and leaves J; panels may split otherwise: 1e-6."""
    motion = np.exp(1j * angle)
    moved = [complex(*corner) * motion + complex(x, y) for corner in corners]
    one, other = solved(corners), solved([(z.real, z.imag) for z in moved])
    assert other.torsion_constant == pytest.approx(one.torsion_constant, rel=1e-6)
    for point, image in ((one.centroid, other.centroid), (one.shear_centre, other.shear_centre)):
        expected = complex(*point) * motion + complex(x, y)
        assert image == pytest.approx((expected.real, expected.imag), abs=1e-5)
    assert sum(other.second_moments[:2]) == pytest.approx(sum(one.second_moments[:2]), rel=1e-10)


@settings(max_examples=6)
@given(corners=polygons(), first=st.integers(0, 6))
def test_order_of_the_points(corners: Corners, first: int) -> None:
    """Neither the sense of rotation nor the first point matters."""
    one = solved(corners)
    turned = corners[first:] + corners[:first]
    assert solved(corners[::-1]).torsion_constant == pytest.approx(one.torsion_constant, rel=1e-11)
    assert solved(turned).torsion_constant == pytest.approx(one.torsion_constant, rel=1e-11)


@settings(max_examples=6)
@given(corners=polygons())
def test_bounds_of_saint_venant(corners: Corners) -> None:
    """J <= A^2/(2 pi), the circle's (Saint-Venant; Polya 1948); J <= the polar moment."""
    one = solved(corners)
    assert 0.0 < one.torsion_constant < one.area**2 / (2.0 * math.pi)
    assert one.torsion_constant < sum(one.second_moments[:2])


@settings(max_examples=5)
@given(corners=polygons(), number=st.integers(0, 6), share=st.floats(0.01, 0.3))
def test_material_added_never_lowers_the_constant(corners: Corners, number: int, share: float) -> None:
    """Of two sections, one inside the other, the outer is stiffer."""
    number %= len(corners)
    grown = list(corners)
    grown[number] = ((1.0 + share) * corners[number][0], (1.0 + share) * corners[number][1])
    one = solved(corners).torsion_constant
    assert solved(grown).torsion_constant >= one * (1.0 - NEAR)
    hole = [(0.2 * x, 0.2 * y) for x, y in corners]
    assert solved(corners, (hole,)).torsion_constant <= one * (1.0 + NEAR)


@settings(max_examples=5)
@given(corners=polygons())
def test_stated_error_bounds_the_true_one(corners: Corners) -> None:
    """Of every rung the stated error is above the true one: against the finest graded rung, good to 1e-9."""
    outline = polygon_of_points(corners).outline()
    boundary = boundary_of(outline)
    (order, share), *_ = RUNGS[0]
    best = solve_torsion(outline, order=order, tolerance=share).torsion_constant
    for place, rungs in (place_nodes, RUNGS[1:]), (place_condensed, CONDENSED_RUNGS):
        for rung in rungs:
            fine, coarse = (
                solve_torsion(outline, nodes=place(boundary, order=order, tolerance=share))
                for order, share in (rung.fine, rung.coarse)
            )
            assert abs(fine.torsion_constant / best - 1.0) <= stated_error(fine, coarse) + 1e-9


SYMMETRIC: list[Section] = [
    Hexagon(across_flats=1.0),
    Octagon(across_flats=1.0),
    Square(across_flats=0.8),
    Rectangle(width=2.0, height=0.7),
    HollowCircle(outer_radius=1.0, inner_radius=0.4),
    P3G(mean_diameter=2.0, eccentricity=0.09),
    P4C(inner_diameter=0.021, outer_diameter=0.025, eccentricity=0.0035),
    SplinedTube(**SPLINED, root_fillet=0.001),
]


@pytest.mark.parametrize("section", SYMMETRIC, ids=lambda section: section.shape)
def test_whole_boundary_gives_what_its_part_gives(section: Section) -> None:
    """Symmetry only saves work: J to 1e-7, as the grading of the whole differs; nothing shifts off the axis."""
    part = section.outline()
    one, whole = (
        solve_torsion(part, order=8, tolerance=1e-6),
        solve_torsion(Outline(part.loops), order=8, tolerance=1e-6),
    )
    assert whole.torsion_constant == pytest.approx(one.torsion_constant, rel=1e-7)
    assert whole.area == pytest.approx(one.area, rel=1e-12)
    size = math.sqrt(one.area)
    assert whole.centroid == pytest.approx((0.0, 0.0), abs=1e-12 * size)
    assert whole.shear_centre == pytest.approx((0.0, 0.0), abs=1e-7 * size)
    assert whole.second_moments == pytest.approx(one.second_moments, abs=1e-10 * size**4)
    assert largest_stress(whole)[0] == pytest.approx(largest_stress(one)[0], rel=1e-5)


@pytest.mark.parametrize("section", SYMMETRIC, ids=lambda section: section.shape)
def test_loops_close_and_keep_the_material_on_their_left(section: Section) -> None:
    outline = section.outline()
    ends = np.array([0.0, 1.0])
    for number, loop in enumerate(outline.loops):
        points = np.array([segment.point(ends) for segment in loop])
        assert points[:, 1] == pytest.approx(np.roll(points[:, 0], -1, axis=0), abs=1e-14 * outline.radius)
        line = np.concatenate([segment.point(np.linspace(0.0, 1.0, 50)[:-1]) for segment in loop]) @ [1.0, 1.0j]
        turned = float((line.conj() * np.roll(line, -1)).imag.sum())
        assert turned > 0.0 if number == 0 else turned < 0.0


def test_rotations_without_a_mirror() -> None:
    """A pinwheel of three blades has no mirror line: its third gives what the whole gives."""
    turn = np.exp(2j * math.pi / 3.0)
    corners = [(1.0, 0.0), (0.9, 0.5), (0.1, 0.6), (float(turn.real), float(turn.imag))]
    part = Outline((tuple(Line(one, two) for one, two in pairwise(corners)),), rotations=3)
    one, whole = solve_torsion(part), solve_torsion(Outline(part.loops))
    assert whole.torsion_constant == pytest.approx(one.torsion_constant, rel=1e-8)
    assert one.shear_centre == (0.0, 0.0)


def test_every_place_of_the_largest_stress_is_given() -> None:
    """One for each copy of the fundamental part: six sides, three flats of a P3G, two root fillets a rail."""
    assert len(Hexagon(across_flats=1.0).properties().stress_points) == 6
    assert len(P3G(mean_diameter=2.0, eccentricity=0.09).properties().stress_points) == 3
    assert len(SplinedTube(**SPLINED, root_fillet=0.001).properties().stress_points) == 12
    assert len(SplinedTube(**SPLINED).properties().stress_points) == 12
    points = Octagon(across_flats=2.0).properties().stress_points
    assert [math.hypot(*point) for point in points] == pytest.approx([1.0] * 8, rel=1e-3)


def test_origin_far_away() -> None:
    """A kilometre off, J and its stated error are as at home."""
    near, far = (polygon_of_points([(x + shift, y) for x, y in L_CORNERS]).properties() for shift in (0.0, 1e3))
    assert far.torsion_constant == pytest.approx(near.torsion_constant, rel=1e-11)
    assert far.error == pytest.approx(near.error, rel=1e-2)


def test_images_of_images() -> None:
    """A segment mirrored twice and turned back is itself."""
    segment = circle((0.3, 0.1), 0.5)[0]
    t = np.linspace(0.0, 1.0, 7)
    twice = Image(Image(segment, 0.7, mirrored=True), 0.7, mirrored=True)
    assert twice.point(t) == pytest.approx(segment.point(t), abs=1e-15)
    assert twice.velocity(t) == pytest.approx(segment.velocity(t), abs=1e-15)


def test_small_hole_costs_little() -> None:
    """A hole in the L that shrinks costs less and less."""
    whole = solve_torsion(polygon_of_points(L_CORNERS).outline(), **QUICK).torsion_constant
    loss = []
    for radius in (0.05, 0.1):
        outline = Outline((polygon_of_points(L_CORNERS).loops[0], circle((0.5, 0.5), radius, hole=True)))
        loss.append(whole - solve_torsion(outline, **QUICK).torsion_constant)
    assert 0.0 < loss[0] < loss[1] < 0.01 * whole
    assert solved_properties(Outline(polygon_of_points(L_CORNERS).loops)).error < 1e-7
