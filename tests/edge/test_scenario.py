"""What a scenario file becomes: numbers in SI units, in the right places."""

from __future__ import annotations

import json
import math
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import jax.numpy as jnp
import numpy as np
import pytest

import varistiff
from varistiff.actuators.slider_leaf_joint import SliderLeafJoint
from varistiff.cli.validation import means_scenario
from varistiff.core.errors import InputError
from varistiff.core.textfile import parse_yaml
from varistiff.design.scenario import Scenario, load_scenario
from varistiff.design.scenario_spec import scenario_json_schema
from varistiff.dynamics.carried_mass import CarriedMass
from varistiff.dynamics.control import (
    ImpedanceControl,
    MapChain,
    PositionPid,
    ScheduledLqr,
    SettingHold,
    StiffnessDecoupling,
    StiffnessPid,
    TorqueControl,
    WangChain,
)
from varistiff.dynamics.drives import Motor, TorqueSource, motor_data
from varistiff.dynamics.path import Affine, GroovePath
from varistiff.dynamics.storage import Battery, Supercapacitor, Supply

EXAMPLES = Path(__file__).parents[2] / "examples"
NAMES = ("wang_step", "sea_wall", "maccepa_swing", "knee_walking")
EXACT = partial(pytest.approx, rel=1e-12, abs=1e-15)  # a few roundings of a conversion
Load = Callable[..., Scenario]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Where scenario files lie beside the example designs."""
    for design in EXAMPLES.glob("*.yaml"):
        shutil.copy(design, tmp_path)
    (tmp_path / "scenarios").mkdir()
    return tmp_path / "scenarios"


@pytest.fixture
def loaded(folder: Path) -> Load:
    def from_text(text: str, *changes: tuple[str, str]) -> Scenario:
        for old, new in changes:
            assert old in text
            text = text.replace(old, new, 1)
        path = folder / "scenario.yaml"
        path.write_text(text, encoding="utf-8")
        return load_scenario(path)

    return from_text


def example(name: str) -> str:
    return (EXAMPLES / "scenarios" / f"{name}.yaml").read_text(encoding="utf-8")


SPRING = """
name: Spring
design: ../antagonistic_leaves.yaml
duration: 100 ms
step: 0.25 ms
plant:
  link: {mass: 2 kg, viscous_friction: 3 N*s/m, stops: {min: -9 mm, stiffness: 5 N/mm, damping: 2 s/m}}
  drive:
    motor: maxon_re_25_20w_24v
    gear_ratio: 4
    gear_efficiency: 0.7
    gear_inertia: 2 g*cm^2
    current_limit: 3 A
    voltage_limit: 12 V
    mass: 1.5 kg
    transmission: {kind: belt, pulley_radius: 20 mm}
    dry_friction: {coulomb: 4 N, breakaway: 6 N, stribeck_rate: 30 mm/s, smoothing_rate: 2 mm/s}
    stops: {max: 40 mm, stiffness: 7 N/mm}
  backlash: 0.3 mm
  deflection_stops: {min: -14 mm, max: 13 mm, stiffness: 9 N/mm}
  storage: {kind: supply, voltage: 36 V, series_resistance: 0.2 ohm, converter_efficiency: 0.9, regenerative: false}
start: {setting: 100 mm, link: 2 mm, link_rate: 5 mm/s, drive: 3 mm, drive_rate: -7 mm/s}
control:
  period: 1 ms
  delay: 2 ms
  encoders: {link: {resolution: 5 um}}
  drive:
    kind: decoupling
    every: 2
    proportional: 2 N/mm
    integral: 3 N/mm/s
    derivative: 50 N*s/m
    filter_time: 1 ms
    windup_time: 0.2 s
    stiffness: 800 N/m
    damping: 30 N*s/m
    rate_filter_time: 4 ms
reference:
  position: {kind: sum, parts: [{kind: step, time: 10 ms, after: 5 mm}, {kind: constant, value: 1 mm}]}
