"""Heating of winding and housing against its exact solution."""

from __future__ import annotations

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from varistiff.core.errors import InputError
from varistiff.dynamics.drives import Motor, Temperatures, TwoNodeHeating

HEATING = TwoNodeHeating(
    winding_resistance=1.93, housing_resistance=4.65, winding_time=42.8, motor_time=809.0, rise_limit=130.0
)


def warm(power: float, times: np.ndarray) -> np.ndarray:
    """Temperatures over time from cold, by SciPy."""

    rates = jax.jit(HEATING.rates)

    def slope(_: float, state: np.ndarray) -> list[float]:
        return [float(rate) for rate in rates(Temperatures(*state), power)]

    return np.asarray(
        solve_ivp(slope, (0.0, times[-1]), [0.0, 0.0], t_eval=times, method="LSODA", rtol=1e-9, atol=1e-9).y
    )


def test_steady_temperatures() -> None:
    end = warm(15.0, np.array([20000.0]))[:, 0]  # 20 of the slow time constant: exp(-20) is left
    assert end == pytest.approx([15.0 * (1.93 + 4.65), 15.0 * 4.65], rel=1e-7)


def test_course_is_the_matrix_exponential() -> None:
    # x' = A x + b from the capacities C = tau/R, independent of the code's own form
    inner, outer = 42.8 / 1.93, 809.0 / 4.65
    a = np.array([[-1.0 / 1.93 / inner, 1.0 / 1.93 / inner], [1.0 / 1.93 / outer, -(1.0 / 1.93 + 1.0 / 4.65) / outer]])
    b = np.array([40.0 / inner, 0.0])
    times = np.array([5.0, 60.0, 400.0, 2000.0])
    still = -np.linalg.solve(a, b)
    expected = np.stack([still - expm(a * time) @ still for time in times], axis=1)
    assert warm(40.0, times) == pytest.approx(expected, rel=1e-6)  # of the integrator


def test_winding_alone_first_rises_with_power_over_capacity() -> None:
    rates = HEATING.rates(Temperatures(jnp.asarray(0.0), jnp.asarray(0.0)), jnp.asarray(30.0))
    assert float(rates.winding) == pytest.approx(30.0 * 1.93 / 42.8, rel=1e-14)
    assert float(rates.housing) == 0.0


def test_cooling_time_constants() -> None:
    # winding at a fixed housing: tau_w; housing alone, with the winding at its temperature: tau_m
    rates = HEATING.rates(Temperatures(jnp.asarray(10.0), jnp.asarray(0.0)), jnp.asarray(0.0))
    assert float(rates.winding) == pytest.approx(-10.0 / 42.8, rel=1e-14)
    rates = HEATING.rates(Temperatures(jnp.asarray(10.0), jnp.asarray(10.0)), jnp.asarray(0.0))
    assert float(rates.housing) == pytest.approx(-10.0 / 809.0, rel=1e-14)


def test_hot_copper_heats_itself() -> None:
    # T = R_th R (1 + alpha T) i^2  =>  T = R_th R i^2/(1 - alpha R_th R i^2)
    motor = Motor(
        torque_constant=0.0302,
        resistance=0.299,
        rotor_inertia=1.42e-5,
        resistance_coefficient=0.00393,
        thermal=HEATING,
    )
    command = jnp.asarray(6.0 * 0.0302)

    @jax.jit
    def rates(warmth: Temperatures) -> Temperatures:
        flows = motor.flows(command, jnp.asarray(0.0), jnp.asarray(24.0), warmth.winding)
        return motor.heat_rates(warmth, flows.copper_power)

    def slope(_: float, state: np.ndarray) -> list[float]:
        return [float(rate) for rate in rates(Temperatures(*state))]

    end = solve_ivp(slope, (0.0, 40000.0), [0.0, 0.0], method="LSODA", rtol=1e-9, atol=1e-9).y[0, -1]
    cold = (1.93 + 4.65) * 0.299 * 36.0
    assert end == pytest.approx(cold / (1.0 - 0.00393 * cold), rel=1e-6)  # of the integrator
    assert motor.temperature_limit == 130.0


def test_a_heating_that_cannot_be_is_refused() -> None:
    with pytest.raises(InputError, match=r"^winding_time: is 0\.0"):
        TwoNodeHeating(
            winding_resistance=1.0, housing_resistance=1.0, winding_time=0.0, motor_time=1.0, rise_limit=100.0
        )
