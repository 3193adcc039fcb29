"""Torque, impedance, decoupling: closed forms and python-control's loops on two inertias with a spring."""

from __future__ import annotations

import math
from typing import Any

import control
import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.actuators import Maccepa, SeriesElastic, TorsionTube
from varistiff.core.errors import InputError
from varistiff.dynamics.control import (
    GravityTorque,
    ImpedanceControl,
    LinkModel,
    Measured,
    Pid,
    PositionPid,
    SensedSpring,
    StiffnessDecoupling,
    TorqueControl,
    TwoMass,
    Wanted,
    wanted_deflection,
)
from varistiff.sections import Circle

MODEL = TwoMass(link_inertia=0.2, drive_inertia=0.05, link_damping=0.05, drive_damping=0.1)
TUBE = TorsionTube(shear_modulus=0.63e9, section=Circle(radius=0.01))
TORSION = 0.63e9 * math.pi * 0.01**4 / 2.0  # G J: stiffness GJ/x, linear in the deflection


def step_at_the_second_sample(period: float, **step: float) -> Any:
    return lambda time: Wanted(**{name: jnp.where(time > 0.5 * period, value, 0.0) for name, value in step.items()})


def test_torque_loop_on_a_locked_link_is_that_of_python_control(simulate: Any) -> None:
    stiffness, inertia, damping, period, samples = 160.0, 0.05, 0.4, 1e-3, 400
    gains = {"proportional": 1.5, "integral": 20.0, "derivative": 0.02, "filter_time": 0.004}
    p, i, d, f = gains.values()
    a, b = [[0.0, 1.0], [-stiffness / inertia, -damping / inertia]], [[0.0], [1.0 / inertia]]
    plant = control.c2d(control.ss(a, b, [[stiffness, 0.0]], 0.0), period, "zoh")
    # k_p + k_i T/(z - 1) + k_d (z - 1)/((T_f + T) z - T_f), each part as a state: polynomials lose digits near z = 1
    law = control.ss(1.0, 1.0, i * period, p, period)
    pole = f / (f + period)
    law = law + control.ss(pole, 1.0, d * (pole - 1.0) / (f + period), d / (f + period), period)
    loop = control.feedback(plant, law) * (1.0 + law)
    _, expected = control.step_response(loop, period * np.arange(samples))
    spring = SensedSpring(SeriesElastic(stiffness=stiffness))
    states, _ = simulate(
        TorqueControl(Pid(**gains, derivative_on="error"), spring),
        np.array(a),
        np.array(b),
        [0.0, 0.0],
        wanted=step_at_the_second_sample(period, torque=1.0),
        period=period,
        samples=samples,
        measure=lambda x: Measured(0.0, x[0], 0.0),
    )
    # the step comes one sample late here; rounding over 400 samples
    assert stiffness * states[1 : samples + 1, 0] == pytest.approx(expected, abs=1e-10)
    assert expected[-1] == pytest.approx(1.0, abs=0.02)  # it does track


def test_impedance_at_rest_is_the_virtual_spring(simulate: Any) -> None:
    stiffness, outside = 40.0, 3.0
    spring = SensedSpring(SeriesElastic(stiffness=160.0))
    inner = TorqueControl(Pid(proportional=2.0, integral=40.0, derivative=0.05, filter_time=2e-3), spring)
    states, commands = simulate(
        ImpedanceControl(inner, stiffness=stiffness, damping=4.0, filter_time=2e-3),
        *MODEL.matrices(160.0),
        [0.1, 0.0, 0.1, 0.0],
        wanted=lambda time: Wanted(position=0.1 + 0.0 * time, torque=1.0),
        period=1e-3,
        samples=4000,
        disturbance=[0.0, -outside / MODEL.link_inertia, 0.0, 0.0],
    )
    # K_v (q_w - q) + tau_w = tau_ext, and the drive holds what the spring puts on it
    assert states[-1, 0] == pytest.approx(0.1 - (outside - 1.0) / stiffness, abs=1e-9)  # e-folding time 0.1 s
    assert commands[-1] == pytest.approx(outside, abs=1e-7)
    assert states[-1, 2] - states[-1, 0] == pytest.approx(outside / 160.0, abs=1e-9)


