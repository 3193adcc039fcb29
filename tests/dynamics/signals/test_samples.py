"""The spline through samples against SciPy's, and what it does beyond its table."""

from __future__ import annotations

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline

from varistiff.core.errors import InputError
from varistiff.dynamics.signals import Samples

TIMES = np.linspace(0.3, 2.1, 13)
VALUES = np.array([0.3, -1.2, 0.8, 2.0, -0.5, 0.1, 1.4, -0.9, 0.6, 0.2, -0.3, 1.1, 0.7])
CLOSED = np.append(VALUES[:-1], VALUES[0])
ENDS = {"not_a_knot": "not-a-knot", "natural": "natural", "at_rest": "clamped"}


@pytest.mark.parametrize("ends", ENDS)
def test_even_samples_are_scipys_spline(ends: str) -> None:
    signal = Samples.through(TIMES, VALUES, ends=ends)  # type: ignore[arg-type]  # the parametrisation is plain text
    spline = CubicSpline(TIMES, VALUES, bc_type=ENDS[ends])
    times = np.linspace(0.3, 2.1, 997)
    at = signal.at(jnp.asarray(times))
    scale = np.max(np.abs(spline(times, 2)))
    for order, part in enumerate(at):
        # rounding of the cell's beginning: 1e-16 times the next derivative
        np.testing.assert_allclose(part, spline(times, order), rtol=0.0, atol=1e-12 * scale)
    assert signal.resampling_error == 0.0
    assert signal.duration == pytest.approx(1.8)


def test_periodic_samples_are_scipys_spline_in_every_period() -> None:
    signal = Samples.through(TIMES, CLOSED, periodic=True)
    spline = CubicSpline(TIMES, CLOSED, bc_type="periodic")
    times = np.linspace(-5.0, 8.0, 1501)
    scale = np.max(np.abs(spline(times, 2)))
    for order, part in enumerate(signal.at(jnp.asarray(times))):
        np.testing.assert_allclose(part, spline(times, order), rtol=0.0, atol=1e-12 * scale)
    assert signal.breaks == ()


@pytest.mark.parametrize("periodic", [True, False])
def test_the_spline_is_twice_continuously_differentiable(periodic: bool) -> None:
    signal = Samples.through(TIMES, CLOSED, periodic=periodic)
    knots = TIMES if periodic else TIMES[1:-1]
    before, after = (signal.at(jnp.asarray(knots + side * 1e-9)) for side in (-1.0, 1.0))
    third = np.max(np.abs(6.0 * np.asarray(signal.coefficients)[:, 0]))
    for one, other, slope in zip(before, after, (50.0, 1e3, third), strict=True):
        # over 2 ns each changes by its next derivative, which is below the slope
        np.testing.assert_allclose(one, other, rtol=0.0, atol=3e-9 * slope)


def test_the_values_at_the_ends_are_held() -> None:
    signal = Samples.through(TIMES, VALUES)
    early, late = (signal.at(jnp.asarray(time)) for time in (0.1, 2.5))
    assert [float(part) for part in early] == pytest.approx([0.3, 0.0, 0.0])
    assert [float(part) for part in late] == pytest.approx([0.7, 0.0, 0.0])
    assert signal.breaks == pytest.approx((0.3, 2.1))


def test_a_table_that_rests_at_its_ends_has_no_breaks() -> None:
    assert Samples.through(TIMES, VALUES, ends="at_rest").breaks == ()
    rising = np.append(VALUES[:1], VALUES[:1])
    assert Samples.through([0.0, 1.0], rising).breaks == ()
    # x^2 (3 - x) up to its top: the spline is the cubic itself, which leaves from rest and arrives at rest at x = 2
    x = np.linspace(0.0, 2.0, 6)
    assert Samples.through(x, x**2 * (3.0 - x)).breaks == ()
    assert Samples.through(x[:-1], (x**2 * (3.0 - x))[:-1]).breaks == pytest.approx((1.6,))


