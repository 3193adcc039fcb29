"""The fastest rate of a plant against closed forms, and against what the stepper survives."""

from __future__ import annotations

import dataclasses
import math

import jax
import numpy as np
import pytest

from varistiff.actuators import RollerBeam, SwivellingPair
from varistiff.dynamics.control_loop import ControlLoop, Inputs
from varistiff.dynamics.drives import Motor
from varistiff.dynamics.friction import DryFriction, Friction
from varistiff.dynamics.linear import fastest_rate
from varistiff.dynamics.plant import Member, Plant
from varistiff.dynamics.program import Case, run_one
from varistiff.dynamics.signals import Sine
from varistiff.dynamics.state import Motion
from varistiff.dynamics.stop import Stop
from varistiff.elastic.leaf import Leaf

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

TIGHT = 1e-9  # exact derivatives, rounding of eigenvalues


def swing(stiffness: float) -> float:
    return math.sqrt(stiffness * (1.0 / LINK + 1.0 / DRIVE))


def test_two_masses() -> None:
    assert fastest_rate(case(two_mass())) == pytest.approx(swing(STIFFNESS), rel=TIGHT)


def test_dry_friction_is_fastest_at_rest() -> None:
    rub = DryFriction(coulomb=1.5, breakaway=2.0, smoothing_rate=1e-3)
    plant = two_mass(drive=Member(DRIVE, Friction(dry=rub)))
    start = moving(rates=(0.0, 3.0, 0.0))  # the start itself slides
    # S/(v_0 J_1) = 8e4/s, the spring changes it by K/J_1 over that: 1e-6 of it
    assert fastest_rate(case(plant, start)) == pytest.approx(2.0 / 1e-3 / DRIVE, rel=2e-6)


def test_stops_count_though_nothing_touches_them() -> None:
    stop = Stop(lower=-1.0, upper=1.0, stiffness=9e4)
    plant = two_mass(link=Member(LINK, stop=stop), drive=Member(DRIVE, mode="locked"))
    assert fastest_rate(case(plant)) == pytest.approx(math.sqrt((STIFFNESS + 9e4) / LINK), rel=TIGHT)
    assert fastest_rate(case(plant), stops=False) == pytest.approx(math.sqrt(STIFFNESS / LINK), rel=TIGHT)


def test_the_stiffest_setting_within_its_travel_counts() -> None:
    travel = Stop(lower=1.0, upper=7.0)
    plant = maccepa(setting=Member(1e9, stop=travel))  # a screw too heavy to move
    ladder = [maccepa_stiffness(0.002 + SCREW * 2.0, deflection) for deflection in (0.01, 0.03, 0.1, 0.3)]
    expected = swing(max(*ladder, maccepa_stiffness(0.002 + SCREW * 7.0)))
    # the travel is looked at from just inside its ends, 1e-9 of it
    assert fastest_rate(case(plant, moving(motion=2.0)), stops=False) == pytest.approx(expected, rel=1e-7)
    assert expected == swing(maccepa_stiffness(0.002 + SCREW * 7.0))


def test_ends_of_the_travel_are_looked_at_without_their_stops() -> None:
    travel = Stop(lower=1.0, upper=7.0, stiffness=900.0)
    plant = maccepa(
        setting=Member(2e-4, stop=travel), link=Member(LINK, mode="locked"), drive=Member(DRIVE, mode="locked")
    )
    wound = math.sqrt(SPRING_RATE * SCREW**2 / 2e-4)  # the spring pulls the screw back
    assert fastest_rate(case(plant, moving(motion=2.0)), stops=False) == pytest.approx(wound, rel=TIGHT)
    pressed = math.sqrt((SPRING_RATE * SCREW**2 + 900.0) / 2e-4)
    assert fastest_rate(case(plant, moving(motion=2.0))) == pytest.approx(pressed, rel=TIGHT)


def test_a_shorted_motor_brakes() -> None:
    motor = Motor(torque_constant=0.05, resistance=0.2, rotor_inertia=1e-7, gear_ratio=60.0, voltage_limit=24.0)
    plant = two_mass(drive_motor=motor, link=Member(LINK, mode="locked"))
    inertia = DRIVE + 60.0**2 * 1e-7
    brake = 60.0**2 * 0.05**2 / 0.2  # n^2 k^2/R
    rate = max(abs(np.roots([inertia, brake, STIFFNESS])))
    assert fastest_rate(case(plant)) == pytest.approx(rate, rel=TIGHT)
    assert rate > 1.2 * math.sqrt(STIFFNESS / inertia)


