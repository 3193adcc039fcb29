"""The regenerative knee: the roller's course, its control, and the energy of a step."""

from __future__ import annotations

import math
from pathlib import Path

import jax.numpy as jnp
import numpy as np
import pytest

import varistiff
from varistiff.actuators.roller_beam import RollerBeam
from varistiff.actuators.rollers import SwivellingPair
from varistiff.characteristic.evaluate import evaluate
from varistiff.core.errors import InputError
from varistiff.dynamics.carried_mass import CarriedMass
from varistiff.dynamics.control import Pid, SensedSpring
from varistiff.dynamics.control.setting_schedule import SettingSchedule
from varistiff.dynamics.control_loop import Channel, ControlLoop, Inputs
from varistiff.dynamics.cycle_energy import CycleEnergy, cycle_energy
from varistiff.dynamics.drives import Motor, motor
from varistiff.dynamics.friction import Friction
from varistiff.dynamics.gait import KneeGait, knee_gait
from varistiff.dynamics.gait.direct_drive import direct_drive
from varistiff.dynamics.gait.knee_trajectory import knee_trajectory
from varistiff.dynamics.gait.roller_plan import Shuttle, roller_plan
from varistiff.dynamics.path import Affine
from varistiff.dynamics.plant import Member, Plant
from varistiff.dynamics.program import Case
from varistiff.dynamics.signals import Samples
from varistiff.dynamics.simulate import Run, simulate
from varistiff.dynamics.state import Motion
from varistiff.dynamics.storage import Supercapacitor
from varistiff.elastic.leaf import Leaf

SCENARIOS = Path(__file__).parents[2] / "examples" / "scenarios"
PULLEY = 0.007  # m
TRAVEL = {"setting_min": 0.06, "setting_max": 0.4}
BODY_MASS = 80.0


def _course() -> Samples:
    """The shipped course of the roller."""
    time, setting = np.loadtxt(SCENARIOS / "knee_roller.csv", delimiter=",", skiprows=1, unpack=True)
    time[-1] = knee_gait().cycle_duration
    return Samples.through(list(time), list(1e-3 * setting), periodic=True)


def _motor(ratio: float) -> Motor:
    return motor("maxon_ec_4pole_30_200w_36v", gear_ratio=ratio, gear_efficiency=0.95, current_limit=20.0)


@pytest.fixture(scope="module")
def beam() -> RollerBeam:
    actuator = varistiff.load(SCENARIOS / "knee_beam.yaml").actuator
    assert isinstance(actuator, RollerBeam)
    return actuator


@pytest.fixture(scope="module")
def walk(beam: RollerBeam) -> Run:
    """Two steps of the shipped design on the shipped course."""
    path, course = Affine(ratio=PULLEY), _course()
    plant = Plant(
        beam,
        Member(0.4, mode="prescribed"),
        setting=Member(0.0, Friction(2e-5)),
        setting_path=path,
        carried=CarriedMass(0.25, path, body="link"),
        setting_motor=_motor(6.3),  # turns of the rotor per turn of the pulley
        storage=Supercapacitor(capacitance=10.0, voltage=36.0, series_resistance=0.05, converter_efficiency=0.97),
        driven=False,
    )
    start = course.at(jnp.asarray(0.0))
    at_rest = Motion(0.0, 0.0, 0.0, 0.0, float(start.value) / PULLEY, float(start.rate) / PULLEY)
    inertia = float(plant.inertias(at_rest).setting)
    servo = SettingSchedule(
        Pid(4.0, derivative=0.04, filter_time=2e-3, derivative_on="error"),
        course,
        SensedSpring(beam, path, 0.06, 0.4, driven=False),
        inertia,
    )
    case = Case(plant, ControlLoop(setting=Channel(servo)), Inputs(link=knee_gait().angle), at_rest, 1.1e-3)
    return simulate(case, duration=2072 * 1.1e-3)


@pytest.fixture(scope="module")
def step(walk: Run) -> CycleEnergy:
    duration = knee_gait().cycle_duration
    return cycle_energy(walk, start=duration, duration=duration)


def _light_beam(rigidity: float) -> RollerBeam:
    """No offset and no clearance: linear theory holds for small angles, M = 3 E I q/x."""
    leaf = Leaf(youngs_modulus=12.0 * rigidity, width=1.0, thickness=1.0)
    return RollerBeam(leaf, SwivellingPair(offset=0.0, clearance=0.0))


