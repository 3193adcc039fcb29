"""Outlines with re-entrant corners: condensed corners and close panels against solutions that have neither."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from varistiff.core.errors import InputError
from varistiff.sections.boundary import boundary_of
from varistiff.sections.condensed import place_condensed
from varistiff.sections.outline import Arc, Line, Loop, Outline
from varistiff.sections.panels import place_nodes
from varistiff.sections.polygon import Polygon, polygon_of_points
from varistiff.sections.rungs import LOOSE, LOOSEST, QUICK, RUNGS, rung_nodes, settled, stated_error
from varistiff.sections.saint_venant import solve_torsion
from varistiff.sections.separation import SEPARATION
from varistiff.sections.solved import solved_properties

from .oracles import rational
from .shapes import L_CORNERS, Corners, channel, circle, comb, gear, jagged, star


def lines(corners: Corners) -> Loop:
    return polygon_of_points(corners).loops[0]


def whole(corners: Corners, *holes: Corners) -> Outline:
    return polygon_of_points(corners, holes).outline()


def frame(wall: float) -> Outline:
    low, right, high = wall, 3.0 - wall, 2.0 - wall
    return whole(
        [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)], [(low, low), (right, low), (right, high), (low, high)]
    )


def slotted(width: float, *inside: tuple[float, float]) -> Outline:
    """Shaft of radius 1 with a slot from above, from right to left through these corners."""
    x, edge = 0.5 * width, math.asin(0.5 * width)
    around = Arc((0.0, 0.0), 1.0, 0.5 * math.pi + edge, 2.0 * (math.pi - edge))
    corners = [(x, math.cos(edge)), *inside, (-x, math.cos(edge))]
    return Outline(((around, *(Line(one, two) for one, two in pairwise(corners))),))


def square_bore(half: float, x: float, y: float) -> Outline:
    corners = [(x - half, y - half), (x - half, y + half), (x + half, y + half), (x + half, y - half)]
    clockwise = tuple(Line(one, two) for one, two in zip(corners, corners[1:] + corners[:1], strict=True))
    return Outline((circle((0.0, 0.0), 1.0), clockwise))


BAR = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 1.0)]
OUTLINES = {
    "bar with a small hole beside one side": (
        whole(BAR, [(1.95, 0.05), (2.05, 0.05), (2.05, 0.15), (1.95, 0.15)]),
        1e-8,
    ),
    "L": (whole(L_CORNERS), 1e-9),
    "L with a bore": (Outline((lines(L_CORNERS), circle((0.5, 0.5), 0.45, hole=True))), 1e-8),
    "channel": (whole(channel(1.0, 2.0, 0.1)), 1e-7),
    "frame": (frame(0.3), 1e-7),
    "thin frame": (frame(0.06), 1e-7),
    "comb": (whole(comb(4)), 1e-7),
    "keyway": (slotted(0.5, (0.25, 0.6), (-0.25, 0.6)), 1e-8),
    "narrow keyway": (slotted(0.3, (0.15, 0.1), (-0.15, 0.1)), 1e-8),
    "notch of 34 degrees": (slotted(0.3, (0.0, 0.5)), 1e-6),
    "square bore": (square_bore(0.66, 0.0, 0.0), 1e-8),
    "square bore off the axis": (square_bore(0.3, 0.4, 0.1), 1e-8),
}


@pytest.mark.parametrize(("outline", "tolerance"), OUTLINES.values(), ids=OUTLINES.keys())
def test_condensed_meets_graded(outline: Outline, tolerance: float) -> None:
    """J, better than stated, and the shear centre; graded panels of order 10 are good to 1e-10 here."""
    graded = solve_torsion(outline, nodes=place_nodes(boundary_of(outline), order=10, tolerance=1e-10))
    fine, _ = rung_nodes(outline)
    assert fine.condensed is not None
    assert 2 * fine.weight.size < graded.nodes.weight.size
    found = solved_properties(outline)
    error = abs(found.torsion_constant / graded.torsion_constant - 1.0)
    assert error < min(found.error, tolerance)
    assert found.shear_centre == pytest.approx(graded.shear_centre, abs=10.0 * tolerance)
    assert found.second_moments == pytest.approx(graded.second_moments, rel=1e-12, abs=1e-14)


PARTS = {
    **{
        f"star of {n}, roots at {root}": (star(n, root), n, True)
        for n, root in [(12, 0.5), (15, 0.6), (20, 0.3), (20, 0.5), (20, 0.7), (20, 0.9), (40, 0.8), (50, 0.9)]
    },
    **{f"gear of {n} teeth": (gear(n), n, False) for n in (6, 12, 20, 25)},
    **{f"jagged, {n} corners": (jagged(n, n), 4, False) for n in (20, 40, 60, 100)},
}


@pytest.mark.parametrize(("corners", "rotations", "mirror"), PARTS.values(), ids=PARTS.keys())
def test_many_re_entrant_corners_against_one_part(corners: Corners, rotations: int, mirror: bool) -> None:
    """One part in all its symmetry, graded and far finer: J of the whole to 1e-4, as stated, and with few nodes."""
    share = 1 if mirror else len(corners) // rotations
    part = tuple(Line(one, two) for one, two in pairwise(corners[: share + 1]))
    exact = solve_torsion(Outline((part,), rotations, mirror), order=10, tolerance=1e-9).torsion_constant
    fine, coarse = rung_nodes(whole(corners))
    assert coarse.weight.size < fine.weight.size <= 1.25 * QUICK
    found = polygon_of_points(corners).properties()
    assert abs(found.torsion_constant / exact - 1.0) < min(found.error, 1e-4)
    assert found.torsion_modulus == 0.0
    assert len(found.stress_points) >= rotations


CONVEX = {
    "square": ([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], 0.140577014955),
    "equilateral triangle": ([(0.0, 0.0), (1.0, 0.0), (0.5, 0.75**0.5)], 3.0**0.5 / 80.0),
    "blunt quadrilateral": ([(0.0, 0.0), (3.0, 0.2), (2.5, 1.7), (0.4, 1.1)], None),
    "acute triangle": ([(0.0, 0.0), (1.0, -0.268), (1.0, 0.268)], None),
}


@pytest.mark.parametrize("order", [6, 8, 10])
@pytest.mark.parametrize(("corners", "exact"), CONVEX.values(), ids=CONVEX.keys())
def test_convex_corners(corners: Corners, exact: float | None, order: int) -> None:
    """Closed forms, or rational fits good to 1e-10: a few nodes a corner, and an error that falls with their number."""
    if exact is None:
        exact = rational.polygon([complex(*corner) for corner in corners], poles=40).torsion_constant
    outline = whole(corners)
    nodes = place_condensed(boundary_of(outline), order=order, tolerance=1e-10)
    assert nodes.weight.size <= 4 * order * len(corners)
    found = solve_torsion(outline, nodes=nodes).torsion_constant
    assert found == pytest.approx(exact, rel={6: 2e-5, 8: 1e-6, 10: 2e-8}[order])


@settings(max_examples=8)
@given(scale=st.floats(1e-5, 10.0), angle=st.floats(-3.0, 3.0), x=st.floats(-50.0, 50.0), y=st.floats(-50.0, 50.0))
def test_moved_and_scaled(scale: float, angle: float, x: float, y: float) -> None:
    """J goes with the fourth power of the size and with nothing else; the shear centre moves along. Rounding only."""
    corners = channel(1.0, 2.0, 0.3)
    motion = scale * complex(math.cos(angle), math.sin(angle))
    moved = [complex(*corner) * motion + scale * complex(x, y) for corner in corners]
    one, other = (polygon_of_points(loop).properties() for loop in (corners, [(z.real, z.imag) for z in moved]))
    assert other.torsion_constant == pytest.approx(one.torsion_constant * scale**4, rel=1e-10)
    centre = complex(*one.shear_centre) * motion + scale * complex(x, y)
    assert other.shear_centre == pytest.approx((centre.real, centre.imag), abs=1e-8 * scale)


def test_sense_and_first_corner_do_not_count() -> None:
    corners = star(5, 0.38)
    found = [polygon_of_points(c).torsion_constant for c in (corners, corners[::-1], corners[3:] + corners[:3])]
    assert found == pytest.approx([found[0]] * 3, rel=1e-12)


def excess(length: float, wall: float, solution: float) -> float:
    """What corners add to J of thin walls, over wall^4: less t^3/3 (length of the middle lines) and two free ends.

    A free end takes half of what it takes of a long rectangle, J = b t^3/3 (1 - 192/pi^5 (31/32) zeta(5) t/b).
    """
    end = 0.5 * 192.0 / math.pi**5 * 31.0 / 32.0 * 1.0369277551433699
    return (solution - wall**3 / 3.0 * (length - 2.0 * end * wall)) / wall**4


@pytest.mark.parametrize("wall", [0.1, 0.03, 0.01])
def test_corners_of_a_thin_channel_meet_those_of_an_angle(wall: float) -> None:
    """Two corners add twice what the one of a short angle, graded, adds; J to 1e-6, over t/12."""
    angle = whole([(0.0, 0.0), (8.0, 0.0), (8.0, 1.0), (1.0, 1.0), (1.0, 8.0), (0.0, 8.0)])
    one = excess(15.0, 1.0, solve_torsion(angle, order=10, tolerance=1e-10).torsion_constant)
    thin = whole(channel(1.0, 2.0, wall))
    two = excess(4.0, wall, solved_properties(thin).torsion_constant)
    assert two == pytest.approx(2.0 * one, abs=1e-6 * 4.0 / 3.0 / wall)


def test_thin_walls_cost_few_nodes() -> None:
    """A frame's nodes go with the logarithm of its wall."""
    counts = [rung_nodes(frame(wall))[0].weight.size for wall in (0.3, 0.06, 0.012)]
    assert counts[1] - counts[0] < 300
    assert counts[2] - counts[1] < 300