load: {force: {kind: pulse, start: 50 ms, duration: 10 ms, height: 3 N, shape: rectangle}}
"""


@pytest.mark.parametrize("name", NAMES)
def test_the_examples_are_scenarios(name: str) -> None:
    path = EXAMPLES / "scenarios" / f"{name}.yaml"
    scenario = varistiff.load_scenario(path)
    assert isinstance(scenario, varistiff.Scenario)
    assert re.fullmatch("[0-9a-f]{64}", scenario.hash)
    assert means_scenario(path)
    assert not means_scenario(EXAMPLES / "maccepa.yaml")
    assert scenario.attributes["scenario"] == path.read_text()


def test_a_linear_device_slides(loaded: Load) -> None:
    case = loaded(SPRING).case
    plant, motor = case.plant, case.plant.drive_motor
    data = motor_data("maxon_re_25_20w_24v")
    assert isinstance(motor, Motor)
    assert motor.gear_ratio == EXACT(4.0 / 0.020)  # turns of the motor per metre
    assert motor.reflected_inertia == EXACT((4.0 / 0.020) ** 2 * (data.rotor_inertia + 2e-7))
    assert (motor.gear_efficiency, motor.current_limit, motor.voltage_limit) == (0.7, 3.0, 12.0)
    assert (plant.link.inertia, plant.link.friction.viscous, plant.drive.inertia) == (2.0, 3.0, 1.5)
    link, drive = plant.link.stop, plant.drive.stop
    assert link is not None
    assert drive is not None
    assert (link.lower, link.upper, link.stiffness, link.damping) == (-0.009, math.inf, 5000.0, 2.0)
    assert (drive.lower, drive.upper, drive.stiffness, drive.damping) == (-math.inf, 0.040, 7000.0, 0.0)
    dry = plant.drive.friction.dry
    assert dry is not None
    assert (dry.coulomb, dry.breakaway, dry.stribeck_rate, dry.smoothing_rate) == (4.0, 6.0, 0.030, 0.002)
    assert plant.backlash == EXACT(3e-4)
    assert plant.deflection_stop is not None
    assert (plant.deflection_stop.lower, plant.deflection_stop.upper) == (-0.014, 0.013)
    assert plant.storage == Supply(36.0, 0.2, 0.9, False)
    assert plant.setting.mode == "locked"
    start = [float(number) for number in case.motion]
    assert start == EXACT([0.002, 0.005, 0.003, -0.007, 0.100, 0.0])


def test_its_control_and_signals(loaded: Load) -> None:
    scenario = loaded(SPRING)
    loop, inputs = scenario.case.loop, scenario.case.inputs
    assert (scenario.duration, scenario.step, scenario.case.period, loop.delay) == (0.1, 2.5e-4, 1e-3, 2)
    assert [encoder.step for encoder in loop.encoders] == EXACT([5e-6, 0.0, 0.0])
    assert loop.drive is not None
    control = loop.drive.controller
    assert isinstance(control, StiffnessDecoupling)
    assert loop.drive.every == 2
    pid = control.pid
    assert (pid.proportional, pid.integral, pid.derivative) == (2000.0, 3000.0, 50.0)
    assert (pid.filter_time, pid.windup_time, pid.derivative_on) == (1e-3, 0.2, "measurement")
    assert pid.limit == scenario.case.plant.drive_motor.torque_limit  # as none is given
    assert (control.stiffness, control.damping, control.filter_time) == (800.0, 30.0, 4e-3)
    assert control.link.inertia == EXACT(2.0)
    assert control.drive_inertia == EXACT(1.5 + scenario.case.plant.drive_motor.reflected_inertia)
    position = [float(inputs.position.at(jnp.asarray(time)).value) for time in (0.0, 0.02)]
    assert position == EXACT([0.001, 0.006])
    load = [float(inputs.load.at(jnp.asarray(time)).value) for time in (0.04, 0.055, 0.07)]
    assert load == EXACT([0.0, 3.0, 0.0])


def test_a_groove_turns_the_setting(loaded: Load) -> None:
    case = loaded(example("wang_step")).case
    plant, loop = case.plant, case.loop
    joint = plant.actuator
    assert isinstance(joint, SliderLeafJoint)
    assert joint.groove is not None
    assert isinstance(plant.setting_path, GroovePath)
    low, high = (float(joint.groove.angle(jnp.asarray(length))) for length in (0.015, 0.025))
    stop = plant.setting.stop
    assert stop is not None
    assert (stop.lower, stop.upper) == EXACT((low, high))  # lengths in the file, angles of the disc here
    assert isinstance(plant.carried, CarriedMass)
    assert plant.carried.body == "drive"
    # the slider rides at the radius l_2 = r_2 + l_1
    assert float(plant.carried.radius.at(jnp.asarray(low)).value) == EXACT(0.025 + 0.015)
    assert [encoder.step for encoder in loop.encoders] == EXACT([2.0 * math.pi / n for n in (65536, 65536, 409600)])
    assert loop.drive is not None
    assert loop.setting is not None
    assert isinstance(loop.drive.controller, PositionPid)
    assert isinstance(loop.setting.controller, StiffnessPid)
    assert isinstance(loop.setting.controller.chain, WangChain)
    # 3 N E I (r_2 + l)^2/l^3 with the leaf of the file, at the setting that 250 N m/rad ask for
    length = float(plant.setting_path.at(case.motion.motion).value)
    rigidity = 206e9 * 0.025 * 0.001**3 / 12.0
    assert 3.0 * rigidity * (0.025 + length) ** 2 / length**3 == EXACT(250.0)


@pytest.mark.parametrize(
    "transmission, start, ratio",
    [
        ("{kind: direct}", 0.0, 1.0),
        ("{kind: screw, lead: 2 mm}", 0.0, 0.002 / (2.0 * math.pi)),
        ("{kind: belt, pulley_radius: 8 mm}", 0.0, 0.008),
        ("{kind: line, start: 30 mm, slope: -0.1 mm/deg}", 0.030, -0.018 / math.pi),
    ],
)
def test_transmissions(loaded: Load, transmission: str, start: float, ratio: float) -> None:
    linear = transmission == "{kind: direct}"
    own, damping, limit = (
        ("mass: 1 kg", "20 N*s/m", "force_limit: 50 N")
        if linear
        else ("inertia: 2 g*m^2", "1e-5 N*m*s/rad", "torque_limit: 50 mN*m")
    )
    gains = ("50 N/m", "5 N*s/m") if linear else ("0.05 N*m/rad", "5e-4 N*m*s/rad")
    stiffness = "9 N/mm" if linear else "3 N*m/rad"
    case = loaded(
        example("maccepa_swing"),
        ("{kind: screw, lead: 2 mm}", transmission),
        ("inertia: 2e-6 kg*m^2", f"{own}\n    stops: {{min: 5 mm, max: 25 mm, stiffness: {stiffness}}}"),
        ("1e-5 N*m*s/rad", damping),
        ("torque_limit: 50 mN*m", limit),
        ("0.05 N*m/rad", gains[0]),
        ("5e-4 N*m*s/rad", gains[1]),
    ).case
    path, stop = case.plant.setting_path, case.plant.setting.stop
    assert isinstance(path, Affine)
    assert (path.start, path.ratio) == EXACT((start, ratio))
    ends = sorted((end - start) / ratio for end in (0.005, 0.025))
    assert stop is not None
    assert (stop.lower, stop.upper) == EXACT(tuple(ends))
    assert case.plant.carried is not None
    assert float(case.plant.carried.at(jnp.asarray(0.3)).own_inertia) == EXACT(0.050 * ratio**2)
    assert case.loop.setting is not None
    assert isinstance(case.loop.setting.controller, StiffnessPid)
    assert isinstance(case.loop.setting.controller.chain, MapChain)


def test_a_drive_without_a_motor_is_an_ideal_source(loaded: Load) -> None:
    text = example("maccepa_swing")
    plant = loaded(text).case.plant
    assert plant.drive_motor == TorqueSource(limit=4.0)
    assert loaded(text, ("    torque_limit: 4 N*m\n", "")).case.plant.drive_motor == TorqueSource()
    assert isinstance(plant.storage, Battery)
    assert (plant.storage.capacity, plant.storage.voltage_empty) == (7200.0, 18.0)


def test_a_data_sheet_of_ones_own(loaded: Load) -> None:
    sheet = """{torque_constant: 40 mNm/A, resistance: 0.5 ohm, rotor_inertia: 120 g*cm^2, no_load_current: 0.3 A,
      viscous_friction: 2e-6 N*m*s/rad, resistance_coefficient: 0.00393 K^-1, heating: {winding_resistance: 3 K/W,
      housing_resistance: 6 K/W, winding_time: 15 s, motor_time: 800 s, rise_limit: 100 K}}"""
    plant = loaded(example("sea_wall"), ("maxon_ec_45_flat_70w_24v", sheet)).case.plant
    motor = plant.drive_motor
    assert isinstance(motor, Motor)
    assert (motor.torque_constant, motor.resistance, motor.rotor_inertia) == EXACT((0.04, 0.5, 1.2e-5))
    assert (motor.friction_torque, motor.viscous_friction) == EXACT((0.04 * 0.3, 2e-6))
    assert (motor.gear_ratio, motor.current_limit, motor.resistance_coefficient) == (50.0, 10.0, 0.00393)
    assert motor.voltage_limit == math.inf
    assert motor.thermal is not None
    assert (motor.thermal.winding_resistance, motor.thermal.housing_resistance) == (3.0, 6.0)
    assert (motor.thermal.winding_time, motor.thermal.motor_time, motor.temperature_limit) == (15.0, 800.0, 100.0)
    assert isinstance(plant.storage, Supercapacitor)
    assert (plant.storage.capacitance, plant.storage.leakage_resistance) == (10.0, 5000.0)


CONTROLLERS = {
    TorqueControl: "kind: torque, proportional: 1, integral: 20 s^-1, limit: 3 N*m",
    ImpedanceControl: "kind: impedance, proportional: 1, stiffness: 30 N*m/rad, inertia_feedforward: true",
    ScheduledLqr: "kind: lqr, link_error: 2 deg, command: 5 N*m, drive_rate: 3 rad/s, integral_time: 0.2 s",
    PositionPid: "kind: pid, proportional: 9 N*m/rad, feedback: drive, derivative_on: error",
}


@pytest.mark.parametrize("kind", CONTROLLERS, ids=lambda kind: kind.__name__)
def test_controllers_of_the_drive(loaded: Load, kind: type) -> None:
    text = re.sub(
        r"  drive:\n    kind: torque\n(    .*\n)+", f"  drive: {{{CONTROLLERS[kind]}}}\n", example("sea_wall")
    )
    if kind is not TorqueControl:
        position = "{kind: minimum_jerk, start: 50 ms, duration: 100 ms, after: 9 deg}"
        text = re.sub(r"reference:\n(  .*\n)+", f"reference:\n  position: {position}\n", text)
    channel = loaded(text).case.loop.drive
    assert channel is not None
    control: Any = channel.controller
    assert isinstance(control, kind)
    if kind is TorqueControl:
        assert (control.pid.integral, control.pid.limit) == (20.0, 3.0)
    if kind is ImpedanceControl:
        assert (control.stiffness, control.inertia, control.torque_control.pid.proportional) == (30.0, 0.08, 1.0)
    if kind is ScheduledLqr:
        assert control.gains.shape == (1, 5)  # one setting, with integral action
    if kind is PositionPid:
        assert (control.feedback, control.pid.derivative_on) == ("drive", "error")


def test_a_setting_that_is_held(loaded: Load) -> None:
    text = re.sub(r"    kind: pid\n    chain: map\n", "    kind: hold\n    setting: 12 mm\n", example("maccepa_swing"))
    channel = loaded(re.sub(r"  stiffness: {kind.*\n", "", text)).case.loop.setting
    assert channel is not None
    assert isinstance(channel.controller, SettingHold)
    assert channel.controller.motion == EXACT(0.012 * 2.0 * math.pi / 0.002)


def test_the_drive_starts_where_the_spring_carries_the_link(loaded: Load) -> None:
    """A linear spring k under the torque m g l sin(q - q_0) + tau: q_1 = q + torque/k."""
    gravity = "gravity: {mass: 1.5 kg, centre_of_mass: 0.25 m, rest: -20 deg}\n    stops: {max"
    case = loaded(
        example("sea_wall"),
        ("stops: {max", gravity),
        ("control:\n", "start: {link: 10 deg}\nload: {torque: {kind: constant, value: 0.7 N*m}}\ncontrol:\n"),
    ).case
    torque = 1.5 * 9.80665 * 0.25 * math.sin(math.radians(30.0)) + 0.7
    # the equilibrium is solved to 1e-12 of the forces
    assert float(case.motion.drive) == pytest.approx(math.radians(10.0) + torque / 160.0, rel=1e-9)
    relaxed = loaded(example("sea_wall"), ("control:\n", "start: {link: 10 deg}\ncontrol:\n")).case
    assert float(relaxed.motion.drive) == math.radians(10.0)


def test_a_link_on_a_locked_drive_swings_as_the_closed_form_says(loaded: Load) -> None:
    """q = a cos(sqrt(k/J) t) from rest at a, with every unit but one an odd one."""
    scenario = loaded(
        """
