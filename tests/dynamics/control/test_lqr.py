"""LQR: python-control's gains, the Riccati equation, poles at every setting, integral action."""

from __future__ import annotations

import math
from typing import Any

import control
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.linalg import expm, solve_continuous_are

from varistiff.actuators import Maccepa, SeriesElastic, SliderLeafJoint
from varistiff.core.errors import InputError
from varistiff.dynamics.control import (
    GravityTorque,
    LinkModel,
    LqrWeights,
    Measured,
    ScheduledLqr,
    SensedSpring,
    TwoMass,
    Wanted,
    closed_loop_poles,
    is_stable,
    lqr_gains,
    scheduled_lqr,
)
from varistiff.dynamics.path import GroovePath

J, J_1, D, D_1 = 0.11, 0.07, 0.13, 0.17
MODEL = TwoMass(link_inertia=J, drive_inertia=J_1, link_damping=D, drive_damping=D_1)
WEIGHTS = LqrWeights(link=400.0, torque=0.04, link_rate=1.0, drive=2.0, drive_rate=0.5)
SETTINGS = np.linspace(0.006, 0.025, 9)


def matrices(stiffness: float) -> tuple[np.ndarray, np.ndarray]:
    """Wang et al. (2024), Eq. (18), with the states (q, q', q_1, q_1')."""
    k = stiffness
    a = [[0, 1, 0, 0], [-k / J, -D / J, k / J, 0], [0, 0, 0, 1], [k / J_1, 0, -k / J_1, -D_1 / J_1]]
    return np.array(a, dtype=float), np.array([[0.0], [0.0], [0.0], [1.0 / J_1]])


def rest_stiffness(length: Any) -> Any:
    """Eq. (9) of the paper at rest, with its printed leaf."""
    return 206e9 * 0.025 * 1e-9 * (0.025 + length) ** 2 / (4.0 * length**3)


@pytest.fixture(scope="module")
def spring(wang_joint: SliderLeafJoint) -> SensedSpring:
    return SensedSpring(wang_joint, GroovePath(wang_joint.groove), setting_min=0.006, setting_max=0.025)


@pytest.fixture(scope="module")
def scheduled(spring: SensedSpring) -> ScheduledLqr:
    return scheduled_lqr(spring, MODEL, WEIGHTS, nodes=9)


def test_gains_at_the_nodes_are_those_of_python_control(scheduled: ScheduledLqr) -> None:
    q, r = np.diag([400.0, 1.0, 2.0, 0.5]), np.array([[0.04]])
    for setting in SETTINGS:
        expected, _, _ = control.lqr(*matrices(rest_stiffness(setting)), q, r)
        gains = [float(gain) for gain in scheduled.gain(float(setting))]
        assert gains == pytest.approx(expected[0], rel=1e-6)  # the same Riccati solver, stiffness to rounding


def test_gains_solve_the_riccati_equation() -> None:
    a, b = matrices(400.0)
    solution = solve_continuous_are(a, b, np.diag([400.0, 1.0, 2.0, 0.5]), np.array([[0.04]]))
    gains = lqr_gains(MODEL, np.array([400.0]), WEIGHTS)
    assert gains[0] == pytest.approx((b.T @ solution)[0] / 0.04, rel=1e-6)  # conditioning of the equation


def test_integral_action_is_that_of_python_control() -> None:
    weights = WEIGHTS._replace(integral=5000.0)
    q, output = np.diag([400.0, 1.0, 2.0, 0.5, 5000.0]), np.array([[1.0, 0.0, 0.0, 0.0]])
    expected, _, poles = control.lqr(*matrices(400.0), q, np.array([[0.04]]), integral_action=output)
    gains = lqr_gains(MODEL, np.array([400.0]), weights)
    assert gains[0] == pytest.approx(expected[0], rel=1e-6)
    found = closed_loop_poles(MODEL, 400.0, gains[0])
    assert np.sort_complex(found) == pytest.approx(np.sort_complex(poles), rel=1e-6)
    # among LQR's virtues: the integral weight alone sets the ratio of its gain, K_i = sqrt(w_i/w_u)
    assert gains[0][4] == pytest.approx(math.sqrt(5000.0 / 0.04), rel=1e-6)