def test_no_stress_beside_condensed_corners() -> None:
    outline = whole(L_CORNERS)
    solution = solve_torsion(outline, nodes=rung_nodes(outline)[0])
    with pytest.raises(ValueError, match="condensed"):
        _ = solution.edge_stress


def test_symmetric_and_convex_outlines_are_graded() -> None:
    """Where the stress is bounded it is wanted, point by point."""
    square = Polygon((lines([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]),))
    assert rung_nodes(square.outline())[0].condensed is None
    corners = star(5, 0.38)
    part = Outline((tuple(Line(one, two) for one, two in pairwise(corners[:2])),), rotations=5, mirror=True)
    assert rung_nodes(part)[0].condensed is None


def test_too_many_corners_are_refused() -> None:
    with pytest.raises(InputError, match="too many corners"):
        polygon_of_points(star(490, 0.97)).properties()


def slit_tube(wall: float, slit: float) -> Corners:
    """Square tube of width 1, open in the middle of its top."""
    left, right = 0.5 - 0.5 * slit, 0.5 + 0.5 * slit
    outer = [(right, 1.0), (right, 1.0 - wall), (1.0 - wall, 1.0 - wall), (1.0 - wall, wall), (wall, wall)]
    inner = [(wall, 1.0 - wall), (left, 1.0 - wall), (left, 1.0), (0.0, 1.0)]
    return [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), *outer, *inner]


