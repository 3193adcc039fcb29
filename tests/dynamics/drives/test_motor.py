"""The motor against the closed forms of a direct-current machine."""

from __future__ import annotations

import math

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from varistiff.core.errors import InputError
from varistiff.dynamics.drives import Drive, DriveFlows, Motor, Temperatures, TorqueSource

K, R, J, N = 0.0302, 0.299, 1.42e-5, 50.0
FULL = 1e6  # a command that saturates every limit here


def ask(drive: Drive, command: float, rate: float, voltage: float = 24.0, rise: float = 0.0) -> DriveFlows:
    """Flows as plain floats."""
    flows = drive.flows(jnp.asarray(command), jnp.asarray(rate), jnp.asarray(voltage), jnp.asarray(rise))
    return DriveFlows(*(float(value) for value in flows))


def spin(motor: Motor, *, voltage: float, load: float, times: np.ndarray) -> np.ndarray:
    """Output rate from rest under full command and a load torque, by SciPy at tight tolerance."""
    step = jax.jit(lambda rate: motor.flows(jnp.asarray(FULL), rate, jnp.asarray(voltage)).torque)

    def slope(_: float, rate: np.ndarray) -> list[float]:
        return [(float(step(rate[0])) - load) / motor.reflected_inertia]

    solution = solve_ivp(slope, (0.0, times[-1]), [0.0], t_eval=times, rtol=1e-10, atol=1e-10)
    return np.asarray(solution.y[0])


def test_run_up_is_exponential_with_the_mechanical_time_constant() -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, gear_ratio=N)
    time = J * R / K**2
    times = np.array([0.3, 1.0, 2.5]) * time
    expected = 24.0 / (K * N) * -np.expm1(-times / time)
    assert spin(motor, voltage=24.0, load=0.0, times=times) == pytest.approx(expected, rel=1e-8)  # of the integrator


def test_no_load_speed_and_current() -> None:
    # u = R i_0 + k w_0 with the friction k i_0
    no_load = 0.137
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, gear_ratio=N, friction_torque=K * no_load)
    rate = spin(motor, voltage=24.0, load=0.0, times=np.array([20.0 * J * R / K**2]))[0]
    expected = (24.0 - R * no_load) / (K * N)
    assert rate == pytest.approx(expected, rel=1e-8)  # exp(-20) of the run-up is left
    assert ask(motor, FULL, expected).current == pytest.approx(no_load, rel=1e-9)  # rounding of u - k w


def test_speed_under_load_is_on_the_line() -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, gear_ratio=N)
    load = 30.0
    rate = spin(motor, voltage=24.0, load=load, times=np.array([25.0 * J * R / K**2]))[0]
    assert rate == pytest.approx((24.0 - R * load / (N * K)) / (K * N), rel=1e-8)  # of the integrator


def test_stall() -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, gear_ratio=N)
    flows = ask(motor, FULL, 0.0)
    assert flows.torque == pytest.approx(N * K * 24.0 / R, rel=1e-14)  # rounding
    assert flows.current == pytest.approx(24.0 / R, rel=1e-14)
    assert flows.copper_power == flows.electrical_power == pytest.approx(24.0**2 / R, rel=1e-14)


@pytest.mark.parametrize("rate", [-30.0, -4.0, 0.0, 7.0, 15.8, 15.9, 40.0])  # no-load speed: 15.894 rad/s
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_saturated_torque_is_a_straight_line_through_all_quadrants(rate: float, side: float) -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, gear_ratio=N)
    flows = ask(motor, side * FULL, rate)
    assert flows.torque == pytest.approx(N * K * (side * 24.0 - K * N * rate) / R, rel=1e-10)  # cancels near no load
    assert flows.voltage == pytest.approx(side * 24.0, rel=1e-12)  # rounding


