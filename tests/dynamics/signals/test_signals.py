"""Every signal against closed forms, and its derivatives against automatic ones."""

from __future__ import annotations

import math
from collections.abc import Callable

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from varistiff.core.errors import InputError
from varistiff.dynamics.signals import (
    Chirp,
    Constant,
    MinimumJerk,
    Pulse,
    Samples,
    Scaled,
    Signal,
    Sine,
    Step,
    Sum,
)

WAVE = Samples.through(np.linspace(-0.4, 1.6, 9), [0.3, -1.2, 0.8, 2.0, -0.5, 0.1, 1.4, -0.9, 0.6])
LOOP = Samples.through(np.linspace(0.2, 1.5, 7), [0.3, -1.2, 0.8, 2.0, -0.5, 0.1, 0.3], periodic=True)

SIGNALS: dict[str, Signal] = {
    "constant": Constant(1.7),
    "step": Step(0.3, -1.0, 2.5),
    "minimum_jerk": MinimumJerk(0.25, 0.8, -0.6, 1.9),
    "sine": Sine(0.4, 1.3, 0.7, 0.9),
    "linear_chirp": Chirp(0.1, 1.1, -0.2, 0.7, 0.5, 3.0),
    "logarithmic_chirp": Chirp(0.1, 1.1, -0.2, 0.7, 3.0, 0.5, "logarithmic"),
    "rectangle": Pulse(0.2, 0.5, 3.0, "rectangle"),
    "half_sine": Pulse(0.2, 0.5, -3.0),
    "samples": WAVE,
    "periodic_samples": LOOP,
    "sum": Sum((Sine(0.4, 1.3, 0.7), Pulse(0.2, 0.5, -3.0), WAVE)),
    "scaled": Scaled(Sum((MinimumJerk(0.25, 0.8, -0.6, 1.9), LOOP)), -2.5),
}


