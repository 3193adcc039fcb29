"""Poles of sampled loops against python-control and against runs."""

from __future__ import annotations

import math

import control
import jax
import numpy as np
import pytest

from varistiff.dynamics.control import (
    Delay,
    DelayedController,
    Encoder,
    Pid,
    PositionPid,
    SensedSpring,
    SettingHold,
    TorqueControl,
)
from varistiff.dynamics.control_loop import Channel, ControlLoop
from varistiff.dynamics.drives import TorqueSource
from varistiff.dynamics.friction import DryFriction, Friction
from varistiff.dynamics.linear import closed_loop, closed_loop_poles
from varistiff.dynamics.plant import Member
from varistiff.dynamics.program import run_one

from .joints import (
    DRIVE,
    LINK,
    PERIOD,
    SCREW,
    SPRING_RATE,
    STIFFNESS,
    case,
    maccepa,
    maccepa_stiffness,
    moving,
    two_mass,
)

D, D_1 = 0.6, 0.3
SMOOTH = two_mass(link_damping=D, drive_damping=D_1)
CLOSE = 1e-7  # six poles within 0.3 of each other: the polynomials that they are compared with lose so many digits


def plant_transfer(period: float, output: str, stiffness: float) -> control.TransferFunction:
    """From the drive's torque to a position, sampled with a zero-order hold; written down here once more."""
    link = [LINK, D, stiffness]
    common = np.polysub(np.polymul(link, [DRIVE, D_1, stiffness]), [stiffness**2])
    numerator = link if output == "drive" else [stiffness]
    return control.c2d(control.tf(numerator, common), period, "zoh")


def pid_transfer(pid: Pid, period: float) -> control.TransferFunction:
    """k_p + k_i T/(z - 1) + k_d (z - 1)/((T_f + T) z - T_f)."""
    z = control.tf([1.0, 0.0], [1.0], period)
    derivative = pid.derivative * (z - 1) / ((pid.filter_time + period) * z - pid.filter_time)
    total = control.tf([pid.proportional], [1.0], period) + derivative
    return total + pid.integral * period / (z - 1) if pid.integral else total


def expected_poles(pid: Pid, period: float, output: str, *, delay: int = 0, stiffness: float = STIFFNESS) -> np.ndarray:
    late = control.tf([1.0], [1.0] + [0.0] * delay, period)
    around = plant_transfer(period, output, stiffness) * pid_transfer(pid, period) * late
    numerator, denominator = around.num[0][0], around.den[0][0]
    return np.roots(np.polyadd(numerator, denominator))


def assert_same_poles(found: np.ndarray, expected: np.ndarray, tolerance: float = CLOSE) -> None:
    """Every pole has its partner; poles at 0 may be left out or doubled by a delay's bookkeeping."""
    found, expected = (poles[np.abs(poles) > 1e-4] for poles in (found, np.asarray(expected, complex)))
    assert found.size == expected.size
    for pole in expected:
        assert np.abs(found - pole).min() < tolerance


def loop(pid: Pid, *, feedback: str = "drive", **changes: object) -> ControlLoop:
    return ControlLoop(**{"drive": Channel(PositionPid(pid, feedback)), **changes})


P = Pid(40.0)
PD = Pid(60.0, derivative=1.5, filter_time=0.004)
PID = Pid(60.0, integral=300.0, derivative=1.5, filter_time=0.004)


@pytest.mark.parametrize("pid", [P, PD, PID], ids=["P", "PD", "PID"])
@pytest.mark.parametrize("feedback", ["drive", "link"])
def test_poles_are_those_of_the_sampled_feedback(pid: Pid, feedback: str) -> None:
    found = closed_loop(case(SMOOTH, loop=loop(pid, feedback=feedback)))
    assert found.interval == PERIOD
    assert_same_poles(found.poles, expected_poles(pid, PERIOD, feedback))


@pytest.mark.parametrize("delay", [1, 3])
def test_a_delay_counts(delay: int) -> None:
    expected = expected_poles(PD, PERIOD, "drive", delay=delay)
    readings = closed_loop_poles(case(SMOOTH, loop=loop(PD, delay=delay)))
    commands = DelayedController(PositionPid(PD, "drive"), Delay(delay))
    sent = closed_loop_poles(case(SMOOTH, loop=ControlLoop(drive=Channel(commands))))
    # poles near 0 of a delay come in clusters of the order delay + 1: the bound above which they are compared holds
    assert_same_poles(readings[np.abs(readings) > 0.05], expected[np.abs(expected) > 0.05])
    assert_same_poles(sent[np.abs(sent) > 0.05], expected[np.abs(expected) > 0.05])


def test_a_controller_that_is_sampled_less_often() -> None:
    found = closed_loop(case(SMOOTH, loop=ControlLoop(drive=Channel(PositionPid(PD, "drive"), every=4))))
    assert found.interval == pytest.approx(4 * PERIOD)
    assert_same_poles(found.poles, expected_poles(PD, 4 * PERIOD, "drive"))


