"""Encoders, filtered rates, delays and the external torque that they tell."""

from __future__ import annotations

import math
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from varistiff.actuators import RollerBeam, SeriesElastic, SliderLeafJoint
from varistiff.core.errors import InputError
from varistiff.dynamics.control import (
    Delay,
    DelayedController,
    Encoder,
    Measured,
    Pid,
    PositionPid,
    SensedSpring,
    Wanted,
    delay_transfer_function,
    external_torque,
    filtered_rate,
    rotary_encoder,
    start_rate,
    wang_encoders,
)
from varistiff.dynamics.path import Affine, GroovePath

positions = st.floats(-1e3, 1e3)
steps = st.floats(1e-5, 1.0)


@given(position=positions, step=steps)
def test_reading_is_the_nearest_whole_step(position: float, step: float) -> None:
    encoder = Encoder(step)
    reading = float(encoder.read(position))
    rounding = 4.0 * np.spacing(abs(position) + step)
    assert abs(reading - position) <= 0.5 * step + rounding
    count = reading / step
    assert abs(count - round(count)) <= 1e-6 * max(1.0, abs(count))
    assert float(encoder.read(reading)) == pytest.approx(reading, abs=rounding)  # a reading reads itself


@given(low=positions, more=st.floats(0.0, 10.0), step=steps)
def test_reading_never_falls_while_the_position_rises(low: float, more: float, step: float) -> None:
    encoder = Encoder(step)
    assert float(encoder.read(low + more)) >= float(encoder.read(low)) - 4.0 * np.spacing(abs(low) + more + step)


def test_ideal_encoder_passes_the_position() -> None:
    assert float(Encoder().read(0.123456789)) == 0.123456789
    assert rotary_encoder(math.inf).step == 0.0


@pytest.mark.parametrize("step", [0.0, 0.01])
def test_derivatives_pass_an_encoder(step: float) -> None:
    assert float(jax.grad(lambda x: Encoder(step).read(x))(0.1234)) == 1.0


def test_rotary_encoder_counts_its_own_shaft() -> None:
    assert rotary_encoder(4096).step == pytest.approx(2.0 * math.pi / 4096, rel=1e-15)
    # behind a belt of 60:18 teeth one turn of the disc is 60/18 turns of the encoder
    assert rotary_encoder(1000, ratio=60.0 / 18.0).step == pytest.approx(2.0 * math.pi * 18.0 / 60000.0, rel=1e-15)


def test_encoders_of_the_joint() -> None:
    link, drive, motion = wang_encoders(
        link_counts=8192, drive_counts=2000, setting_counts=1024, belt_ratio=2.5, reducer_ratio=100.0
    )
    turns = [2.0 * math.pi / encoder.step for encoder in (link, drive, motion)]
    assert turns == pytest.approx([8192.0, 5000.0, 102400.0], rel=1e-14)


@pytest.mark.parametrize("arguments", [{"link_counts": 0.0}, {"belt_ratio": -1.0}, {"reducer_ratio": math.inf}])
def test_encoders_without_sense_are_refused(arguments: dict[str, float]) -> None:
    with pytest.raises(InputError, match=r"must be (above 0|a finite number)"):
        wang_encoders(**arguments)
    with pytest.raises(InputError, match="step: must be at least 0"):
        Encoder(-0.1)


def test_filtered_rate_of_a_step_decays_geometrically() -> None:
    period, filter_time = 0.01, 0.04
    memory = start_rate(2.0)
    for count in range(12):
        memory = filtered_rate(memory, 2.5, period, filter_time)
        expected = 0.5 / (filter_time + period) * (filter_time / (filter_time + period)) ** count
        assert float(memory.rate) == pytest.approx(expected, rel=1e-13)  # rounding


def test_filtered_rate_of_a_ramp_is_its_slope() -> None:
    memory = start_rate(0.0)
    for count in range(1, 400):
        memory = filtered_rate(memory, 0.03 * count, 0.01, 0.04)
    assert float(memory.rate) == pytest.approx(3.0, rel=1e-12)  # 0.8^400 is gone


@pytest.mark.parametrize("samples", [0, 1, 4])
def test_delay_is_a_queue(samples: int) -> None:
    delay = Delay(samples)
    memory, out = delay.start(-7.0), []
    for value in range(10):
        leaves, memory = delay.sample(memory, float(value))
        out.append(float(leaves))
    assert out == [-7.0] * samples + [float(value) for value in range(10 - samples)]


def test_delay_carries_whole_readings() -> None:
    delay = Delay(2)
    memory = delay.start(Measured(0.0, 0.0, 0.0))
    for value in (1.0, 2.0, 3.0):
        leaves, memory = delay.sample(memory, Measured(value, 10.0 * value, 100.0 * value))
    assert [float(number) for number in leaves] == [1.0, 10.0, 100.0]


@pytest.mark.parametrize("samples", [-1, 1.5, True])
def test_delay_wants_whole_samples(samples: Any) -> None:
    with pytest.raises(InputError, match="samples: must be a whole number of at least 0"):
        Delay(samples)


def test_delayed_controller_says_the_same_later() -> None:
    inside = PositionPid(Pid(proportional=3.0, integral=2.0, derivative=0.1))
    late = DelayedController(inside, Delay(3), command=0.25)
    measured = [Measured(math.sin(0.3 * n), 0.0, 0.0) for n in range(12)]
    wanted = Wanted(position=0.5)
    commands: list[list[float]] = [[], []]
    for row, controller in zip(commands, (inside, late), strict=True):
        memory = controller.start(measured[0], wanted)
        for reading in measured:
            command, memory = controller.sample(memory, reading, wanted, 0.01)
            row.append(float(command))
    assert commands[1] == [0.25] * 3 + commands[0][:-3]


