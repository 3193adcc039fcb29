"""The differential equation that Chacon et al. (2011) print in Cartesian coordinates has a wrong sign."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from varistiff.core.errors import InputError
from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.papers.chacon_2011 import printed_equation
from varistiff.papers.chacon_2011.devices import leaf

from .quadrature import U, W, parameter


@pytest.mark.parametrize("ratio", [3.5, 2.0])
def test_closed_form_solves_the_equation_with_plus_only(ratio: float) -> None:
    a, x = parameter(ratio) / ratio**2, np.linspace(0.0, ratio, 2001)
    sine = a * (x**2 - ratio * x)
    slope = sine / np.sqrt(1.0 - sine**2)  # the printed integrand
    second = np.gradient(slope, x, edge_order=2)
    departures = {}
    for sign in (1.0, -1.0):
        bracket = second / (1.0 + sign * slope**2) ** 1.5
        straight = np.polyval(np.polyfit(x, bracket, 1), x)
        departures[sign] = np.max(np.abs(bracket - straight)) / np.max(np.abs(bracket))
    assert departures[1.0] < 1e-5  # of the differences
    assert departures[-1.0] > 0.1
    for sign in (1.0, -1.0):
        ours = printed_equation.bracket_departure(aspect_ratio=ratio, sign=sign)
        assert (ours < 1e-12) == (sign > 0.0)


def test_printed_equation_has_no_solution_below_one() -> None:
    # y'/sqrt(1 - y'^2) is a parabola, so |y'| < 1 and the rise stays below the span
    loads = np.geomspace(1e-3, 1e3, 40)
    rises = np.array([printed_equation.rise_over_span(float(load)) for load in loads])
    assert np.all(np.diff(rises) > 0.0)
    assert rises[-1] < 1.0
    assert rises[-1] > 0.99
    for ratio in (1.0, 0.7, -2.0):
        with pytest.raises(InputError, match="above 1"):
            printed_equation.printed_load(ratio)
    assert printed_equation.rise_over_span(printed_equation.printed_load(1.05)) == pytest.approx(1.0 / 1.05, rel=1e-10)
    # the corrected equation has one for every aspect ratio
    assert float(W @ np.tan(np.arcsin(parameter(0.9) * (U - U**2)))) == pytest.approx(1.0 / 0.9, rel=1e-9)


def test_printed_energy_by_another_quadrature() -> None:
    def energy(ratio: float) -> float:
        def slope(u: float, load: float) -> float:
            return float(np.sin(np.arctan(load * (u - u * u))))

        load = brentq(lambda b: quad(slope, 0, 1, args=(b,), epsabs=1e-13)[0] - 1.0 / ratio, 0.0, 50.0, xtol=1e-13)

        def density(u: float) -> float:
            step = 1e-5
            second = (slope(u + step, load) - slope(u - step, load)) / (2.0 * step)
            return second**2 / (1.0 + slope(u, load) ** 2) ** 2.5

        return 0.5 * float(quad(density, 0, 1)[0]) / ratio

    for ratio in (3.5, 2.0):
        assert printed_equation.printed_energy(ratio) == pytest.approx(energy(ratio), rel=1e-8)
    assert 16.0 < printed_equation.printed_variation() < 18.0


def test_printed_shape_is_another_one() -> None:
    shape = printed_equation.printed_shape(2.0)
    np.testing.assert_allclose(shape[[0, -1]], [[0.0, 0.0], [1.0, 1.0]], atol=1e-14)
    np.testing.assert_allclose(shape[::-1], 1.0 - shape, atol=1e-12)  # point-symmetric
    assert printed_equation.shape_error(aspect_ratio=2.0) > 0.001
    assert printed_equation.shape_error(aspect_ratio=50.0) < 1e-5  # the sign does not matter for flat leaves


def test_slope_and_not_height_vanishes_at_the_clamp() -> None:
    span, rise = 0.1, 0.0405
    curve = GuidedLeaf().centreline(leaf(), span, rise, 2001)
    clamp, before = curve[-1], curve[-2]
    assert clamp[1] == pytest.approx(rise, rel=1e-12)
    assert abs((clamp[1] - before[1]) / (clamp[0] - before[0])) < 0.01
    # a height of zero at the clamp as well would leave the straight leaf alone: the rise grows with the parameter
    rises = [float(W @ np.tan(np.arcsin(q * (U - U**2)))) for q in np.linspace(0.0, 3.5, 30)]
    assert rises[0] == 0.0
    assert np.all(np.diff(rises) > 0.0)