@pytest.mark.parametrize(("wall", "slit"), [(0.1, 0.02), (0.1, 0.005), (0.03, 0.01)])
def test_slit_tubes(wall: float, slit: float) -> None:
    """J is a small remainder of the polar moment, which errors of close kernels would swamp."""
    outline = whole(slit_tube(wall, slit))
    exact = solve_torsion(outline, nodes=place_nodes(boundary_of(outline), order=12, tolerance=1e-10))
    found = solved_properties(outline)
    assert exact.torsion_constant < 0.02 * sum(exact.second_moments[:2])
    assert abs(found.torsion_constant / exact.torsion_constant - 1.0) < min(found.error, 1e-6)


def round_slit_tube(slit: float, bore: float) -> Outline:
    """Radius 1, open on +x; no re-entrant corner."""
    outer, inner = math.asin(0.5 * slit), math.asin(0.5 * slit / bore)
    around = Arc((0.0, 0.0), 1.0, outer, 2.0 * (math.pi - outer))
    back = Arc((0.0, 0.0), bore, 2.0 * math.pi - inner, -2.0 * (math.pi - inner))
    faces = [(math.cos(outer), 0.5 * slit), (bore * math.cos(inner), 0.5 * slit)]
    (a, b), (c, d) = faces
    return Outline(((around, Line((a, -b), (c, -d)), back, Line((c, d), (a, b))),))


