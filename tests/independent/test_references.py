"""The reference solvers are themselves held against published numbers and against each other."""

from __future__ import annotations

import math

import pytest

from .references.discrete_rod import NoMinimumError, extrapolated, obstacle, sleeve
from .references.published import (
    MATTIASSON_1981_TABLE_1,
    RECTANGULAR_ELASTICA_DISTANCE,
    RECTANGULAR_ELASTICA_LENGTH,
    EndOfCantilever,
)
from .references.rod_bvp import NoShapeError, dead_load, follower_load, roller_contact


@pytest.mark.parametrize("row", MATTIASSON_1981_TABLE_1, ids=lambda row: f"load{row.load:g}")
def test_rod_meets_published_cantilever(row: EndOfCantilever) -> None:
    """Mattiasson 1981, Table I: all printed digits (half a unit of the fifth, and rounding)."""
    length, rigidity = 3.0, 2.0
    shape = dead_load(row.load * rigidity / length**2, length=length, flexural_rigidity=rigidity)
    assert shape.y[-1] / length == pytest.approx(float(row.vertical), abs=0.6e-5)
    assert 1 - shape.x[-1] / length == pytest.approx(float(row.horizontal), abs=0.6e-5)
    assert shape.end_slope == pytest.approx(float(row.slope), abs=0.6e-5)


def test_rod_meets_the_rectangular_elastica() -> None:
    """Where the follower force has turned the end by 90 degrees, lengths are the lemniscate's constants."""
    length = float(RECTANGULAR_ELASTICA_LENGTH)
    distance = float(RECTANGULAR_ELASTICA_DISTANCE)
    shape = follower_load(2 * length**2, length=1.0, flexural_rigidity=1.0)
    assert shape.end_slope == pytest.approx(math.pi / 2, abs=1e-9)
    assert 1.0 / shape.y[-1] == pytest.approx(length, rel=1e-9)
    assert shape.x[-1] / shape.y[-1] == pytest.approx(distance, rel=1e-9)
    assert shape.x[-1] * 1.0 / shape.y[-1] ** 2 == pytest.approx(math.pi / 4, rel=1e-9)  # Euler's product


def test_follower_force_bends_the_end_by_a_half_turn() -> None:
    """F L^2/EI = 2 (2 x 1.3110)^2 = 13.75 turns the end by 180 degrees (two rectangular halves)."""
    load = 2 * (2 * float(RECTANGULAR_ELASTICA_LENGTH)) ** 2
    shape = follower_load(load, length=1.0, flexural_rigidity=1.0)
    assert shape.end_slope == pytest.approx(math.pi, abs=1e-8)
    # symmetric about its middle: the end stands right above the clamp
    assert shape.x[-1] == pytest.approx(0.0, abs=1e-8)


def test_roller_and_follower_force_are_one_problem() -> None:
    """A roller put where a follower force has brought the end gives that force and that length back."""
    free = follower_load(7.0, length=1.3, flexural_rigidity=2.5)
    held = roller_contact((float(free.x[-1]), float(free.y[-1])), radius=0.0, flexural_rigidity=2.5)
    assert held.force == pytest.approx(7.0, rel=1e-9)
    assert held.length == pytest.approx(1.3, rel=1e-9)
    assert held.energy == pytest.approx(free.energy, rel=1e-9)


@pytest.mark.parametrize(("degrees", "radius"), [(18.0, 0.01), (34.0, -0.02), (57.0, 0.0), (75.0, 0.05), (92.0, 0.0)])
def test_minimum_of_energy_is_the_rod_in_equilibrium(degrees: float, radius: float) -> None:
    """Two methods with nothing in common; tolerances are ten times the differences seen."""
    centre = (0.4 * math.cos(math.radians(degrees)), 0.4 * math.sin(math.radians(degrees)))
    shape = roller_contact(centre, radius=radius, flexural_rigidity=13.0)
    found = [obstacle(centre, radius=radius, flexural_rigidity=13.0, length=0.9, elements=n) for n in (30, 60)]
    assert extrapolated(found[0].energy, found[1].energy) == pytest.approx(shape.energy, rel=1e-4)
    assert extrapolated(found[0].force, found[1].force) == pytest.approx(shape.force, rel=1e-3)
    assert extrapolated(found[0].slope, found[1].slope) == pytest.approx(shape.end_slope, rel=1e-3)
    assert found[1].active_length == pytest.approx(shape.length, rel=1e-3)
    # second order: halving the element leaves a quarter of the error in energy
    ratio = (found[0].energy - shape.energy) / (found[1].energy - shape.energy)
    assert 3.5 < ratio < 4.5
    # nobody told the minimiser that the force is normal to the rod
    along = found[1].force_x * math.cos(found[1].slope) + found[1].force_y * math.sin(found[1].slope)
    assert abs(along) < 1e-6 * found[1].force


def test_free_tail_is_straight() -> None:
    """Beyond the contact the minimiser leaves the rod unbent."""
    found = obstacle((0.3, 0.2), radius=0.01, flexural_rigidity=2.0, length=0.8, elements=64)
    directions = [math.atan2(y, x) for x, y in zip(found.x[-20:], found.y[-20:], strict=True)]
    chord = math.atan2(found.y[-1] - found.y[-12], found.x[-1] - found.x[-12])
    assert chord == pytest.approx(found.slope, abs=2e-3)
    assert directions == sorted(directions) or directions == sorted(directions, reverse=True)


def test_no_shape_beyond_the_fold() -> None:
    """Beyond about 99.6 degrees of polar angle a point contact slips off: both methods say so."""
    beta = math.radians(101.0)
    centre = (0.4 * math.cos(beta), 0.4 * math.sin(beta))
    with pytest.raises(NoShapeError):
        roller_contact(centre, radius=0.0, flexural_rigidity=1.0)
    with pytest.raises(NoMinimumError):
        obstacle(centre, radius=0.0, flexural_rigidity=1.0, length=3.0, elements=40)


def test_sleeve_of_two_halves() -> None:
    """A leaf in a sleeve is two rods with a point contact: half the span and height, twice the energy."""
    span, height = 0.081, 0.0405
    half = roller_contact((span / 2, height / 2), radius=0.0, flexural_rigidity=1.7)
    found = [sleeve(span, height, flexural_rigidity=1.7, elements=n) for n in (32, 64)]
    assert extrapolated(found[0].energy, found[1].energy) == pytest.approx(2 * half.energy, rel=1e-5)
    assert found[1].active_length == pytest.approx(2 * half.length, rel=1e-5)
    assert found[1].slope == pytest.approx(half.end_slope, rel=1e-3)