def test_above_the_no_load_speed_the_current_is_forced_back() -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, gear_ratio=N, current_limit=6.0)
    for command in (FULL, 0.0, -1.0):
        flows = ask(motor, command, 20.0)
        assert flows.current == pytest.approx((24.0 - K * N * 20.0) / R, rel=1e-12)  # rounding
        assert flows.current < -6.0  # the voltage has the last word
        assert flows.voltage == pytest.approx(24.0, rel=1e-12)
        assert flows.electrical_power < 0.0
        assert flows.torque < 0.0
    # a command that brakes harder than the limit allows is held by the limit where the voltage leaves it
    assert ask(motor, -FULL, 5.0).current == -6.0


def test_the_smaller_of_bus_and_drive_limits_the_voltage() -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, voltage_limit=12.0)
    assert ask(motor, FULL, 0.0, voltage=24.0).voltage == pytest.approx(12.0, rel=1e-14)
    assert ask(motor, FULL, 0.0, voltage=9.0).voltage == pytest.approx(9.0, rel=1e-14)
    # an empty storage shorts the motor
    for empty in (0.0, -1e-9):
        short = ask(motor, FULL, 100.0, voltage=empty)
        assert short.current == pytest.approx(-K * 100.0 / R, rel=1e-12)
        assert short.electrical_power == pytest.approx(0.0, abs=1e-9)


def test_current_limit_is_the_torque_limit() -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, gear_ratio=N, current_limit=6.0)
    assert motor.torque_limit == pytest.approx(N * K * 6.0, rel=1e-15)
    assert ask(motor, FULL, 1.0).torque == pytest.approx(motor.torque_limit, rel=1e-14)
    assert ask(motor, -FULL, 1.0).torque == pytest.approx(-motor.torque_limit, rel=1e-14)
    inside = 0.999 * motor.torque_limit
    assert ask(motor, inside, 1.0).torque == pytest.approx(inside, rel=1e-14)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_gear_loss_far_from_rest(side: float) -> None:
    eta, command = 0.7, 5.0
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, gear_ratio=N, gear_efficiency=eta)
    drives, driven = ask(motor, side * command, side * 8.0), ask(motor, side * command, -side * 8.0)
    assert drives.torque == pytest.approx(side * eta * command, rel=1e-13)  # the rotor turns 40 smoothing rates
    assert drives.gear_power == pytest.approx((1.0 - eta) * command * 8.0, rel=1e-12)
    assert driven.torque == pytest.approx(side * command / eta, rel=1e-13)
    assert driven.gear_power == pytest.approx((1.0 / eta - 1.0) * command * 8.0, rel=1e-12)


def test_gear_loss_fades_to_zero_at_rest() -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, gear_ratio=N, gear_efficiency=0.6)
    assert ask(motor, 5.0, 0.0).torque == pytest.approx(5.0, rel=1e-14)
    assert ask(motor, 5.0, 0.0).gear_power == 0.0


def test_resistance_rises_with_temperature() -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, resistance_coefficient=0.00393)
    hot = ask(motor, 5.0 * K, 100.0, rise=100.0)
    assert hot.current == pytest.approx(5.0, rel=1e-14)
    assert hot.copper_power == pytest.approx(R * 1.393 * 25.0, rel=1e-14)
    assert hot.voltage == pytest.approx(R * 1.393 * 5.0 + K * 100.0, rel=1e-14)


def test_reflected_inertia() -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J, gear_ratio=N, gear_inertia=3e-6)
    assert motor.reflected_inertia == pytest.approx(2500.0 * 1.72e-5, rel=1e-15)


small = st.floats(min_value=-1.0, max_value=1.0)
motors = st.builds(
    Motor,
    torque_constant=st.floats(0.005, 0.5),
    resistance=st.floats(0.01, 10.0),
    rotor_inertia=st.just(1e-5),
    gear_ratio=st.floats(1.0, 2000.0),
    gear_efficiency=st.floats(0.3, 1.0),
    current_limit=st.sampled_from([0.5, 8.0, math.inf]),
    voltage_limit=st.sampled_from([6.0, 48.0, math.inf]),
    friction_torque=st.floats(0.0, 0.05),
    viscous_friction=st.floats(0.0, 1e-4),
    resistance_coefficient=st.sampled_from([0.0, 0.00393]),
)