def test_a_narrow_slit_is_settled_on_a_finer_rung() -> None:
    """The quick rung is far off and says so; both solutions of a rung must not miss the slit alike."""
    outline = round_slit_tube(0.005, 0.8)
    exact = solve_torsion(outline, order=14, tolerance=1e-10).torsion_constant
    fine, coarse = (solve_torsion(outline, nodes=nodes) for nodes in rung_nodes(outline))
    assert stated_error(fine, coarse) > LOOSE
    found, error = settled(outline)
    assert found.nodes.weight.size > fine.nodes.weight.size
    assert abs(found.torsion_constant / exact - 1.0) < error < LOOSE
    for rung in RUNGS:
        fine, coarse = (
            solve_torsion(outline, order=order, tolerance=share) for order, share in (rung.fine, rung.coarse)
        )
        assert abs(fine.torsion_constant / exact - 1.0) < max(stated_error(fine, coarse), LOOSE) or (
            stated_error(fine, coarse) > LOOSEST
        )


def test_sides_of_a_slit_are_told_from_each_other() -> None:
    """At every rung: near the corners of other sides, where little energy is, panels are short beside the slit too."""
    slit = 0.005
    boundary = boundary_of(round_slit_tube(slit, 0.8))
    for rung in RUNGS:
        order, share = rung.coarse
        faces = place_nodes(boundary, order=order, tolerance=share).parameters[1::2]
        assert min(face.size for face in faces) > order * 0.2 / (SEPARATION * slit)


def test_a_hole_beside_a_tip() -> None:
    """A tip of 14 degrees spares its own two sides from being split, and not the hole between them."""
    side, radius = math.radians(7.0), 0.12
    corners = [(0.0, 0.0), (1.9, -1.9 * math.tan(side)), (1.6, 0.0), (1.9, 1.9 * math.tan(side))]
    x = (radius + 0.005) / math.sin(side)
    outline = Outline((lines(corners), circle((x, 0.0), radius, hole=True)))
    exact = solve_torsion(outline, nodes=place_nodes(boundary_of(outline), order=12, tolerance=1e-10))
    found = solved_properties(outline)
    assert abs(found.torsion_constant / exact.torsion_constant - 1.0) < min(found.error, 1e-5)


@pytest.mark.parametrize(("size", "offset"), [(1e-3, 9e3), (1e-4, 1e3), (1.0, 9e3)])
def test_far_from_the_origin(size: float, offset: float) -> None:
    """Coordinates are rounded to 1e-16 of the offset: to 1e-9 of the size, and J to four times that and a table's."""
    turn = complex(math.cos(0.3), math.sin(0.3))
    far = [complex(x, y) * size * turn + complex(offset, -0.7 * offset) for x, y in L_CORNERS]
    found = polygon_of_points([(z.real, z.imag) for z in far]).torsion_constant
    assert found == pytest.approx(polygon_of_points(L_CORNERS).torsion_constant * size**4, rel=2e-8)