def test_sampled_gains_are_those_of_dlqr_and_tend_to_the_continuous_ones() -> None:
    q, r = np.diag([400.0, 1.0, 2.0, 0.5]), np.array([[0.04]])
    continuous = lqr_gains(MODEL, np.array([400.0]), WEIGHTS)[0]
    errors = []
    for period in (2e-3, 1e-3):
        a, b = matrices(400.0)
        whole = expm(np.block([[a, b], [np.zeros((1, 5))]]) * period)
        expected, _, _ = control.dlqr(whole[:4, :4], whole[:4, 4:], q, r)
        gains = lqr_gains(MODEL, np.array([400.0]), WEIGHTS, period=period)[0]
        assert gains == pytest.approx(expected[0], rel=1e-6)
        poles = closed_loop_poles(MODEL, 400.0, gains, period=period)
        assert is_stable(poles, sampled=True)
        errors.append(np.abs(gains - continuous).max())
    assert errors[0] / errors[1] == pytest.approx(2.0, rel=0.1)  # first order in the period


@pytest.mark.parametrize("integral", [0.0, 5000.0])
def test_poles_are_stable_at_all_settings(spring: SensedSpring, integral: float) -> None:
    controller = scheduled_lqr(spring, MODEL, WEIGHTS._replace(integral=integral), nodes=9)
    for setting in np.linspace(0.006, 0.025, 61):
        a, b = matrices(rest_stiffness(setting))
        gains = np.array([[float(gain) for gain in controller.gain(float(setting))]])
        if integral:
            a = np.block([[a, np.zeros((4, 1))], [np.eye(1, 5)]])
            b = np.vstack([b, [[0.0]]])
        assert np.linalg.eigvals(a - b @ gains).real.max() < 0.0


def test_gains_are_linear_between_nodes_and_held_beyond(scheduled: ScheduledLqr) -> None:
    table = np.asarray(scheduled.gains)
    middle = [float(gain) for gain in scheduled.gain(0.25 * SETTINGS[3] + 0.75 * SETTINGS[4])]
    assert middle == pytest.approx(0.25 * table[3] + 0.75 * table[4], rel=1e-12)
    assert [float(gain) for gain in scheduled.gain(0.001)] == list(table[0])
    assert [float(gain) for gain in scheduled.gain(0.9)] == pytest.approx(table[-1], rel=1e-15)


def test_sampled_loop_tends_to_the_state_feedback(simulate: Any) -> None:
    stiffness, start, duration = 160.0, [0.1, 0.0, 0.15, 0.0], 0.3
    spring = SensedSpring(SeriesElastic(stiffness=stiffness))
    controller = scheduled_lqr(spring, MODEL, WEIGHTS)
    a, b = matrices(stiffness)
    exact = expm((a - b @ np.asarray(controller.gains)) * duration) @ start
    errors = []
    for period in (2e-4, 1e-4):
        states, _ = simulate(
            controller,
            a,
            b,
            start,
            wanted=lambda time: Wanted(position=0.0 * time),
            period=period,
            samples=round(duration / period),
        )
        errors.append(np.abs(states[-1] - exact).max())
    assert errors[1] < 2e-3
    assert errors[0] / errors[1] == pytest.approx(2.0, rel=0.1)  # held commands and differences: first order