def _small_gait(angle: float, moment: float) -> KneeGait:
    """A knee that swings by a small angle about twice that angle, with a constant moment per body mass."""
    times = np.linspace(0.0, 1.0, 33)
    angles = angle * (2.0 + np.sin(2.0 * np.pi * times))
    angles[-1] = angles[0]
    flat = [moment] * times.size
    return KneeGait(
        Samples.through(list(times), list(angles), periodic=True),
        Samples.through(list(times), flat, periodic=True),
        1.0,
        1.0,
        "made up",
    )


def test_trajectory_follows_the_linear_cantilever() -> None:
    """x = 3 E I q/M for small angles and no offset."""
    gait = _small_gait(0.004, 0.1)
    found = knee_trajectory(_light_beam(2.0), gait, body_mass=1.0, setting_min=0.1, setting_max=1.0)
    assert found.followed.all()
    exact = 3.0 * 2.0 * found.angle / found.wanted
    # linear theory errs by the square of the angle, 1e-4; the interpolation between 257 settings by 1e-4
    np.testing.assert_allclose(found.setting, exact, rtol=5e-4)


def test_trajectory_says_where_no_setting_will_do() -> None:
    """Beyond the travel the nearer end is taken and masked: too large a moment gets the shortest beam, one of the wrong
    sign the longest."""
    for moment, end in ((10.0, 0.1), (-1.0, 1.0)):
        gait = _small_gait(0.004, moment)
        found = knee_trajectory(_light_beam(2.0), gait, body_mass=1.0, setting_min=0.1, setting_max=1.0)
        assert not found.followed.any()
        assert found.share == 0.0
        np.testing.assert_allclose(found.setting, end, rtol=1e-12)  # an end is a grid point


def test_offset_rollers_follow_more_of_the_cycle(beam: RollerBeam) -> None:
    """A neutral angle that moves with the roller gives both signs of the moment; the same beam in line does not."""
    follow = {
        offset: knee_trajectory(
            RollerBeam(beam.beam, SwivellingPair(offset=offset, clearance=1e-4), mounting_angle=-angle),
            knee_gait(),
            body_mass=BODY_MASS,
            **TRAVEL,
        )
        for offset, angle in ((0.0, math.radians(12.0)), (0.1, math.radians(60.0)))
    }
    assert follow[0.1].share > 2.0 * follow[0.0].share
    assert follow[0.1].error_rms < 0.5 * follow[0.0].error_rms
    inside = follow[0.1].followed
    # a load is interpolated between settings 0.7 % apart: second differences of some N m leave 0.1 N m
    np.testing.assert_allclose(follow[0.1].load[inside], follow[0.1].wanted[inside], atol=0.1)


def test_trajectory_refuses_a_travel_that_is_none(beam: RollerBeam) -> None:
    with pytest.raises(InputError, match="setting_max"):
        knee_trajectory(beam, knee_gait(), body_mass=BODY_MASS, setting_min=0.2, setting_max=0.2)


def test_plan_needs_no_energy_to_hold_still() -> None:
    """A knee that stands, with a moment that one setting gives: the plan finds it, and pays copper only, R (F/(n k))^2.

    The force is dV/dx = 3 E I q^2/(2 x^2) in magnitude.
    """
    angle, rigidity = 0.02, 2.0
    still = Samples.through([0.0, 0.5, 1.0], [angle] * 3, periodic=True)
    wanted = Samples.through([0.0, 0.5, 1.0], [0.3] * 3, periodic=True)
    gait = KneeGait(still, wanted, 1.0, 1.0, "made up")
    ideal = Motor(torque_constant=0.02, resistance=0.2, rotor_inertia=3e-6, gear_ratio=900.0)
    plan = roller_plan(
        _light_beam(rigidity),
        gait,
        Shuttle(ideal, 0.2),
        body_mass=1.0,
        setting_min=0.1,
        setting_max=1.0,
        energy_weight=0.0,
        harmonics=2,
        samples=12,
    )
    place = 3.0 * rigidity * angle / 0.3
    np.testing.assert_allclose(plan.setting, place, rtol=2e-3)  # linear theory errs by q^2, the search stops near 1e-4
    force = 1.5 * rigidity * angle**2 / place**2
    copper = 0.2 * (force / (900.0 * 0.02)) ** 2
    assert plan.copper_energy == pytest.approx(copper, rel=1e-2)  # twice the error of the place, and that of the theory
    assert plan.electrical_energy == pytest.approx(plan.copper_energy, rel=1e-6)