def test_two_rates_at_once() -> None:
    """At rest the pretension of a MACCEPA does not couple with the deflection: two loops side by side."""
    plant = maccepa(drive=Member(DRIVE, Friction(D_1)), link=Member(LINK, Friction(D)))
    start = moving(motion=2.0)
    servo = Pid(0.2, derivative=0.004, filter_time=0.01)
    hold = Channel(SettingHold(servo, 2.0), every=3)
    both = ControlLoop(drive=Channel(PositionPid(PD, "drive"), every=2), setting=hold)
    found = closed_loop(case(plant, start, loop=both))
    assert found.interval == pytest.approx(6 * PERIOD)
    screw = control.c2d(control.tf([1.0], [2e-4, 0.0, SPRING_RATE * SCREW**2]), 3 * PERIOD, "zoh")
    around = screw * pid_transfer(servo, 3 * PERIOD)
    setting = np.roots(np.polyadd(around.num[0][0], around.den[0][0]))
    drive = expected_poles(PD, 2 * PERIOD, "drive", stiffness=maccepa_stiffness(0.002 + SCREW * 2.0))
    assert_same_poles(found.poles, np.concatenate([setting**2, drive**3]))


def test_without_control_the_poles_are_the_plants() -> None:
    plant = two_mass(link_damping=D, drive_damping=D_1, weight=30.0)
    denominator = np.polysub(np.polymul([LINK, D, STIFFNESS + 30.0], [DRIVE, D_1, STIFFNESS]), [STIFFNESS**2])
    found = closed_loop(case(plant))
    assert_same_poles(found.poles, np.exp(np.roots(denominator) * PERIOD))
    slowest = np.roots(denominator).real.max()
    assert found.growth_rate == pytest.approx(slowest, rel=1e-6)  # log|z| loses six digits to the 1 in z
    assert not found.unstable


def test_what_nothing_holds_is_not_unstable() -> None:
    found = closed_loop(case(two_mass()))
    assert np.abs(found.poles).max() == pytest.approx(1.0, abs=1e-6)  # a double pole at 1
    assert not found.unstable


def test_nothing_free_has_no_poles() -> None:
    plant = two_mass(link=Member(LINK, mode="locked"), drive=Member(DRIVE, mode="locked"))
    found = closed_loop(case(plant))
    assert found.poles.size == 0
    assert found.growth_rate == -math.inf
    assert not found.unstable


def test_an_unused_integral_part_is_no_pole() -> None:
    assert closed_loop_poles(case(SMOOTH, loop=loop(P))).size == 4  # of the plant alone


def test_coarse_encoders_do_not_open_the_loop() -> None:
    coarse = Encoder(1e-2)
    ideal = closed_loop_poles(case(SMOOTH, moving(0.123, 0.123), loop=loop(PD)))
    found = closed_loop_poles(case(SMOOTH, moving(0.123, 0.123), loop=loop(PD, encoders=(coarse,) * 3)))
    np.testing.assert_allclose(found, ideal, rtol=1e-12)


def test_a_limit_that_binds_at_rest_does_not_open_the_loop() -> None:
    """The feedforward of a loaded torque loop alone exceeds the limit."""
    spring = SensedSpring(SMOOTH.actuator)

    def poles(limit: float) -> np.ndarray:
        torque = TorqueControl(Pid(1.5, derivative=0.01, filter_time=0.004, limit=limit), spring)
        return closed_loop_poles(case(SMOOTH, load=4.0, loop=ControlLoop(drive=Channel(torque))))

    np.testing.assert_allclose(poles(1.0), poles(math.inf), rtol=1e-12)


def test_dry_friction_and_a_limited_drive_do_not_hide_an_unstable_loop() -> None:
    wild = loop(Pid(4000.0))
    rubbing = two_mass(
        link_damping=D,
        drive=Member(DRIVE, Friction(D_1, DryFriction(coulomb=2.0))),
        drive_motor=TorqueSource(limit=1.0),
    )
    smooth = closed_loop(case(SMOOTH, loop=wild))
    assert smooth.unstable
    np.testing.assert_allclose(closed_loop(case(rubbing, loop=wild)).poles, smooth.poles, rtol=1e-12)


@pytest.mark.parametrize("pid", [Pid(150.0, filter_time=0.004), PD], ids=["growing", "decaying"])
def test_growth_rate_is_that_of_a_run(pid: Pid) -> None:
    """A linear joint released from a deflection: after the transients only the slowest pair is left."""
    joint = case(SMOOTH, moving(link=1e-6, drive=0.0), loop=loop(pid, feedback="link", delay=2))
    found = closed_loop(joint)
    assert found.unstable == (found.growth_rate > 0.0)
    rows = jax.tree.map(np.asarray, run_one(joint, duration=3.0, substeps=2))
    link = rows.state.motion.link
    # x_(k+1) = 2 Re(z) x_k - |z|^2 x_(k-1) of one pair z, by least squares over the tail
    tail = link[-400:]
    (twice, minus), *_ = np.linalg.lstsq(np.stack([tail[1:-1], tail[:-2]]).T, tail[2:], rcond=None)
    assert math.sqrt(-minus) == pytest.approx(abs(found.poles[0]), rel=1e-5)  # what the faster poles have left behind
    assert twice == pytest.approx(2.0 * found.poles[0].real, rel=1e-5)