@given(
    cubic=st.tuples(*[st.floats(-3.0, 3.0)] * 4),
    count=st.integers(4, 30),
    time=st.floats(0.5, 2.0),
)
def test_a_cubic_is_reproduced(cubic: tuple[float, ...], count: int, time: float) -> None:
    line = np.polynomial.Polynomial(cubic)
    instants = np.linspace(0.5, 2.0, count)
    at = Samples.through(instants, line(instants)).at(jnp.asarray(time))
    for order, part in enumerate(at):
        # rounding of second differences: eps / step^2, at most 1e-16 * 100 / 0.05^2
        assert float(part) == pytest.approx((line.deriv(order) if order else line)(time), abs=1e-10)


@pytest.mark.parametrize("periodic", [True, False])
def test_uneven_times_are_resampled_within_the_stated_error(periodic: bool) -> None:
    chance = np.random.default_rng(3)
    instants = np.sort(np.concatenate([[0.0, 1.2], chance.uniform(0.0, 1.2, 40)]))
    values = np.sin(2.0 * math.pi * instants / 1.2) + 0.3 * np.cos(6.0 * math.pi * instants / 1.2)
    signal = Samples.through(instants, values, periodic=periodic)
    spline = CubicSpline(instants, np.append(values[:-1], values[0]), bc_type="periodic" if periodic else "not-a-knot")
    times = np.linspace(0.0, 1.2, 5000, endpoint=False)
    deviation = np.max(np.abs(np.asarray(signal.at(jnp.asarray(times)).value) - spline(times)))
    # the stated error is the largest at its own instants: another grid may find half as much again
    assert 0.0 < signal.resampling_error <= 1e-6 * np.ptp(values)
    assert deviation <= 1.5 * signal.resampling_error


def test_times_with_few_digits_are_resampled_not_shifted() -> None:
    exact = np.arange(31) / 30.0
    written = np.round(exact, 3)  # 0.033, 0.067, 0.1: up to a hundredth of a step away
    line = Samples.through(written, 2.0 * written)
    assert float(line.at(jnp.asarray(0.4)).value) == pytest.approx(0.8, abs=1e-12)  # a straight line stays one


@pytest.mark.parametrize("level", [0.0, 5.1, -3e7])
def test_a_constant_on_uneven_times_stays_one(level: float) -> None:
    at = Samples.through([0.0, 0.3, 1.0, 1.1], [level] * 4).at(jnp.asarray(0.7))
    assert float(at.value) == pytest.approx(level, rel=1e-14)  # rounding


def test_the_look_up_compiles_once_for_tables_of_one_size() -> None:
    seen = []

    @jax.jit
    def value(signal: Samples, time: jax.Array) -> jax.Array:
        seen.append(None)  # once a compilation
        return signal.at(time).value

    for shift in (0.0, 1.0):
        signal = jax.tree.map(jnp.asarray, Samples.through(TIMES + shift, VALUES + shift))
        assert float(value(signal, jnp.asarray(0.3 + shift))) == pytest.approx(0.3 + shift)
    assert len(seen) == 1


@pytest.mark.parametrize(
    "times, values, periodic, said",
    [
        ([0.0], [1.0], False, "times: has 1 points; allowed are at least 2"),
        ([0.0, 1.0], [1.0, 1.0], True, "times: has 2 points; allowed are at least 3"),
        ([0.0, 1.0], [1.0], False, "values: has 1 numbers; allowed is one for each of 2 times"),
        ([0.0, 1.0, 1.0], [1.0, 2.0, 3.0], False, "times: number 3 is not later than the one before"),
        ([0.0, 2.0, 1.0], [1.0, 2.0, 3.0], False, "times: number 3 is not later"),
        ([0.0, math.nan, 1.0], [1.0, 2.0, 3.0], False, "times: number 2 is not finite"),
        ([0.0, 0.5, 1.0], [1.0, 2.0, math.inf], False, "values: number 3 is not finite"),
        (
            [0.0, 0.5, 1.0],
            [1.0, 2.0, 1.1],
            True,
            "values: begins at 1 and ends at 1.1; allowed is a period that closes",
        ),
        ([0.0, 1e-9, 1.0, 2.0], [0.0, 1.0, 0.0, 1.0], False, "times: are too uneven"),
    ],
)
def test_points_that_are_no_signal_are_refused(
    times: list[float], values: list[float], periodic: bool, said: str
) -> None:
    with pytest.raises(InputError) as caught:
        Samples.through(times, values, periodic=periodic)
    assert said in str(caught.value)
