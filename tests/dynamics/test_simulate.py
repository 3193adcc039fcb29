"""How runs end, and the instants of what happened."""

from __future__ import annotations

import dataclasses
import math

import equinox as eqx
import numpy as np
import pytest

from varistiff.actuators import Maccepa, RollerBeam, SeriesElastic, SwivellingPair
from varistiff.core.errors import InputError
from varistiff.dynamics.control import MapChain, Pid, PositionPid, StiffnessPid, setting_inverse
from varistiff.dynamics.control_loop import Channel, ControlLoop, Inputs
from varistiff.dynamics.drives import Motor, TorqueSource
from varistiff.dynamics.friction import Friction
from varistiff.dynamics.outcome import Outcome
from varistiff.dynamics.path import Affine
from varistiff.dynamics.plant import Gravity, Member, Plant
from varistiff.dynamics.program import Case
from varistiff.dynamics.signals import Constant, Step, Sum
from varistiff.dynamics.simulate import simulate
from varistiff.dynamics.stop import Stop
from varistiff.dynamics.storage import Supercapacitor

from .cases import BEAM, REST, two_masses


def _servo(*, proportional=60.0, derivative=6.0, limit=math.inf, target=0.1) -> Case:
    plant = Plant(
        SeriesElastic(160.0),
        link=Member(0.05, Friction(0.2)),
        drive=Member(0.1, Friction(0.3)),
        drive_motor=TorqueSource(limit=limit),
    )
    pid = Pid(proportional, 0.0, derivative, filter_time=0.002, limit=limit)
    loop = ControlLoop(drive=Channel(PositionPid(pid, "drive")))
    return Case(plant, loop, Inputs(position=Step(0.0, 0.0, target)), REST, 1e-3)


def test_a_stable_loop_is_done_and_ends_where_it_should():
    run = simulate(_servo(), duration=1.5)
    assert run.outcome is Outcome.DONE
    assert run.failed_at is None
    assert run.audit.relative < 1e-6
    assert run.rows.state.motion.link[-1] == pytest.approx(0.1, rel=1e-3)  # e^-8 of it is left


def test_an_unstable_loop_is_named_with_its_time():
    run = simulate(_servo(proportional=-40.0, derivative=0.0), duration=1.0)
    assert run.outcome is Outcome.UNSTABLE
    assert 0.0 < run.failed_at < 1.0
    assert np.isfinite(run.rows.state.motion.link).all()


def test_saturation_is_an_event():
    run = simulate(_servo(limit=2.0, target=0.5), duration=1.0)
    assert run.outcome is Outcome.DONE
    assert "drive saturated" in {event.name for event in run.events}


def test_a_stiffness_that_no_setting_gives_is_an_event():
    maccepa = Maccepa(spring_rate=394.0, lever_length=0.036, anchor_distance=0.135)
    chain = MapChain(setting_inverse(maccepa, setting_min=0.005, setting_max=0.025))
    plant = Plant(
        maccepa,
        link=Member(0.01, Friction(0.01)),
        setting=Member(0.5, Friction(20.0)),
        setting_path=Affine(),
        setting_motor=TorqueSource(),
    )
    loop = ControlLoop(setting=Channel(StiffnessPid(Pid(500.0), chain)))
    stiffness = Sum((Constant(0.3), Step(0.05, 0.0, 0.3)))
    start = REST._replace(motion=0.010)
    run = simulate(Case(plant, loop, Inputs(stiffness=stiffness), start, 1e-3), duration=0.1)
    (event,) = [event for event in run.events if event.name == "stiffness out of reach"]
    assert event.time == pytest.approx(0.05, abs=1e-12)  # the sample of the step
    # k P B C/(C - B) at 25 mm
    assert f"{394.0 * 0.025 * 0.036 * 0.135 / 0.099:.4g}" in event.text
    assert "0.6" in event.text


def test_a_stop_is_named_with_its_located_instant():
    case = two_masses()
    stop = Stop(lower=-0.03, stiffness=1e4)
    case = eqx.tree_at(lambda c: c.plant.link.stop, case, stop, is_leaf=lambda leaf: leaf is None)
    run = simulate(case, duration=0.1)
    first = next(event for event in run.events if event.name == "link at its lower stop")
    # until then the link is at x_c + (0.1 - x_c) cos(w t), with x_c the resting centre of mass
    centre, pulsation = 0.2 * 0.1 / 0.7, math.sqrt(160.0 * (1.0 / 0.2 + 1.0 / 0.5))
    assert first.time == pytest.approx(math.acos((-0.03 - centre) / (0.1 - centre)) / pulsation, abs=1e-8)


def test_a_motion_off_the_map_keeps_what_came_before():
    plant = Plant(
        RollerBeam(beam=dataclasses.replace(BEAM, length=0.4), rollers=SwivellingPair(offset=0.0, clearance=0.0)),
        link=Member(0.2),
        driven=False,
        gravity=Gravity(moment=-1.0),
    )
    plant = eqx.tree_at(lambda p: p.setting_path.start, plant, 0.39)
    case = Case(plant, ControlLoop(), Inputs(load=Constant(-400.0)), REST, 1e-3)
    run = simulate(case, duration=0.5, step=1e-3)
    assert run.outcome is Outcome.LEFT_MAP
    assert 0.0 < run.failed_at < 0.5
    assert run.time[-1] == run.failed_at
    assert np.isfinite(run.rows.flows.response.load).all()


def test_a_step_beyond_stability_is_named():
    case = dataclasses.replace(two_masses(stiffness=4e6), period=1e-3)
    run = simulate(case, duration=1.0, step=1e-3)
    assert run.outcome is Outcome.STEP_TOO_LARGE


def test_an_open_balance_is_no_result():
    case = dataclasses.replace(two_masses(stiffness=4e4), period=2e-3)
    run = simulate(case, duration=1.0, step=2e-3)
    assert run.outcome is Outcome.AUDIT_OPEN
    assert run.failed_at is not None
    assert not run.audit.closes
    assert simulate(case, duration=1.0).outcome is Outcome.DONE  # with a step of varistiff's own


def test_an_overdrawn_storage_is_named():
    case = _servo(target=1.0)
    motor = Motor(torque_constant=0.03, resistance=0.3, rotor_inertia=1e-5, gear_ratio=30.0)
    plant = eqx.tree_at(
        lambda p: (p.drive_motor, p.storage),
        case.plant,
        (motor, Supercapacitor(capacitance=0.02, voltage=12.0, series_resistance=2.0)),
    )
    run = simulate(dataclasses.replace(case, plant=plant), duration=0.5)
    assert run.outcome is Outcome.STORAGE_OVERDRAWN
    assert "storage overdrawn" in {event.name for event in run.events}


@pytest.mark.parametrize(
    ("arguments", "field"),
    [({"duration": 0.0105}, "duration"), ({"duration": -1.0}, "duration"), ({"duration": 0.1, "step": 3e-4}, "step")],
)
def test_a_duration_or_step_that_does_not_fit(arguments, field):
    with pytest.raises(InputError) as raised:
        simulate(two_masses(), **arguments)
    assert raised.value.field == field