name: Swing
design: {name: Spring, actuator: {kind: series_elastic, stiffness: 2 N*m/deg, deflection: {min: -10 deg, max: 10 deg}}}
duration: 200 ms
plant: {link: {inertia: 500000 g*cm^2}}
start: {link: 5 deg, drive: 0 deg}
"""
    )
    run = scenario.simulate()
    rate = math.sqrt(2.0 * 180.0 / math.pi / 0.05)
    expected = math.radians(5.0) * np.cos(rate * run.data["time"].values)
    # the chosen step times the rate is at most 0.2: fourth order errs by 1e-6 of the swing a radian, and 7 pass
    assert run.data["link"].values == pytest.approx(expected, abs=1e-5 * math.radians(5.0))
    assert run.outcome.value == "done"
    assert run.failed_at is None
    assert run.audit.closes
    assert np.isnan(run.data["wanted_position"]).all()
    assert not any(name.startswith(("position_", "bandwidth")) for name in run.metrics)
    assert run.data.attrs["scenario_hash"] == scenario.hash
    assert run.data.attrs["design_hash"] == scenario.design.hash
    assert "series_elastic" in run.data.attrs["design"]
    assert scenario.design.name == "Spring"
    assert "done" in repr(run)
    assert scenario.case.period == 1e-3  # without control


def test_a_trajectory_with_its_sign_and_unit(folder: Path, loaded: Load) -> None:
    (folder / "table.csv").write_text("time [s],angle\n0,0\n1,5\n2,3\n", encoding="utf-8")
    (folder / "moment.sto").write_text("title\nnRows=3\nendheader\ntime\tmoment\n0\t1\n1\t2\n2\t1\n", encoding="utf-8")
    sine = "{kind: sine, amplitude: 25 deg, frequency: 0.8 Hz}"
    file = "{kind: trajectory, file: table.csv, column: angle, sign: opposite, unit: deg, start: 0.5 s, scale: 2}"
    moment = "{kind: trajectory, file: moment.sto, column: moment, sign: same, unit: N*m/kg, body_mass: 80 kg}"
    load = f"load:\n  torque: {moment}\n"
    start = ("stiffness: 0.15 N*m/rad ", "drive: 0 deg\n  stiffness: 0.15 N*m/rad ")
    inputs = loaded(example("maccepa_swing") + load, (sine, file), start).case.inputs
    assert float(inputs.position.at(jnp.asarray(1.5)).value) == EXACT(-math.radians(10.0))
    assert float(inputs.load.at(jnp.asarray(1.0)).value) == EXACT(160.0)


def test_the_knee_walks(loaded: Load) -> None:
    text = """