def test_shipped_course_is_what_the_plan_says(beam: RollerBeam) -> None:
    """The file stays in the travel, and below two thirds of the leaf's strength."""
    course = _course()
    time = np.linspace(0.0, knee_gait().cycle_duration, 400)
    place = np.asarray(course.at(jnp.asarray(time)).value)
    assert TRAVEL["setting_min"] <= place.min() < place.max() <= TRAVEL["setting_max"]
    points = evaluate(beam, knee_gait().angle.at(jnp.asarray(time)).value, place)
    assert np.nanmax(points.stress) < 2.0 / 3.0 * beam.beam.yield_strength


def test_audit_closes_over_a_step(walk: Run, step: CycleEnergy) -> None:
    assert walk.outcome.value == "done"
    assert abs(step.residual) < 1e-6 * step.turnover  # far below the 1e-4 that switchings are allowed


def test_step_repeats(step: CycleEnergy) -> None:
    """The second step ends where it began: servo and plan have no memory beyond some ms."""
    assert step.periodicity < 1e-4


def test_energy_at_the_bus_agrees_with_the_audit(step: CycleEnergy) -> None:
    """Drawn less returned, by trapezoids of the rows, is what the audit says the storage gave less its own losses."""
    # 1036 rows hold commands that step from row to row: trapezoids err by about 1 % of the 40 J that pass
    assert step.drawn - step.returned == pytest.approx(step.net_drawn, abs=0.4)


def test_storage_and_joint_balance(step: CycleEnergy) -> None:
    """Over a steady step: work on the joint = losses + gain of the storage."""
    lost = sum(step.losses.values())
    rest = sum(step.changes.values())
    # closes to the residual; both sides are tens of joules
    assert step.work_on_joint == pytest.approx(lost + step.stored + rest, abs=1e-5 * step.turnover)
    assert step.work_on_joint > 10.0  # it brakes: the gait itself takes 13 J a step
    assert 0.0 < step.regenerating_share < 1.0
    assert step.elastic_exchanged >= step.elastic_max - 1e-2  # up and down at least once; the least is about zero


def test_work_of_the_walker_is_that_of_moment_and_coriolis(walk: Run, step: CycleEnergy) -> None:
    """The audit's work on the joint against integrals over the rows: load times rate, and m x x' q'^2 of the shuttle.

    The shuttle's centrifugal force m x q'^2 works on the belt; that comes from whoever turns the shank.
    """
    rows, first = walk.rows, 1036
    rate = np.asarray(rows.state.motion.link_rate)[first:]
    place = np.asarray(rows.setting)[first:]
    speed = PULLEY * np.asarray(rows.state.motion.motion_rate)[first:]
    power = np.asarray(rows.flows.response.load)[first:] * rate + 0.25 * place * speed * rate**2
    # trapezoids over 1036 intervals of a curve with a corner at contact: well within 0.1 %
    assert np.trapezoid(power, walk.time[first:]) == pytest.approx(step.work_on_joint, rel=1e-3)


def test_cycle_has_to_lie_on_rows(walk: Run) -> None:
    with pytest.raises(InputError, match="duration"):
        cycle_energy(walk, start=0.0, duration=1.13965)
    with pytest.raises(InputError, match="start"):
        cycle_energy(walk, start=-1.1, duration=1.1)


def test_direct_drive_of_an_ideal_motor_returns_what_the_knee_brakes() -> None:
    """Without resistance Richter's law leaves the work of the moment alone: 0.164 J/kg in Winter's cycle."""
    almost = Motor(torque_constant=0.02, resistance=1e-12, rotor_inertia=1e-12, gear_ratio=200.0)
    found = direct_drive(knee_gait(), almost, body_mass=BODY_MASS)
    assert found.returned == pytest.approx(0.164 * BODY_MASS, abs=0.0005 * BODY_MASS)  # the table has three digits
    assert found.returned_with_losses == pytest.approx(found.returned, abs=1e-3)  # no loss is left, R aside


def test_direct_drive_pays_copper_with_the_square_of_the_ratio() -> None:
    copper = [direct_drive(knee_gait(), _motor(ratio), body_mass=BODY_MASS) for ratio in (100.0, 200.0)]
    assert copper[0].copper == pytest.approx(4.0 * copper[1].copper, rel=1e-9)  # same sum, scaled
    assert copper[0].returned + copper[0].copper == pytest.approx(copper[1].returned + copper[1].copper, rel=1e-9)
    assert copper[1].returned_with_losses < copper[1].returned


def test_schedule_refuses_negative_inertia(beam: RollerBeam) -> None:
    spring = SensedSpring(beam, Affine(ratio=PULLEY), 0.06, 0.4, driven=False)
    with pytest.raises(InputError, match="inertia"):
        SettingSchedule(Pid(1.0), _course(), spring, -1.0)
