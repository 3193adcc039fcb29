"""PID: python-control's own loop, anti-windup in closed form, limits, gradients."""

from __future__ import annotations

import math
from typing import Any

import control
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from varistiff.core.errors import InputError
from varistiff.dynamics.control import (
    Measured,
    Pid,
    PositionPid,
    Wanted,
    reference_transfer_function,
    sampled_transfer_function,
    transfer_function,
)

INERTIA, PERIOD = 0.3, 2e-3
GAINS = {"proportional": 40.0, "integral": 60.0, "derivative": 5.0, "filter_time": 0.013}
DOUBLE = np.array([[0.0, 1.0], [0.0, 0.0]]), np.array([[0.0], [1.0 / INERTIA]])


def link(x: Any) -> Measured:
    return Measured(x[0], 0.0, 0.0)


def step_to_one(time: Any) -> Wanted:
    return Wanted(position=1.0 + 0.0 * time)


@pytest.mark.parametrize("derivative_on", ["measurement", "error"])
def test_step_on_a_double_integrator_is_that_of_python_control(simulate: Any, derivative_on: Any) -> None:
    # an independent loop: the plant by c2d, the law by its transfer function in z
    plant = control.c2d(control.ss(*DOUBLE, [[1.0, 0.0]], 0.0), PERIOD, "zoh")
    p, i, d, f = GAINS.values()
    # k_d (z - 1)/((T_f + T) z - T_f) and k_p + k_i T/(z - 1) as states: polynomials lose digits near z = 1
    pole = f / (f + PERIOD)
    slope = control.ss(pole, 1.0, d * (pole - 1.0) / (f + PERIOD), d / (f + PERIOD), PERIOD)
    inner = control.feedback(plant, slope)  # the derivative of the measurement alone
    law = control.ss(1.0, 1.0, i * PERIOD, p, PERIOD)
    loop = control.feedback(law * inner) if derivative_on == "measurement" else control.feedback((law + slope) * plant)
    samples = 500
    _, expected = control.step_response(loop, PERIOD * np.arange(samples))
    # start at the old target, so that the step reaches a derivative of the error in the first sample
    controller = PositionPid(Pid(**GAINS, derivative_on=derivative_on))
    states, _ = simulate(
        controller,
        *DOUBLE,
        [0.0, 0.0],
        wanted=lambda time: Wanted(position=jnp.where(time > 0.5 * PERIOD, 1.0, 0.0)),
        period=PERIOD,
        samples=samples,
        measure=link,
    )
    # the step comes one sample late here; rounding over 500 samples
    assert states[1 : samples + 1, 0] == pytest.approx(expected, abs=1e-10)
    assert np.ptp(expected) > 1.0


def test_transfer_functions_are_the_law() -> None:
    p, i, d, f = GAINS.values()
    for omega in (0.3, 7.0, 200.0):
        s, z = 1j * omega, np.exp(1j * omega * PERIOD)
        continuous = p + i / s + d * s / (f * s + 1.0)
        sampled = p + i * PERIOD / (z - 1.0) + d * (z - 1.0) / ((f + PERIOD) * z - f)
        pid = Pid(**GAINS)
        assert transfer_function(pid)(s) == pytest.approx(continuous, rel=1e-12)  # rounding
        assert sampled_transfer_function(pid, PERIOD)(z) == pytest.approx(sampled, rel=1e-9)  # z - 1 cancels
        assert reference_transfer_function(pid)(s) == pytest.approx(p + i / s, rel=1e-12)
        on_error = Pid(**GAINS, derivative_on="error")
        assert reference_transfer_function(on_error)(s) == pytest.approx(continuous, rel=1e-12)


def test_sampled_law_tends_to_the_continuous_one_at_first_order() -> None:
    pid, omega = Pid(**GAINS), 20.0
    errors = [
        abs(sampled_transfer_function(pid, period)(np.exp(1j * omega * period)) - transfer_function(pid)(1j * omega))
        for period in (4e-4, 2e-4)
    ]
    assert errors[0] / errors[1] == pytest.approx(2.0, rel=0.05)  # Euler's order; the rest is second order


def test_saturated_integral_stops_where_back_calculation_balances() -> None:
    pid = Pid(proportional=2.0, integral=5.0, windup_time=0.2, limit=3.0)
    memory = pid.start(4.0, 0.0)
    for _ in range(3000):  # 150 windup times
        command, memory = STEP(pid, memory, 4.0, 0.0)
    assert float(command) == 3.0
    # k_i e + (u - v)/T_t = 0 with v = k_p e + I
    assert float(memory.integral) == pytest.approx(3.0 + 5.0 * 4.0 * 0.2 - 2.0 * 4.0, rel=1e-12)


def test_without_anti_windup_the_integral_runs_away() -> None:
    pid = Pid(proportional=2.0, integral=5.0, limit=3.0)
    memory = pid.start(4.0, 0.0)
    for _ in range(300):
        _, memory = STEP(pid, memory, 4.0, 0.0)
    assert float(memory.integral) == pytest.approx(300 * 0.01 * 5.0 * 4.0, rel=1e-12)