def test_delay_has_its_phase() -> None:
    delay = 0.01
    for omega in (10.0, 100.0, 300.0):
        answer = delay_transfer_function(delay, order=4)(1j * omega)
        # the first term that Pade's 4/4 leaves out: 4!^2/(8! 9!) (w T)^9
        left_out = 24.0**2 / (math.factorial(8) * math.factorial(9)) * (omega * delay) ** 9
        assert abs(answer - np.exp(-1j * omega * delay)) <= 1.1 * left_out + 1e-12
    assert delay_transfer_function(0.0)(1j) == 1.0
    with pytest.raises(InputError, match="delay"):
        delay_transfer_function(-1.0)
    with pytest.raises(InputError, match="order"):
        delay_transfer_function(0.1, order=0)


def test_standing_joint_tells_the_torque_on_it(wang_joint: SliderLeafJoint) -> None:
    spring = SensedSpring(wang_joint, GroovePath(wang_joint.groove), setting_min=0.006, setting_max=0.025)
    angle, length = math.radians(30.0), 0.0
    length = float(wang_joint.groove.active_length(jnp.asarray(angle)))
    told = external_torque(spring, Measured(link=0.300, drive=0.321, motion=angle))
    # Eq. (7): N E b h^3 l_2^2 sin(phi)/(4 l_1^3)
    expected = 206e9 * 0.025 * 1e-9 * (0.025 + length) ** 2 * math.sin(0.021) / (4.0 * length**3)
    assert float(told) == pytest.approx(expected, rel=1e-12)  # rounding
    assert float(told) > 0.0


def test_moving_link_needs_its_inertia_and_damping() -> None:
    spring, inertia, damping, amplitude, omega = SeriesElastic(stiffness=160.0), 0.4, 0.7, 0.2, 9.0
    sensed = SensedSpring(spring)
    for time in (0.05, 0.2, 0.31):
        q, rate = amplitude * math.sin(omega * time), amplitude * omega * math.cos(omega * time)
        acceleration, outside = -(omega**2) * q, 3.0 * math.cos(4.0 * time)
        # a drive that moves just so: J q'' + D q' + weight + tau_ext = k (q_1 - q)
        weight = 1.3 * math.sin(q)
        drive = q + (inertia * acceleration + damping * rate + weight + outside) / 160.0
        told = external_torque(
            sensed,
            Measured(q, drive, 0.0),
            inertia=inertia,
            acceleration=acceleration,
            damping=damping,
            rate=rate,
            gravity=weight,
        )
        assert float(told) == pytest.approx(outside, rel=1e-12, abs=1e-12)  # rounding


def test_semi_active_joint_feels_the_load_the_other_way(knee: RollerBeam) -> None:
    spring = SensedSpring(knee, Affine(), setting_min=0.2, setting_max=0.6, driven=False)
    measured = Measured(link=math.radians(8.0), drive=0.0, motion=0.3)
    load = float(knee.respond(jnp.asarray(math.radians(8.0)), jnp.asarray(0.3))[0].load)
    assert float(external_torque(spring, measured)) == -load < 0.0


@given(drive=st.floats(-0.2, 0.2), link=st.floats(-0.2, 0.2))
def test_torque_of_coarse_encoders_is_off_by_at_most_one_step_of_stiffness(drive: float, link: float) -> None:
    spring, encoder = SensedSpring(SeriesElastic(stiffness=160.0)), rotary_encoder(4096)
    told = external_torque(spring, Measured(encoder.read(link), encoder.read(drive), 0.0))
    assert abs(float(told) - 160.0 * (drive - link)) <= 160.0 * encoder.step * (1.0 + 1e-9)


def test_adjusting_torque_is_power_balanced(wang_joint: SliderLeafJoint) -> None:
    path = GroovePath(wang_joint.groove)
    spring = SensedSpring(wang_joint, path, setting_min=0.006, setting_max=0.025)

    def energy(motion: Any) -> Any:
        return wang_joint.energy(jnp.asarray(0.02), path.at(motion).value)

    measured = Measured(link=0.1, drive=0.12, motion=0.4)
    slope = (energy(jnp.asarray(0.4 + 1e-5)) - energy(jnp.asarray(0.4 - 1e-5))) / 2e-5
    assert float(spring.adjusting_torque(measured)) == pytest.approx(float(slope), rel=1e-8)  # differences of size^2


def test_readings_beyond_the_settings_are_held(wang_joint: SliderLeafJoint) -> None:
    spring = SensedSpring(wang_joint, Affine(), setting_min=0.006, setting_max=0.025)
    assert float(spring.setting(Measured(0.0, 0.0, 0.0059))) == 0.006
    assert float(spring.setting(Measured(0.0, 0.0, 0.0251))) == 0.025
    # derivatives pass at the ends themselves, and only there and inside
    slope = jax.vmap(jax.grad(lambda motion: spring.setting(Measured(0.0, 0.0, motion))))
    assert slope(jnp.array([0.0059, 0.006, 0.02, 0.025, 0.0251])).tolist() == [0.0, 1.0, 1.0, 1.0, 0.0]
    with pytest.raises(InputError, match=r"setting: the lower end 0\.3 must lie below the upper end 0\.2"):
        SensedSpring(wang_joint, Affine(), setting_min=0.3, setting_max=0.2)