name: Knee
design: ../roller_beam.yaml
duration: 1 s
plant: {link: {inertia: 0.3 kg*m^2, motion: prescribed, signal: {kind: gait, joint: knee, quantity: angle, scale: 0.2}}}
start: {setting: 0.3 m}
load: {torque: {kind: gait, joint: knee, quantity: moment, body_mass: 75 kg, scale: -1}}
"""
    case = loaded(text).case
    assert case.inputs.link is not None
    # Winter 1987, 14 % of a cycle of 1.1396 s: 21.67 deg and 0.615 N m/kg
    at = jnp.asarray(0.14 * 1.1396)
    assert float(case.inputs.link.at(at).value) == EXACT(0.2 * math.radians(21.67))
    assert float(case.inputs.load.at(at).value) == EXACT(-75.0 * 0.615)
    assert float(case.motion.link) == float(case.inputs.link.at(jnp.asarray(0.0)).value)
    assert not case.plant.driven


def test_the_hash_sees_values_and_nothing_else(folder: Path, loaded: Load) -> None:
    text = example("sea_wall")
    before = loaded(text).hash
    same = [
        (("duration: 1 s", "duration: 1000 ms"),),
        (("max: 20 deg", "max: 1200 arcmin"),),
        (("name: Series elastic joint hits a wall", "name: Another"),),
        (("# the wall", "# a wall"),),
    ]
    assert {loaded(text, *changes).hash for changes in same} == {before}
    different = [
        (("duration: 1 s", "duration: 1.001 s"),),
        (("gear_ratio: 50", "gear_ratio: 51"),),
        (("maxon_ec_45_flat_70w_24v", "maxon_ec_45_flat_50w_24v"),),
        (("kind: minimum_jerk, start: 50 ms", "kind: minimum_jerk, start: 51 ms"),),
    ]
    assert len({loaded(text, *changes).hash for changes in different} | {before}) == 5
    design = folder.parent / "series_elastic.yaml"
    design.write_text(design.read_text() + "# a comment\n")
    assert loaded(text).hash == before
    design.write_text(design.read_text().replace("160 N*m/rad", "161 N*m/rad"))
    assert loaded(text).hash != before


def test_the_hash_sees_the_content_of_a_trajectory(folder: Path, loaded: Load) -> None:
    sine = "{kind: sine, amplitude: 25 deg, frequency: 0.8 Hz}"
    text = example("maccepa_swing").replace(sine, "{kind: trajectory, file: a.csv, column: x, sign: same, unit: deg}")
    (folder / "a.csv").write_text("time [s],x\n0,0\n1,5\n2,3\n", encoding="utf-8")
    shutil.copy(folder / "a.csv", folder / "b.csv")
    before = loaded(text).hash
    assert loaded(text.replace("a.csv", "b.csv")).hash == before
    (folder / "a.csv").write_text("time [s],x\n0,0\n1,5\n2,4\n", encoding="utf-8")
    assert loaded(text).hash != before


def test_the_schema_completes_every_field_and_holds_for_the_examples() -> None:
    schema = scenario_json_schema()
    assert schema["title"] == "varistiff scenario"
    text = json.dumps(schema)
    for document in (*(next(parse_yaml(example(name))) for name in NAMES), next(parse_yaml(SPRING))):
        assert conforms(document, schema, schema)
        for name in field_names(document):
            assert f'"{name}"' in text
        for broken in ("3", "3 kg", 3, None):
            assert not conforms({**document, "duration": broken}, schema, schema)
        assert not conforms({**document, "durations": "1 s"}, schema, schema)
        wrong = {**document["control"], "period": "1 deg"}
        assert not conforms({**document, "control": wrong}, schema, schema)


def field_names(value: Any) -> set[str]:
    inside = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return set(value if isinstance(value, dict) else ()).union(*map(field_names, inside))


def conforms(value: Any, schema: dict[str, Any], root: dict[str, Any]) -> bool:
    """A validator of the few words of JSON schema that ours uses."""
    if "$ref" in schema:
        return conforms(value, root["$defs"][schema["$ref"].rsplit("/", 1)[1]], root)
    for word in ("oneOf", "anyOf"):
        if word in schema:
            passing = sum(conforms(value, option, root) for option in schema[word])
            return passing == 1 if word == "oneOf" else passing > 0
    if "const" in schema and value != schema["const"]:
        return False
    if "enum" in schema and value not in schema["enum"]:
        return False
    kind = schema.get("type")
    if kind == "object":
        fields = schema["properties"]
        return (
            isinstance(value, dict)
            and set(value) <= set(fields)
            and set(schema.get("required", ())) <= set(value)
            and all(conforms(item, fields[name], root) for name, item in value.items())
        )
    if kind == "array":
        return isinstance(value, list) and all(conforms(item, schema["items"], root) for item in value)
    if kind == "string":
        return isinstance(value, str) and re.search(schema.get("pattern", ""), value) is not None
    if kind in ("integer", "number"):
        bounded = schema.get("minimum", -math.inf) <= value if isinstance(value, int | float) else False
        return (
            bounded and value <= schema.get("maximum", math.inf) and value > schema.get("exclusiveMinimum", -math.inf)
        )
    return isinstance(value, bool) if kind == "boolean" else value is None


def test_an_inline_design_reads_its_files_beside_the_scenario(folder: Path, loaded: Load) -> None:
    inline = """{name: Bar, materials_file: own.yaml, actuator: {kind: torsion_tube, material: mine,
  section: {shape: polygon, file: bar.csv, unit: mm}, setting: {min: 11 mm, max: 166 mm},
  deflection: {min: -9 deg, max: 9 deg}}}"""
    text = """
