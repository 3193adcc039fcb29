"""Richter's law, and the motor on an ideal store, which must be the same."""

from __future__ import annotations

import jax
import jax.numpy as jnp
import pytest
from hypothesis import given
from hypothesis import strategies as st

from varistiff.dynamics.drives import Motor
from varistiff.dynamics.semi_active import best_braking_torque, regenerates, semi_active_power
from varistiff.dynamics.storage import Supercapacitor

K, R, N = 0.0259, 0.611, 86.0
A = K * N
WINDING = {"resistance": R, "coupling": A}

torques = st.floats(-20.0, 20.0)
rates = st.floats(-8.0, 8.0)


@jax.jit
def stored_power(torque: jax.Array, rate: jax.Array) -> jax.Array:
    """Of a motor on an ideal capacitor, high enough never to limit it."""
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=1e-6, gear_ratio=N)
    store = Supercapacitor(capacitance=10.0, voltage=200.0)
    charge = jnp.asarray(store.charge0)
    flows = motor.flows(-torque, rate, store.open_voltage(charge))
    return store.flows(charge, flows.electrical_power).stored_power


@given(torques, rates)
def test_motor_on_an_ideal_capacitor_follows_the_law(torque: float, rate: float) -> None:
    expected = float(semi_active_power(torque, rate, **WINDING))
    scale = abs(torque * rate) + R * torque**2 / A**2
    assert float(stored_power(torque, rate)) == pytest.approx(
        expected, rel=1e-12, abs=1e-12 * scale + 1e-300
    )  # of a difference


@pytest.mark.parametrize("rate", [-3.0, 0.7])
def test_most_is_returned_at_half_of_the_limit(rate: float) -> None:
    best = float(best_braking_torque(jnp.asarray(rate), **WINDING))
    assert best == pytest.approx(A**2 * rate / (2.0 * R), rel=1e-14)
    assert float(semi_active_power(best, rate, **WINDING)) == pytest.approx(A**2 * rate**2 / (4.0 * R), rel=1e-14)
    slope = jax.grad(lambda torque: semi_active_power(torque, rate, **WINDING))(best)
    assert float(slope) == pytest.approx(0.0, abs=1e-14 * abs(rate))  # rounding
    # at the limit nothing is returned: the winding takes it all
    assert float(semi_active_power(2.0 * best, rate, **WINDING)) == pytest.approx(0.0, abs=1e-12 * abs(best * rate))


@given(torques, rates)
def test_it_regenerates_between_zero_and_the_limit(torque: float, rate: float) -> None:
    power = float(semi_active_power(torque, rate, **WINDING))
    scale = abs(torque * rate) + R * torque**2 / A**2
    if abs(power) > 1e-12 * scale + 1e-300:  # else the sign is rounding, or denormal
        assert bool(regenerates(torque, rate, **WINDING)) == (power > 0.0)


def test_at_rest_nothing_is_returned() -> None:
    for torque in (-3.0, 0.0, 3.0):
        assert not bool(regenerates(torque, 0.0, **WINDING))
        assert float(semi_active_power(torque, 0.0, **WINDING)) <= 0.0