def test_every_term_of_the_virtual_impedance() -> None:
    inner = TorqueControl(Pid(1.0), SensedSpring(SeriesElastic(stiffness=160.0)))
    controller = ImpedanceControl(inner, stiffness=40.0, damping=3.0, inertia=0.2)
    wanted = Wanted(position=0.5, position_rate=1.1, position_acceleration=7.0, torque=0.3)
    torque = controller.torque(Measured(0.4, 0.45, 0.0), wanted, 0.6)
    # K_v (q_w - q) + D_v (q_w' - q') + J_v q_w'' + tau_w
    assert float(torque) == pytest.approx(40.0 * 0.1 + 3.0 * 0.5 + 0.2 * 7.0 + 0.3, rel=1e-13)
    # the loop asks the spring for it: u = tau + k_p (tau - 160 * 0.05), with the rate 0 of a link that has not moved
    command, _ = controller.sample(
        controller.start(Measured(0.4, 0.45, 0.0), wanted), Measured(0.4, 0.45, 0.0), wanted, 1e-3
    )
    asked = 40.0 * 0.1 + 3.0 * 1.1 + 0.2 * 7.0 + 0.3
    assert float(command) == pytest.approx(asked + (asked - 8.0), rel=1e-13)


def free_answer(time: np.ndarray, stiffness: float, damping: float, inertia: float) -> np.ndarray:
    """J e'' + D e' + K e = 0 from e = 1 at rest, underdamped."""
    decay = damping / (2.0 * inertia)
    omega = math.sqrt(stiffness / inertia - decay**2)
    return np.exp(-decay * time) * (np.cos(omega * time) + decay / omega * np.sin(omega * time))


def decoupled(simulate: Any, joint_stiffness: float, bandwidth: float) -> np.ndarray:
    period, samples, virtual, damping = 2e-4, 3000, 20.0, 2.4
    servo = Pid(
        proportional=MODEL.drive_inertia * bandwidth**2,
        derivative=2.0 * MODEL.drive_inertia * bandwidth,
        derivative_on="error",
    )
    setting = TORSION / joint_stiffness
    controller = StiffnessDecoupling(
        SensedSpring(TUBE),
        servo,
        LinkModel(MODEL.link_inertia, MODEL.link_damping),
        stiffness=virtual,
        damping=damping,
        drive_inertia=MODEL.drive_inertia,
        drive_damping=MODEL.drive_damping,
    )
    states, _ = simulate(
        controller,
        *MODEL.matrices(joint_stiffness),
        [0.0] * 4,
        wanted=lambda time: Wanted(position=0.2 + 0.0 * time),
        period=period,
        samples=samples,
        measure=lambda x: Measured(x[0], x[2], setting),
    )
    time = period * np.arange(samples + 1)
    return states[:, 0] / 0.2 - 1.0 + free_answer(time, virtual, damping + MODEL.link_damping, MODEL.link_inertia)


def test_decoupled_link_does_not_know_its_spring(simulate: Any) -> None:
    errors = {
        (stiffness, bandwidth): np.abs(decoupled(simulate, stiffness, bandwidth)).max()
        for stiffness in (100.0, 1000.0)
        for bandwidth in (300.0, 600.0)
    }
    for stiffness in (100.0, 1000.0):
        # what is left is the servo's lag 2/w against the link's 10 rad/s: twice the bandwidth, half of it
        assert errors[stiffness, 300.0] < 0.08
        assert errors[stiffness, 600.0] < 0.65 * errors[stiffness, 300.0]


def test_a_servo_without_the_map_does_know_it(simulate: Any) -> None:
    ends = []
    for stiffness in (100.0, 1000.0):
        states, _ = simulate(
            PositionPid(Pid(proportional=200.0, derivative=6.0), "drive"),
            *MODEL.matrices(stiffness),
            [0.0] * 4,
            wanted=lambda time: Wanted(position=0.2 + 0.0 * time),
            period=2e-4,
            samples=3000,
        )
        ends.append(states[:, 0] / 0.2)
    assert np.abs(ends[0] - ends[1]).max() > 0.3


def test_setting_that_jumps_under_load_is_answered_at_once(simulate: Any) -> None:
    """The setting falls by half while the joint carries 5 N m; only the map tells the drive where to go."""
    outside, soft, stiff = 5.0, 100.0, 200.0
    period = 2e-4
    controller = StiffnessDecoupling(
        SensedSpring(TUBE),
        Pid(proportional=4500.0, derivative=30.0, derivative_on="error"),
        LinkModel(MODEL.link_inertia, MODEL.link_damping),
        stiffness=20.0,
        damping=2.4,
    )
    # held at rest with the soft spring, then the stiff one from the first sample on
    states, commands = simulate(
        controller,
        *MODEL.matrices(stiff),
        [0.0, 0.0, outside / soft, 0.0],
        wanted=lambda time: Wanted(torque=outside + 0.0 * time),
        period=period,
        samples=6000,
        measure=lambda x: Measured(x[0], x[2], TORSION / stiff),
        disturbance=[0.0, -outside / MODEL.link_inertia, 0.0, 0.0],
    )
    assert states[-1, 0] == pytest.approx(0.0, abs=1e-4)  # exp(-6 t) after 1.2 s
    assert states[-1, 2] == pytest.approx(outside / stiff, abs=1e-4)
    assert commands[-1] == pytest.approx(outside, rel=1e-2)
    # within 20 ms the drive has gone most of the way: the servo's 300 rad/s, not the link's 10
    assert abs(states[100, 2] - states[100, 0] - outside / stiff) < 0.1 * outside / soft


