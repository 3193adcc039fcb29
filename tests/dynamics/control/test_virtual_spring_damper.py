"""The semi-active knee: the setting renders the wanted torque where it can."""

from __future__ import annotations

import math
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.actuators import RollerBeam
from varistiff.actuators.compiled import respond_block
from varistiff.core.errors import InputError
from varistiff.dynamics.control import Measured, Pid, SensedSpring, VirtualSpringDamper, Wanted, virtual_spring_damper
from varistiff.dynamics.path import Affine

PULLEY = Affine(ratio=0.012)  # the belt's pulley: 12 mm of shuttle travel per radian


@pytest.fixture(scope="module")
def controller(knee: RollerBeam) -> VirtualSpringDamper:
    spring = SensedSpring(knee, PULLEY, setting_min=0.2, setting_max=0.6, driven=False)
    made = virtual_spring_damper(
        spring,
        Pid(proportional=7.0),
        deflection_max=math.radians(10.0),
        stiffness=30.0,
        damping=2.0,
        dead_band=math.radians(0.05),
    )
    # as arrays: one compilation serves all numbers
    return jax.tree.map(lambda leaf: jnp.asarray(leaf) if isinstance(leaf, float) else leaf, made)


SAMPLE = eqx.filter_jit(
    lambda controller, memory, measured, wanted: controller.sample(memory, measured, wanted, jnp.asarray(1e-3))
)
RENDERED = eqx.filter_jit(lambda controller, measured, wanted, rate: controller.rendered(measured, wanted, rate))


def numbers(*values: float) -> tuple[Any, ...]:
    return tuple(jnp.asarray(value) for value in values)


def load_at(knee: RollerBeam, angle: float, setting: float) -> float:
    return float(respond_block(knee, np.array([angle]), np.array([setting]))[0].load[0])


def sampled(controller: VirtualSpringDamper, link: float, wanted: Wanted, before: float | None = None) -> Any:
    setting = 0.3
    start = Measured(*numbers(link if before is None else before, 0.0, setting / 0.012))
    measured = Measured(*numbers(link, 0.0, setting / 0.012))
    wanted = Wanted(*numbers(*wanted))
    return SAMPLE(controller, controller.start(start, wanted), measured, wanted)


@pytest.mark.parametrize("link", [0.12, -0.12])
def test_chosen_setting_gives_the_wanted_torque(knee: RollerBeam, controller: VirtualSpringDamper, link: float) -> None:
    # tau = K_v (q_w - q) + D_v (q_w' - q'), a pull back to 0, between what 0.6 m and 0.2 m of beam can do
    rate, target = 0.003 / 1e-3 * math.copysign(1.0, link), Wanted(position=-0.8 * link, position_rate=0.4)
    torque = 30.0 * (-0.8 * link - link) + 2.0 * (0.4 - rate)
    assert -load_at(knee, abs(link), 0.2) < -abs(torque) < -load_at(knee, abs(link), 0.6)
    _, memory = sampled(controller, link, target, before=link - 1e-3 * rate)
    assert load_at(knee, link, float(memory.setting)) == pytest.approx(-torque, rel=1e-9)  # the solvers of both
    got = RENDERED(controller, Measured(*numbers(link, 0.0, 25.0)), Wanted(*numbers(*target)), jnp.asarray(rate))
    assert float(got) == pytest.approx(torque, rel=1e-9)


def test_servo_goes_to_the_pulley_s_angle(knee: RollerBeam, controller: VirtualSpringDamper) -> None:
    link = 0.12
    command, memory = sampled(controller, link, Wanted(position=-0.7 * link))
    response = respond_block(knee, np.array([link]), np.array([0.3]))[0]
    adjusting = float(response.adjusting_load[0]) * 0.012
    expected = 7.0 * (float(memory.setting) - 0.3) / 0.012 + adjusting
    assert float(command) == pytest.approx(expected, rel=1e-9)
    assert adjusting != 0.0


def test_torque_that_no_spring_gives_gets_the_nearest_end(controller: VirtualSpringDamper) -> None:
    for link in (0.12, -0.12):
        pushing = Wanted(position=2.0 * link)  # away from rest: the softest beam
        assert float(sampled(controller, link, pushing)[1].setting) == 0.6
        hard = Wanted(torque=-math.copysign(1e4, link))
        assert float(sampled(controller, link, hard)[1].setting) == 0.2


def test_wanted_torque_alone_is_followed(knee: RollerBeam, controller: VirtualSpringDamper) -> None:
    follower = eqx.tree_at(lambda c: (c.stiffness, c.damping), controller, numbers(0.0, 0.0))
    torque = -load_at(knee, 0.1, 0.45)
    _, memory = sampled(follower, 0.1, Wanted(torque=torque))
    assert float(memory.setting) == pytest.approx(0.45, rel=1e-9)


def test_dead_band_keeps_the_setting(controller: VirtualSpringDamper) -> None:
    _, memory = sampled(controller, math.radians(0.04), Wanted(torque=-1e4))
    assert float(memory.setting) == pytest.approx(0.3, rel=1e-14)


def test_what_it_cannot_do_is_refused(knee: RollerBeam) -> None:
    driven = SensedSpring(knee, PULLEY, setting_min=0.2, setting_max=0.6)
    semi_active = SensedSpring(knee, PULLEY, setting_min=0.2, setting_max=0.6, driven=False)
    limits = {"deflection_max": 0.1, "dead_band": 0.001}
    with pytest.raises(InputError, match="no virtual spring-damper"):
        virtual_spring_damper(driven, Pid(1.0), **limits)
    with pytest.raises(InputError, match="dead_band: must be above 0"):
        virtual_spring_damper(semi_active, Pid(1.0), deflection_max=0.1, dead_band=0.0)
    with pytest.raises(InputError, match="no deflection in use lies beyond the dead band"):
        virtual_spring_damper(semi_active, Pid(1.0), deflection_max=0.001, dead_band=0.01)
    with pytest.raises(InputError, match="damping: must be at least 0"):
        virtual_spring_damper(semi_active, Pid(1.0), damping=-1.0, **limits)


def test_load_that_turns_back_over_the_settings_is_refused(knee: RollerBeam) -> None:
    from varistiff.actuators import SwivellingPair

    loose = eqx.tree_at(lambda beam: beam.rollers, knee, SwivellingPair(offset=0.0, clearance=0.0005))
    # below c/x_r there is no contact, and the moment has its maximum near 2 c/x_r: 0.14 degrees at 0.4 m
    spring = SensedSpring(loose, PULLEY, setting_min=0.2, setting_max=0.6, driven=False)
    with pytest.raises(InputError, match=r"the load at a deflection of 0\.001 rad must rise or fall"):
        virtual_spring_damper(spring, Pid(1.0), deflection_max=0.1, dead_band=0.001)
    assert virtual_spring_damper(spring, Pid(1.0), deflection_max=0.1, dead_band=0.02).dead_band == 0.02
