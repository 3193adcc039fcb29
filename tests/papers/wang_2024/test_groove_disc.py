"""The groove: what every circle through A and C has in common."""

from __future__ import annotations

import math

import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.papers.wang_2024 import groove_disc
from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.device import groove

RADII = (0.025, 0.03682, 0.1, 1.0)


@pytest.mark.parametrize("radius", RADII)
def test_47_degrees_reach_29_millimetres_in_every_groove(radius: float) -> None:
    reached = float(groove(radius).active_length(jnp.asarray(math.radians(47.0))))
    assert reached == pytest.approx(0.054 - 0.025, rel=1e-9)  # rounding, worse for a large circle
    assert groove_disc.length_at_limit_angle() == pytest.approx(0.029, rel=1e-9)


def test_no_circle_through_a_and_c_is_a_spiral() -> None:
    # dl_2/d(alpha) of a spiral is constant. By brute force: the distance of each arc from the closest straight line
    angles = np.linspace(0.0, math.radians(47.0), 401)
    coarse = np.geomspace(1.002 * groove_disc.half_chord(), 10.0, 60)
    best = math.inf
    for centre, radii in (("near", np.append(coarse, np.linspace(0.034, 0.040, 61))), ("far", coarse)):
        for radius in radii:
            lengths = np.asarray(groove(float(radius), centre=centre).active_length(jnp.asarray(angles)))
            slopes = np.polyfit(angles, lengths, 1)[0] * np.linspace(0.9, 1.1, 401)
            best = min(best, float(0.5 * np.ptp(lengths - slopes[:, None] * angles, axis=1).min()))
    assert best > 2e-4  # m: ten times what a cutter holds
    assert groove_disc.spiral_error() == pytest.approx(best, rel=0.02)  # radii 0.1 mm and slopes 0.05 % apart


def test_the_far_centre_is_far_worse() -> None:
    # a circle of the largest radius is nearly the straight slot from A to C, the best that the far centre has
    angles = jnp.linspace(0.0, paper.OUTER_ANGLE, 101)
    small, large = (
        groove_disc.from_spiral(np.asarray(groove(radius, centre="far").active_length(angles)))
        for radius in (0.1, groove_disc.LARGEST_RADIUS)
    )
    assert small > large > 10.0 * groove_disc.spiral_error()


def test_the_closest_spiral_is_closer_than_the_least_squares_one() -> None:
    radius = groove_disc.arc_radius()
    assert groove_disc.spiral_distance(radius) < float(groove_disc.whole_groove_error(radius, "near"))


def test_closest_spiral_of_a_parabola_by_hand() -> None:
    # the closest line to a^2 on an interval of the width 2 h leaves h^2/2
    angles = np.linspace(0.0, paper.OUTER_ANGLE, 101)
    assert groove_disc.from_spiral(angles**2) == pytest.approx(0.125 * paper.OUTER_ANGLE**2, rel=1e-4)  # search


def test_the_straightest_radius_is_a_minimum() -> None:
    radius, error = groove_disc.straightest("near")
    for other in (0.99 * radius, 1.01 * radius):
        assert float(groove_disc.whole_groove_error(other, "near")) > error


def test_the_line_is_the_least_squares_line() -> None:
    disc, course = groove(groove_disc.arc_radius()), groove_disc.course()
    ends = [float(disc.angle(jnp.asarray(length))) for length in (paper.LENGTH_MIN, paper.LENGTH_MAX)]
    assert [course.angle_min, course.angle_max] == pytest.approx(ends, rel=1e-12)  # compiled or not
    angles = np.linspace(*ends, 4001)
    lengths = np.asarray(disc.active_length(jnp.asarray(angles)))
    slope, intercept = np.polyfit(angles, lengths, 1)
    assert groove_disc.line_slope() == pytest.approx(slope, rel=1e-4)  # sums against integrals
    assert groove_disc.line_intercept() == pytest.approx(intercept, rel=2e-2)  # small against the lengths
    assert groove_disc.line_error() == pytest.approx(np.abs(lengths - slope * angles - intercept).max(), rel=1e-2)


def test_effective_range_takes_far_less_than_47_degrees() -> None:
    assert math.degrees(groove_disc.angle_of_effective_range()) < 31.0


def test_line_costs_what_its_length_error_does() -> None:
    # K falls as l_1^-(3 - 2 l_1/l_2), at most 2.6 between 6 and 25 mm; the line is off by 0.17 mm at most
    cost = 0.05 - groove_disc.line_serves_the_chain(largest=0.05)
    assert 0.0 < cost < 2.62 * groove_disc.line_error() / 0.006