STEP = jax.jit(lambda pid, memory, wanted, measured: pid.sample(memory, wanted, measured, 0.01))


def test_anti_windup_takes_the_overshoot_away(simulate: Any) -> None:
    peaks = []
    for windup_time in (0.3, math.inf):
        pid = Pid(proportional=8.0, integral=4.0, derivative=4.0, windup_time=windup_time, limit=0.5)
        states, commands = simulate(
            PositionPid(pid), *DOUBLE, [0.0, 0.0], wanted=step_to_one, period=PERIOD, samples=8000, measure=link
        )
        assert np.abs(commands).max() == 0.5  # it did saturate
        peaks.append(states[:, 0].max())
        if windup_time < math.inf:
            assert states[-1, 0] == pytest.approx(1.0, abs=1e-3)  # recovered; the slowest pole decays as exp(-0.6 t)
    assert peaks[0] < 1.0 + 0.5 * (peaks[1] - 1.0)


@given(
    errors=st.lists(st.floats(-1e3, 1e3), min_size=1, max_size=6),
    feedforward=st.floats(-50.0, 50.0),
    limit=st.floats(0.1, 20.0),
)
def test_command_never_exceeds_its_limit(errors: list[float], feedforward: float, limit: float) -> None:
    pid = Pid(proportional=3.0, integral=10.0, derivative=1.0, windup_time=0.1, limit=limit)
    memory = pid.start(0.0, 0.0)
    for error in errors:
        command, memory = LIMITED(pid, memory, error, feedforward)
        assert abs(float(command)) <= limit


LIMITED = jax.jit(lambda pid, memory, wanted, feedforward: pid.sample(memory, wanted, 0.0, 0.01, feedforward))


def test_derivative_kicks_on_the_error_only() -> None:
    for derivative_on, kick in (("measurement", 0.0), ("error", 5.0 / (0.013 + 0.002))):
        pid = Pid(proportional=0.0, derivative=5.0, filter_time=0.013, derivative_on=derivative_on)
        command, _ = pid.sample(pid.start(0.0, 0.0), 1.0, 0.0, 0.002)
        assert float(command) == pytest.approx(kick, rel=1e-14)


def test_feedforward_passes_and_counts_against_the_limit() -> None:
    pid = Pid(proportional=2.0, limit=5.0)
    assert float(pid.sample(pid.start(1.0, 0.0), 1.0, 0.0, 0.01, 1.5)[0]) == 3.5
    assert float(pid.sample(pid.start(1.0, 0.0), 1.0, 0.0, 0.01, 9.0)[0]) == 5.0


def test_feedback_may_come_from_link_or_drive() -> None:
    measured, wanted = Measured(link=0.2, drive=0.5, motion=9.0), Wanted(position=1.0)
    for feedback, error in (("link", 0.8), ("drive", 0.5)):
        controller = PositionPid(Pid(proportional=10.0), feedback)
        command, _ = controller.sample(controller.start(measured, wanted), measured, wanted, 0.01)
        assert float(command) == pytest.approx(10.0 * error, rel=1e-15)


def test_gradient_of_a_cost_with_respect_to_the_gains() -> None:
    def cost(gains: Any) -> Any:
        pid = Pid(gains[0], gains[1], gains[2], filter_time=0.01, windup_time=0.5, limit=30.0)

        def advance(carry: Any, _: Any) -> Any:
            x, v, memory = carry
            command, memory = pid.sample(memory, 1.0, x, PERIOD)
            v = v + PERIOD * command / INERTIA
            return (x + PERIOD * v, v, memory), (x - 1.0) ** 2

        zero = jnp.asarray(0.0)
        return PERIOD * jax.lax.scan(advance, (zero, zero, pid.start(1.0, zero)), None, length=300)[1].sum()

    gains, value = jnp.array([40.0, 60.0, 5.0]), jax.jit(cost)
    gradient = jax.jit(jax.grad(cost))(gains)
    for index, size in enumerate(np.asarray(gains) * 1e-5):
        shift = jnp.zeros(3).at[index].set(size)
        difference = (value(gains + shift) - value(gains - shift)) / (2.0 * size)
        assert float(gradient[index]) == pytest.approx(float(difference), rel=1e-6)  # rounding over size, and size^2
        assert abs(float(gradient[index])) > 1e-6


@pytest.mark.parametrize(
    "field, value",
    [
        ("proportional", math.nan),
        ("integral", math.inf),
        ("filter_time", -0.1),
        ("windup_time", 0.0),
        ("limit", 0.0),
        ("limit", np.array([1.0, -2.0])),
        ("derivative_on", "setpoint"),
    ],
)
def test_wrong_numbers_are_refused_by_name(field: str, value: Any) -> None:
    with pytest.raises(InputError, match=f"^{field}: must be "):
        Pid(**{"proportional": 1.0, field: value})


def test_wrong_feedback_is_refused() -> None:
    with pytest.raises(InputError, match="feedback: must be one of link, drive"):
        PositionPid(Pid(1.0), "motor")  # type: ignore[arg-type]  # what a user may write