@eqx.filter_jit
def compiled(drive: Drive, command: jax.Array, rate: jax.Array, voltage: jax.Array, rise: jax.Array) -> DriveFlows:
    return drive.flows(command, rate, voltage, rise)


def as_arrays(motor: Motor) -> Motor:
    """The same motor with its numbers as arrays, so that one compiled function serves all."""
    return jax.tree.map(jnp.asarray, motor)


@given(motors, small, small, st.floats(0.0, 60.0), st.floats(0.0, 120.0))
def test_every_watt_has_a_name(motor: Motor, command: float, rate: float, voltage: float, rise: float) -> None:
    # rotor to 1000 rad/s, current to 20 A
    asked = command * 20.0 * motor.torque_constant * motor.gear_ratio
    turning = rate * 1000.0 / motor.gear_ratio
    flows = compiled(as_arrays(motor), *(jnp.asarray(x) for x in (asked, turning, voltage, rise)))
    lost = flows.copper_power + flows.gear_power
    powers = [abs(float(x)) for x in (flows.electrical_power, lost, flows.torque * turning)]
    # rounding, of terms that may cancel: k w i is within R i^2 and u i
    scale = max(*powers, float(flows.copper_power) + abs(float(flows.current)) * motor.torque_constant * 1000.0)
    assert abs(float(flows.electrical_power - lost - flows.torque * turning)) <= 1e-13 * scale + 1e-30
    assert float(flows.copper_power) >= 0.0
    assert float(flows.gear_power) >= 0.0
    if math.isfinite(motor.voltage_limit):
        assert abs(float(flows.voltage)) <= motor.voltage_limit * (1.0 + 1e-9) + 1e-9  # rounding of R i + k w


@given(motors, small, small, st.floats(0.0, 60.0))
def test_a_motor_has_no_preferred_direction(motor: Motor, command: float, rate: float, voltage: float) -> None:
    asked, turning = command * 10.0 * motor.gear_ratio, rate * 1000.0 / motor.gear_ratio
    arrays, volts, cold = as_arrays(motor), jnp.asarray(voltage), jnp.asarray(0.0)
    one = compiled(arrays, jnp.asarray(asked), jnp.asarray(turning), volts, cold)
    other = compiled(arrays, jnp.asarray(-asked), jnp.asarray(-turning), volts, cold)
    assert float(one.torque) == -float(other.torque)
    assert float(one.electrical_power) == float(other.electrical_power)
    assert float(one.gear_power) == float(other.gear_power)


@given(motors, small, small)
def test_torque_is_continuous(motor: Motor, command: float, rate: float) -> None:
    # its slopes: at most 1/eta in the command; in the rate back-EMF and friction, at most (1/eta) times each
    asked, turning = command * 10.0 * motor.torque_constant * motor.gear_ratio, rate * 1000.0 / motor.gear_ratio
    arrays, volts, cold = as_arrays(motor), jnp.asarray(24.0), jnp.asarray(0.0)
    step = 1e-7
    base = compiled(arrays, jnp.asarray(asked), jnp.asarray(turning), volts, cold)
    d_command, d_rate = (
        step * motor.torque_limit if math.isfinite(motor.torque_limit) else step,
        step / motor.gear_ratio,
    )
    more = compiled(arrays, jnp.asarray(asked + d_command), jnp.asarray(turning), volts, cold)
    faster = compiled(arrays, jnp.asarray(asked), jnp.asarray(turning + d_rate), volts, cold)
    k, n, eta = motor.torque_constant, motor.gear_ratio, motor.gear_efficiency
    rotor = k * abs(float(base.current)) + motor.friction_torque + motor.viscous_friction * 1e3
    # tanh(x)^2 rises at most 2 tanh' <= 1.54 times as fast as its argument; 4 covers the product of two of them
    assert abs(float(more.torque - base.torque)) <= 4.0 / eta * d_command + 1e-12 * n * rotor
    per_rate = k**2 / motor.resistance + motor.viscous_friction + (rotor / eta + motor.friction_torque) / 10.0
    assert abs(float(faster.torque - base.torque)) <= 4.0 / eta * n * per_rate * step + 1e-11 * n * rotor