@pytest.mark.parametrize("name", SIGNALS)
def test_derivatives_are_the_automatic_ones(name: str) -> None:
    signal = SIGNALS[name]
    times = np.random.default_rng(7).uniform(-1.5, 3.0, 400)  # no time is a break or an end of a cell
    value = jax.jit(jax.vmap(lambda t: signal.at(t).value))(times)
    rate = jax.jit(jax.vmap(jax.grad(lambda t: signal.at(t).value)))(times)
    acceleration = jax.jit(jax.vmap(jax.grad(lambda t: signal.at(t).rate)))(times)
    at = signal.at(jnp.asarray(times))
    # the same products in another order: rounding
    np.testing.assert_allclose(at.value, value, rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(at.rate, rate, rtol=1e-11, atol=1e-11 * (1.0 + np.max(np.abs(rate))))
    np.testing.assert_allclose(
        at.acceleration, acceleration, rtol=1e-11, atol=1e-11 * (1.0 + np.max(np.abs(acceleration)))
    )
    for part in at:
        assert part.dtype == jnp.float64
        assert part.shape == times.shape


@pytest.mark.parametrize("name", SIGNALS)
def test_a_gradient_with_respect_to_every_parameter_is_finite(name: str) -> None:
    arrays = jax.tree.map(jnp.asarray, SIGNALS[name])
    # at a break, at an end of a table, inside and outside
    times = jnp.array([-3.0, -0.4, 0.1, 0.2, 0.25, 0.3, 0.7, 1.2, 1.6, 5.0])
    gradient = jax.jit(jax.jacrev(lambda signal: sum(signal.at(times))))(arrays)
    assert all(bool(jnp.all(jnp.isfinite(leaf))) for leaf in jax.tree.leaves(gradient))


@pytest.mark.parametrize("name", SIGNALS)
def test_breaks_are_where_value_or_rate_jumps(name: str) -> None:
    signal = SIGNALS[name]
    breaks = signal.breaks
    assert list(breaks) == sorted(set(breaks))
    assert all(type(instant) is float for instant in breaks)

    ends = [0.1, 0.2, 0.25, 0.3, 0.7, 1.05, 1.2, 1.5, -0.4, 1.6]
    others = [instant for instant in ends if all(abs(instant - one) > 1e-6 for one in breaks)]
    instants = np.array([*breaks, *others])
    before, after = (signal.at(jnp.asarray(instants + side * 1e-9)) for side in (-1.0, 1.0))
    jumps = np.maximum(np.abs(after.value - before.value), np.abs(after.rate - before.rate))
    # over 2 ns a smooth signal here changes by less than 1e-6 (rates up to 200/s^2); the jumps are above 0.1
    assert np.all(jumps[: len(breaks)] > 0.1)
    assert np.all(jumps[len(breaks) :] < 1e-6)


def test_a_jump_has_the_value_after_it() -> None:
    assert float(Step(0.3, -1.0, 2.5).at(jnp.asarray(0.3)).value) == 2.5
    assert float(Pulse(0.2, 0.5, 3.0, "rectangle").at(jnp.asarray(0.2)).value) == 3.0
    assert float(Pulse(0.25, 0.5, 3.0, "rectangle").at(jnp.asarray(0.75)).value) == 0.0


def test_minimum_jerk_meets_its_six_conditions_and_peak_rate() -> None:
    signal = MinimumJerk(0.25, 0.8, -0.6, 1.9)
    for time, value in ((0.25, -0.6), (1.05, 1.9)):
        assert [float(part) for part in signal.at(jnp.asarray(time))] == pytest.approx([value, 0.0, 0.0], abs=1e-14)
    middle = signal.at(jnp.asarray(0.65))
    # Flash and Hogan: half of the way at half of the time, 15/8 of the mean rate
    assert [float(part) for part in middle] == pytest.approx([0.65, 15.0 / 8.0 * 2.5 / 0.8, 0.0], abs=1e-13)


def test_minimum_jerk_has_the_least_jerk() -> None:
    def cost(bend: float) -> float:
        # another motion with the same ends: bend s^3 (1 - s)^3 (s - 0.3) added
        base = np.polynomial.Polynomial([0, 0, 0, 10, -15, 6])
        s = np.polynomial.Polynomial([0, 1])
        jerk = (base + bend * s**3 * (1 - s) ** 3 * (s - 0.3)).deriv(3)
        return float((jerk**2).integ()(1.0) - (jerk**2).integ()(0.0))

    assert cost(0.0) == pytest.approx(720.0)  # of the fifth-order polynomial
    assert min(cost(-0.1), cost(0.1)) > cost(0.0)
    s = jnp.linspace(0.0, 1.0, 11)
    np.testing.assert_allclose(
        MinimumJerk(0.0, 1.0, 0.0, 1.0).at(s).value, 10 * s**3 - 15 * s**4 + 6 * s**5, atol=1e-15
    )


def frequency_law(sweep: str) -> Callable[[float], float]:
    if sweep == "linear":
        return lambda t: 0.5 + (3.0 - 0.5) * min(max((t - 0.1) / 1.1, 0.0), 1.0)
    return lambda t: 0.5 * (3.0 / 0.5) ** min(max((t - 0.1) / 1.1, 0.0), 1.0)


@pytest.mark.parametrize("sweep", ["linear", "logarithmic"])
@pytest.mark.parametrize("time", [0.05, 0.1, 0.4, 1.2, 2.0])
def test_the_phase_of_a_chirp_is_the_integral_of_its_frequency(sweep: str, time: float) -> None:
    signal = Chirp(0.1, 1.1, -0.2, 0.7, 0.5, 3.0, sweep)  # type: ignore[arg-type]  # the parametrisation is plain text
    turns = quad(frequency_law(sweep), 0.1, max(time, 0.1), points=[1.2], epsabs=1e-13)[0]
    at = signal.at(jnp.asarray(time))
    assert float(at.value) == pytest.approx(-0.2 + 0.7 * math.sin(2.0 * math.pi * turns), abs=1e-12)  # quad's tolerance
    if time > 0.1:
        rate = 0.7 * 2.0 * math.pi * frequency_law(sweep)(time) * math.cos(2.0 * math.pi * turns)
        assert float(at.rate) == pytest.approx(rate, abs=1e-10)


@pytest.mark.parametrize("ratio", [1.0, 1.0 + 1e-10, 1.0 + 1e-7])
def test_a_logarithmic_chirp_without_a_sweep_is_a_sine(ratio: float) -> None:
    signal = Chirp(0.0, 2.0, 0.1, 0.7, 1.5, 1.5 * ratio, "logarithmic")
    sine = Sine(0.1, 0.7, 1.5)
    times = jnp.linspace(0.0, 3.0, 17)
    # the phase differs by at most the sweep: 2 pi 1.5 Hz (ratio - 1) 3 s, times the amplitude
    bound = 0.7 * 2.0 * math.pi * 1.5 * (ratio - 1.0) * 3.0 + 1e-13
    np.testing.assert_allclose(signal.at(times).value, sine.at(times).value, rtol=0.0, atol=bound)


@pytest.mark.parametrize("shape, part", [("rectangle", 1.0), ("half_sine", 2.0 / math.pi)])
def test_the_impulse_of_a_pulse_is_its_integral(shape: str, part: float) -> None:
    pulse = Pulse(0.2, 0.5, 3.0, shape)  # type: ignore[arg-type]  # the parametrisation is plain text
    integral = quad(lambda t: float(pulse.at(jnp.asarray(t)).value), 0.2, 0.7 - 1e-15)[0]
    assert pulse.impulse == pytest.approx(integral, rel=1e-9)  # of quad
    assert pulse.impulse == pytest.approx(3.0 * 0.5 * part)


@given(time=st.floats(-10.0, 10.0), phase=st.floats(-7.0, 7.0), frequency=st.floats(0.01, 50.0))
def test_a_sine_obeys_its_equation_of_motion(time: float, phase: float, frequency: float) -> None:
    at = Sine(0.4, 1.3, frequency, phase).at(jnp.asarray(time))
    pulsation = 2.0 * math.pi * frequency
    square = (float(at.value) - 0.4) ** 2 + (float(at.rate) / pulsation) ** 2
    assert square == pytest.approx(1.3**2, rel=1e-12)  # rounding of sine and cosine
    assert float(at.acceleration) == pytest.approx(-(pulsation**2) * (float(at.value) - 0.4), abs=1e-12 * pulsation**2)


def test_a_sum_adds_and_without_parts_is_zero() -> None:
    times = jnp.linspace(-1.0, 2.0, 13)
    total = Sum((SIGNALS["sine"], SIGNALS["half_sine"])).at(times)
    for whole, one, other in zip(total, SIGNALS["sine"].at(times), SIGNALS["half_sine"].at(times), strict=True):
        np.testing.assert_array_equal(whole, one + other)
    assert float(Sum(()).at(jnp.asarray(1.0)).value) == 0.0
    assert Sum((Step(0.5, 0.0, 1.0), Pulse(0.2, 0.3, 1.0), Step(0.1, 0.0, 1.0))).breaks == (0.1, 0.2, 0.5)


@pytest.mark.parametrize(
    "make, field",
    [
        (lambda bad: MinimumJerk(0.0, bad, 0.0, 1.0), "duration"),
        (lambda bad: Pulse(0.0, bad, 1.0), "duration"),
        (lambda bad: Chirp(0.0, bad, 0.0, 1.0, 1.0, 2.0), "duration"),
        (lambda bad: Chirp(0.0, 1.0, 0.0, 1.0, bad, 2.0), "first_frequency"),
        (lambda bad: Chirp(0.0, 1.0, 0.0, 1.0, 1.0, bad), "last_frequency"),
    ],
)
@pytest.mark.parametrize("bad", [0.0, -1.0, math.inf, math.nan])
def test_a_parameter_that_is_not_above_zero_is_refused(make: Callable[[float], Signal], field: str, bad: float) -> None:
    with pytest.raises(InputError, match=f"^{field}: .*; allowed is a number above zero"):
        make(bad)