name: Bar
design: INLINE
duration: 10 ms
plant: {link: {inertia: 0.1 kg*m^2}}
start: {setting: 100 mm}
""".replace("INLINE", inline)
    with pytest.raises(InputError, match=r"own\.yaml: cannot be read"):
        loaded(text)
    (folder / "own.yaml").write_text("mine: {shear_modulus: 1 GPa, source: test}\n")
    (folder / "bar.csv").write_text("x,y\n0,0\n20,0\n20,10\n0,10\n")
    scenario = loaded(text)
    # Roark, rectangle 20 mm by 10 mm: J = 0.2287 a b^3; the formula's four digits
    response, _ = scenario.design.actuator.respond(jnp.asarray(0.01), jnp.asarray(0.1))
    assert float(response.stiffness) == pytest.approx(1e9 * 0.2287 * 0.02 * 0.01**3 / 0.1, rel=1e-3)
    (folder / "bar.csv").write_text("x,y\n0,0\n20,0\n")
    with pytest.raises(InputError) as caught:
        loaded(text)
    assert "bar.csv" in str(caught.value)


def test_nothing_slow_is_imported_to_read_a_scenario() -> None:
    """A misspelt field is said at once."""
    script = (
        "import sys; from varistiff.design.scenario_read import read_scenario\n"
        f"read_scenario({str(EXAMPLES / 'scenarios' / 'wang_step.yaml')!r})\n"
        "import varistiff.design.scenario\n"
        "slow = {'jax', 'xarray', 'matplotlib', 'equinox'} & set(sys.modules)\n"
        "assert not slow, slow\n"
    )
    subprocess.run([sys.executable, "-c", script], check=True)