def total(motor: Motor, command: jax.Array, rate: jax.Array, bus: jax.Array) -> jax.Array:
    flows = motor.flows(command, rate, bus, jnp.asarray(20.0))
    return flows.torque + 0.01 * flows.electrical_power + 0.1 * flows.gear_power


value, gradient = jax.jit(total), jax.jit(jax.grad(total, argnums=(0, 1, 2)))


@pytest.mark.parametrize("command, rate", [(0.0, 0.0), (3.0, 0.0), (0.0, 2.0), (5.0, -3.0), (400.0, 2.0), (3.0, 60.0)])
@pytest.mark.parametrize("current_limit, voltage_limit, bus", [(6.0, 24.0, 30.0), (math.inf, math.inf, math.inf)])
def test_gradients_are_finite_and_right(
    command: float, rate: float, current_limit: float, voltage_limit: float, bus: float
) -> None:
    motor = as_arrays(
        Motor(
            torque_constant=K,
            resistance=R,
            rotor_inertia=J,
            gear_ratio=N,
            gear_efficiency=0.8,
            current_limit=current_limit,
            voltage_limit=voltage_limit,
            friction_torque=0.004,
            resistance_coefficient=0.0039,
        )
    )
    for leaf in jax.tree.leaves(gradient(motor, command, rate, bus)):
        assert np.all(np.isfinite(leaf))
    # off the kinks at the limits: central differences
    step, beside = 1e-6, rate + 0.01
    ahead, behind = value(motor, command, beside + step, bus), value(motor, command, beside - step, bus)
    # rounding over the step; the truncation is of the order step^2
    expected = float(ahead - behind) / (2.0 * step)
    assert float(gradient(motor, command, beside, bus)[2]) == pytest.approx(expected, rel=1e-6, abs=1e-6)


def test_without_data_nothing_heats_up() -> None:
    motor = Motor(torque_constant=K, resistance=R, rotor_inertia=J)
    for drive in (motor, TorqueSource()):
        rates = drive.heat_rates(Temperatures(jnp.asarray(10.0), jnp.asarray(5.0)), jnp.asarray(100.0))
        assert (float(rates.winding), float(rates.housing)) == (0.0, 0.0)
        assert drive.temperature_limit == math.inf


def test_source_is_ideal() -> None:
    flows = ask(TorqueSource(), 3.0, -2.0)
    assert flows == DriveFlows(3.0, 0.0, 0.0, -6.0, 0.0, 0.0)
    assert TorqueSource().reflected_inertia == 0.0
    assert TorqueSource().torque_limit == math.inf
    assert ask(TorqueSource(limit=2.0), -3.0, 1.0).torque == -2.0


GOOD = {"torque_constant": K, "resistance": R, "rotor_inertia": J}


@pytest.mark.parametrize(
    "wrong, said",
    [
        ({"torque_constant": 0.0}, "torque_constant: is 0.0; allowed is a number above zero"),
        ({"resistance": -0.1}, "resistance: is -0.1"),
        ({"rotor_inertia": 0.0}, "rotor_inertia: is 0.0"),
        ({"gear_ratio": math.nan}, "gear_ratio: is nan"),
        ({"gear_ratio": math.inf}, "gear_ratio: is inf; allowed is a finite number"),
        ({"gear_efficiency": 1.1}, "gear_efficiency: is 1.1; allowed is an efficiency above 0 and up to 1"),
        ({"gear_efficiency": 0.0}, "gear_efficiency: is 0.0"),
        ({"current_limit": 0.0}, "current_limit: is 0.0"),
        ({"voltage_limit": -24.0}, "voltage_limit: is -24.0"),
        ({"friction_torque": -0.01}, "friction_torque: is -0.01; allowed is zero or a number above it"),
        ({"smoothing_rate": 0.0}, "smoothing_rate: is 0.0"),
    ],
)
def test_a_motor_that_cannot_be_is_refused(wrong: dict[str, float], said: str) -> None:
    with pytest.raises(InputError) as caught:
        Motor(**{**GOOD, **wrong})
    assert str(caught.value).startswith(said)