def test_gear_losses_at_the_largest_torque_count() -> None:
    motor = Motor(
        torque_constant=0.05,
        resistance=1e-6,  # braking by the back-EMF would be faster: kept out by the voltage
        rotor_inertia=1e-7,
        gear_ratio=60.0,
        gear_efficiency=0.5,
        current_limit=10.0,
        smoothing_rate=0.01,
    )
    plant = two_mass(drive_motor=motor, link=Member(LINK, mode="locked"))
    # at least half the mean share (0.5 + 1)/2 of k i, smoothed over 0.01 rad/s of the rotor
    least = 60.0**2 * 0.05 * 10.0 * 0.75 / 0.01 / (DRIVE + 60.0**2 * 1e-7)
    assert fastest_rate(case(plant)) >= 0.99 * least


def test_an_element_that_is_free_at_rest_bears_later() -> None:
    beam = Leaf(youngs_modulus=194e9, width=0.025, thickness=0.003, length=0.9)
    plant = Plant(RollerBeam(beam, SwivellingPair(0.0, 2e-4)), link=Member(0.4), driven=False)
    rigidity = 194e9 * 0.025 * 0.003**3 / 12.0
    # at least the small-angle stiffness 3 E I/x in contact
    assert fastest_rate(case(plant, moving(motion=0.3))) > 0.99 * math.sqrt(3.0 * rigidity / 0.3 / 0.4)


def test_the_spring_beyond_the_play_counts() -> None:
    assert fastest_rate(case(two_mass(backlash=0.02))) == pytest.approx(swing(STIFFNESS), rel=TIGHT)


def test_where_a_run_has_been_counts() -> None:
    plant = maccepa(setting=Member(1e9))
    start = case(plant, moving(motion=1.0))
    rows = np.linspace(1.0, 7.0, 200)
    still = np.zeros_like(rows)
    visited = Motion(still, still, still, still, rows, still)
    # its cable can hang slack, so deflections up to 0.3 rad are looked at too
    ladder = [maccepa_stiffness(0.002 + SCREW, deflection) for deflection in (0.0, 0.01, 0.03, 0.1, 0.3)]
    assert fastest_rate(start) == pytest.approx(swing(max(ladder)), rel=TIGHT)
    after = swing(maccepa_stiffness(0.002 + SCREW * 7.0))
    assert fastest_rate(start, visited=visited) == pytest.approx(after, rel=TIGHT)


def test_a_prescribed_link_is_followed() -> None:
    """The beam gets stiffer for the shuttle as the link bends it: V_xx grows with the angle squared."""
    beam = Leaf(youngs_modulus=194e9, width=0.025, thickness=0.003, length=0.9)
    plant = Plant(
        RollerBeam(beam, SwivellingPair(0.0, 0.0)),
        link=Member(0.4, mode="prescribed"),
        setting=Member(1.0),
        driven=False,
    )
    motion = Sine(offset=0.0, amplitude=0.8, frequency=1.0)
    walk = Case(plant, ControlLoop(), Inputs(link=motion), moving(motion=0.4), PERIOD)
    assert fastest_rate(walk, duration=1.0) > 1.5 * fastest_rate(walk)


def test_nothing_free_has_no_rate() -> None:
    plant = two_mass(link=Member(LINK, mode="locked"), drive=Member(DRIVE, mode="locked"))
    assert fastest_rate(case(plant)) == 0.0


def test_a_start_off_the_map_has_no_rate() -> None:
    beam = Leaf(youngs_modulus=194e9, width=0.025, thickness=0.003, length=0.9)
    plant = Plant(RollerBeam(beam, SwivellingPair(0.0, 0.0)), link=Member(0.4), driven=False)
    assert fastest_rate(case(plant, moving(motion=-0.3))) == 0.0


@pytest.mark.parametrize(("product", "survives"), [(2.7, True), (2.95, False)])
def test_the_stepper_is_stable_up_to_its_bound(product: float, survives: bool) -> None:
    """The classical method damps an undamped swing up to 2 sqrt(2) = 2.83 and blows it up beyond."""
    joint = case(two_mass(), moving(link=0.1, drive=0.0))
    quick = dataclasses.replace(joint, period=product / fastest_rate(joint))
    rows = jax.tree.map(np.asarray, run_one(quick, duration=400 * quick.period, substeps=1))
    swings = np.abs(rows.state.motion.drive - rows.state.motion.link)
    assert (swings[-1] < 0.1) == survives
