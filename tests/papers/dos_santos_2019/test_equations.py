"""Equations (2) to (5), (12) and (15): what the printed forms give, by integrating the beam from one end."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

from varistiff.papers.dos_santos_2019.elastica import (
    contact_place,
    defined_force,
    defined_load,
    load_limit,
    load_parameter,
    printed_integral,
    printed_load_parameter,
    printed_roots,
    slope_of,
)

SLOPES = [0.01, 0.3, 0.9, 1.4]


def march(slope: float, force: float, ratio: float, *, length: float = 1.0) -> np.ndarray:
    """Integrate Eq. (1), E I = 1, from the contact to s = 0; returns theta(0), a and b."""

    def rates(_: float, state: np.ndarray) -> list[float]:
        theta, bending = state[0], state[1]
        return [-bending, force * math.cos(theta) + ratio * force * math.sin(theta), math.cos(theta), math.sin(theta)]

    end = solve_ivp(rates, (0.0, length), [slope, 0.0, 0.0, 0.0], rtol=1e-11, atol=1e-13).y[:, -1]
    return end[[0, 2, 3]]


@pytest.mark.parametrize("slope", SLOPES)
def test_conditions_stand_at_two_ends(slope):
    # theta = theta' = 0 at the contact: every force leaves a slope at the clamp, and no load is left in (3)
    force = load_parameter(slope) ** 2 / 2.0
    theta_at_clamp, _, _ = march(0.0, force, 0.0)
    assert abs(theta_at_clamp) > 0.3 * force
    assert printed_integral(0.0) == 0.0
    # theta = theta' = 0 at the clamp: the force has a moment there, more than the mean one, E I slope over L = 1
    turned, along, across = march(slope, force, math.tan(slope))
    assert force * (along + math.tan(slope) * across) > slope
    # one condition at each end is what the force of that slope meets
    assert turned == pytest.approx(0.0, abs=1e-8)  # the marching's own error


@pytest.mark.parametrize("slope", SLOPES)
def test_printed_factor_halves_the_force(slope):
    printed = defined_force(printed_load_parameter(slope), active_length=1.0, flexural_rigidity=1.0)
    right = defined_force(load_parameter(slope), active_length=1.0, flexural_rigidity=1.0)
    assert printed / right == pytest.approx(0.5, rel=1e-10)  # quadrature
    theta, _, across = march(slope, right, math.tan(slope))
    assert theta == pytest.approx(0.0, abs=1e-8)  # the marching's own error
    assert march(slope, printed, math.tan(slope))[0] > 0.3 * slope  # half the force leaves the clamp turned
    if slope < 0.1:
        assert right / (3.0 * across) == pytest.approx(1.0, rel=slope**2)  # the first correction is quadratic
        assert printed / (3.0 * across) == pytest.approx(0.5, rel=slope**2)


@pytest.mark.parametrize("slope", SLOPES)
def test_printed_place_needs_the_printed_integral(slope):
    alpha = load_parameter(slope)
    _, along, across = march(slope, alpha**2 / 2.0, math.tan(slope))
    for weight, right in (("cos", along), ("sin", across)):
        over = printed_integral(slope, weight) / math.sqrt(2.0)
        # the marching's own error, twice
        assert over / printed_load_parameter(slope) == pytest.approx(right, rel=1e-7)
        assert over / alpha == pytest.approx(math.sqrt(0.5) * right, rel=1e-7)
    # with the definition of alpha_0 a straight beam would be 0.707 of its length long
    assert printed_integral(1e-4, "cos") / (math.sqrt(2.0) * load_parameter(1e-4)) == pytest.approx(0.7071, abs=1e-4)


@pytest.mark.parametrize("slope", SLOPES)
def test_load_and_place_are_the_integrals(slope):
    whole = printed_integral(slope)
    assert load_parameter(slope) == pytest.approx(whole, rel=1e-11)  # quadrature
    places = [printed_integral(slope, weight) / whole for weight in ("cos", "sin")]
    assert contact_place(slope) == pytest.approx(places, rel=1e-10)  # quadrature


def test_printed_integral_is_that_of_the_paper():
    slope, n = 0.7, math.tan(0.7)
    root = quad(lambda angle: 1.0 / math.sqrt(-math.sin(angle) + n * math.cos(angle)), 0.0, slope)[0]
    assert printed_integral(slope) == pytest.approx(root, rel=1e-6)  # quad with the singular end


def test_load_limit_is_the_largest():
    slopes = np.linspace(0.02, 1.55, 400)
    values = [printed_integral(slope) for slope in slopes]
    assert load_limit()[0] == pytest.approx(max(values), rel=1e-5)  # a grid of 4 mrad at a maximum
    assert load_limit()[1] == pytest.approx(slopes[int(np.argmax(values))], abs=slopes[1] - slopes[0])


def test_slope_of_is_the_inverse_and_says_where_there_is_none():
    for slope in (0.01, 0.4, 0.8):
        assert slope_of(load_parameter(slope)) == pytest.approx(slope, rel=1e-9)  # its own stopping rule
    with pytest.raises(ValueError, match=r"largest is 1\.5176"):
        slope_of(1.6)


def test_defined_load_and_force_are_inverse():
    alpha = defined_load(20.0, active_length=0.75, flexural_rigidity=13.0)
    assert defined_force(alpha, active_length=0.75, flexural_rigidity=13.0) == pytest.approx(20.0)


def test_roots_of_the_one_equation():
    # b/a grows to 1.6694 = tan(59.08 deg) at 90 deg: physics of the elastica page
    assert printed_roots(0.3) == 1
    assert printed_roots(1.6) == 1
    assert printed_roots(1.8) == 0