def test_command_on_target_is_the_spring_s_reaction() -> None:
    spring = SensedSpring(Maccepa(394.0, 0.036, 0.135), setting_min=0.005, setting_max=0.025)
    gravity = GravityTorque(moment=1.7, rest=0.2)
    controller = StiffnessDecoupling(
        spring, Pid(proportional=500.0), LinkModel(0.2, 0.05, gravity), stiffness=20.0, drive_inertia=0.05
    )
    measured = Measured(link=0.5, drive=0.8, motion=0.014)
    load = float(spring.response(measured).load)
    # a wanted motion that needs just this load: J q'' + gravity = load
    acceleration = (load - 1.7 * math.sin(0.3)) / 0.2
    wanted = Wanted(position=0.5, position_acceleration=acceleration)
    command, _ = controller.sample(controller.start(measured, wanted), measured, wanted, 1e-3)
    assert float(command) == pytest.approx(load + 0.05 * acceleration, rel=1e-12)


def test_wanted_deflection_converges_like_newton() -> None:
    maccepa = Maccepa(394.0, 0.036, 0.135)
    wanted = float(maccepa.respond(jnp.asarray(0.7), jnp.asarray(0.014))[0].load)
    deflection, errors = jnp.asarray(0.5), []
    for _ in range(4):
        response, _ = maccepa.respond(deflection, jnp.asarray(0.014))
        deflection = wanted_deflection(response, deflection, wanted, stiffness_min=1e-6)
        errors.append(abs(float(deflection) - 0.7))
    assert errors[3] < 1e-12
    assert errors[1] < 2.0 * errors[0] ** 2 + 1e-15  # quadratic


def test_slack_spring_asks_for_a_bounded_deflection() -> None:
    maccepa = Maccepa(394.0, 0.036, 0.135)
    slack, _ = maccepa.respond(jnp.asarray(0.0), jnp.asarray(-0.005))
    assert float(slack.stiffness) == 0.0
    assert float(wanted_deflection(slack, jnp.asarray(0.0), 2.0, stiffness_min=8.0)) == 0.25


def test_matrices_have_the_frequency_of_two_free_masses() -> None:
    j, j_1, k = 0.2, 0.05, 160.0
    a, _ = TwoMass(link_inertia=j, drive_inertia=j_1).matrices(k)
    omega = np.sort(np.abs(np.linalg.eigvals(a).imag))
    assert omega[-1] == pytest.approx(math.sqrt(k * (1.0 / j + 1.0 / j_1)), rel=1e-9)  # eigenvalues, a double zero
    # the link on a drive that is held by an infinite inertia, with gravity
    a, _ = TwoMass(link_inertia=j, drive_inertia=1e12, link_stiffness=30.0).matrices(k)
    assert np.abs(np.linalg.eigvals(a).imag).max() == pytest.approx(math.sqrt((k + 30.0) / j), rel=1e-9)


def test_semi_active_joints_and_wrong_numbers_are_refused(knee: Any) -> None:
    spring, pid = SensedSpring(knee, setting_min=0.2, setting_max=0.6, driven=False), Pid(1.0)
    with pytest.raises(InputError, match="semi-active joint has no drive"):
        TorqueControl(pid, spring)
    with pytest.raises(InputError, match="semi-active joint has no drive"):
        StiffnessDecoupling(spring, pid, LinkModel(0.2), stiffness=1.0)
    series = SensedSpring(SeriesElastic(stiffness=160.0))
    with pytest.raises(InputError, match="stiffness: must be at least 0"):
        ImpedanceControl(TorqueControl(pid, series), stiffness=-1.0)
    with pytest.raises(InputError, match="inertia: must be above 0"):
        LinkModel(0.0)
    with pytest.raises(InputError, match="stiffness_min: must be above 0"):
        StiffnessDecoupling(series, pid, LinkModel(0.2), stiffness=1.0, stiffness_min=0.0)
    with pytest.raises(InputError, match="link_inertia: must be above 0"):
        TwoMass(link_inertia=0.0, drive_inertia=1.0).matrices(1.0)