def test_constant_torque_leaves_the_static_error_without_an_integral(simulate: Any) -> None:
    stiffness, outside = 160.0, 2.0
    spring = SensedSpring(SeriesElastic(stiffness=stiffness))
    ends = {}
    for integral in (0.0, 5000.0):
        controller = scheduled_lqr(spring, MODEL, WEIGHTS._replace(integral=integral))
        states, _ = simulate(
            controller,
            *matrices(stiffness),
            [0.0] * 4,
            wanted=lambda time: Wanted(position=0.1 + 0.0 * time),
            period=1e-3,
            samples=4000,
            disturbance=[0.0, -outside / J, 0.0, 0.0],
        )
        ends[integral] = states[-1, 0] - 0.1
    # u = -(K_1 + K_3) e - K_3 tau/k = tau at rest
    gains = lqr_gains(MODEL, np.array([stiffness]), WEIGHTS)[0]
    offset = -outside * (1.0 + gains[2] / stiffness) / (gains[0] + gains[2])
    assert ends[0.0] == pytest.approx(offset, rel=1e-6)  # settled
    assert ends[5000.0] == pytest.approx(0.0, abs=1e-6)


def test_command_on_target_is_the_feedforward(wang_joint: SliderLeafJoint, spring: SensedSpring) -> None:
    controller = scheduled_lqr(spring, MODEL, WEIGHTS, gravity=GravityTorque(1.3, 0.1))
    angle = 0.4
    link, deflection = 0.6, 0.01
    measured = Measured(link, link + deflection, angle)
    load = float(spring.response(measured).load)
    acceleration = (load - 1.3 * math.sin(0.5)) / J
    wanted = Wanted(position=link, position_acceleration=acceleration)
    command, _ = controller.sample(controller.start(measured, wanted), measured, wanted, 1e-3)
    assert float(command) == pytest.approx(load + J_1 * acceleration, rel=1e-11)  # gains of 1e2 on rounding


def test_integral_rests_while_the_command_is_limited() -> None:
    spring = SensedSpring(SeriesElastic(stiffness=160.0))
    controller = scheduled_lqr(spring, MODEL, WEIGHTS._replace(integral=5000.0), limit=2.0)
    measured, wanted = Measured(0.0, 0.0, 0.0), Wanted(position=1.0)
    memory = controller.start(measured, wanted)
    for _ in range(50):
        command, memory = controller.sample(memory, measured, wanted, 1e-3)
        assert float(command) == 2.0
    assert float(memory.error) == 0.0


def test_designs_that_cannot_be_are_refused(spring: SensedSpring, knee: Any) -> None:
    slack = SensedSpring(Maccepa(394.0, 0.036, 0.135), setting_min=0.0, setting_max=0.02)
    with pytest.raises(InputError, match=r"positive stiffness, but the map says 0 N\*m/rad at a setting of 0 m"):
        scheduled_lqr(slack, MODEL, WEIGHTS)
    with pytest.raises(InputError, match="nodes: must be at least 2"):
        scheduled_lqr(spring, MODEL, WEIGHTS, nodes=1)
    with pytest.raises(InputError, match="semi-active"):
        scheduled_lqr(SensedSpring(knee, setting_min=0.2, setting_max=0.6, driven=False), MODEL, WEIGHTS)
    with pytest.raises(InputError, match="torque: must be above 0"):
        lqr_gains(MODEL, np.array([1.0]), WEIGHTS._replace(torque=0.0))
    with pytest.raises(InputError, match="drive_inertia: must be above 0"):
        lqr_gains(MODEL._replace(drive_inertia=0.0), np.array([1.0]), WEIGHTS)
    with pytest.raises(InputError, match=r"gains: must have the shape \(n, 4\) or \(n, 5\)"):
        ScheduledLqr(spring, LinkModel(J), jnp.zeros((3, 2)), 0.006, 0.025)
    with pytest.raises(InputError, match="setting_max: must be a finite number"):
        scheduled_lqr(SensedSpring(spring.actuator, spring.path, 0.006, math.inf), MODEL, WEIGHTS)


def test_stability_is_told_apart() -> None:
    assert is_stable(np.array([-1.0 + 2.0j, -0.1]), sampled=False)
    assert not is_stable(np.array([-1.0, 0.0]), sampled=False)
    assert is_stable(np.array([0.5 + 0.5j]), sampled=True)
    assert not is_stable(np.array([-1.1]), sampled=True)
