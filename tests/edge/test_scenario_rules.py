"""Every wrong scenario gets one line: field, what is wrong, what is allowed."""

from __future__ import annotations

import copy
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from varistiff.core.errors import InputError
from varistiff.core.textfile import parse_yaml
from varistiff.design.scenario import load_scenario
from varistiff.design.scenario_read import validated_scenario

EXAMPLES = Path(__file__).parents[2] / "examples"
WALL, SWING, WANG, KNEE, SPRING, TUBE = "sea_wall", "maccepa_swing", "wang_step", "knee", "spring", "tube"
OWN = {
    KNEE: """
name: Knee
design: ../roller_beam.yaml
duration: 1 s
plant:
  link: {inertia: 0.3 kg*m^2, motion: prescribed, signal: {kind: gait, joint: knee, quantity: angle, scale: 0.1}}
  setting_drive: {transmission: {kind: screw, lead: 5 mm}, inertia: 1e-5 kg*m^2, carried_mass: {mass: 300 g, on: link}}
start: {setting: 0.3 m}
control:
  period: 1 ms
  setting: {kind: virtual_spring_damper, dead_band: 1 deg, proportional: 1 N*m/rad, derivative: 0.01 N*m*s/rad}
reference:
  torque: {kind: gait, joint: knee, quantity: moment, body_mass: 75 kg, scale: 0.1}
""",
    SPRING: """
name: Spring
design: ../antagonistic_leaves.yaml
duration: 100 ms
plant:
  link: {mass: 2 kg, viscous_friction: 3 N*s/m}
  drive: {motor: maxon_re_25_20w_24v, gear_ratio: 4, mass: 1 kg, transmission: {kind: screw, lead: 4 mm}}
  setting_drive: {transmission: {kind: screw, lead: 2 mm}, inertia: 10 g*m^2, carried_mass: {mass: 300 g, on: ground}}
start: {setting: 100 mm}
control:
  period: 1 ms
  encoders: {link: {resolution: 1 um}}
  drive: {kind: pid, proportional: 2000 N/m, derivative: 50 N*s/m}
reference:
  position: {kind: step, time: 10 ms, after: 5 mm}
load: {force: {kind: pulse, start: 50 ms, duration: 10 ms, height: 3 N}}
""",
    TUBE: """
name: Tube
design: ../torsion_tube.yaml
duration: 100 ms
plant:
  link: {inertia: 0.1 kg*m^2}
  drive: {inertia: 0.01 kg*m^2, torque_limit: 20 N*m}
  setting_drive: {transmission: {kind: screw, lead: 2 mm}, inertia: 10 g*m^2, carried_mass: {mass: 300 g, on: ground}}
start: {setting: 100 mm}
control:
  period: 1 ms
  drive: {kind: lqr, link_error: 2 deg, command: 5 N*m, integral_time: 0.2 s}
  setting: {kind: hold, proportional: 1 N*m/rad}
reference:
  position: {kind: step, time: 10 ms, after: 5 deg}
""",
}
SINE = "{kind: sine, amplitude: 25 deg, frequency: 0.8 Hz}"

WRONG = [
    # algebraic nonsense
    (WALL, "inertia: 0.08 kg*m^2", "inertia: 0 kg*m^2", 'plant.link.inertia: "0 kg*m^2" is not allowed; allowed is a'),
    (WALL, "inertia: 0.08 kg*m^2", "inertia: -1 kg*m^2", "plant.link.inertia: "),
    (
        WALL,
        "    inertia: 0.08 kg*m^2\n",
        "",
        "plant.link.inertia: is missing; allowed is a moment of inertia above zero",
    ),
    (
        SWING,
        "    inertia: 0.002 kg*m^2  ",
        "    #",
        "plant.drive.inertia: is missing; a drive that moves needs it, or a motor",
    ),
    (SPRING, "mass: 2 kg, ", "", "plant.link.mass: is missing; allowed is a mass above zero"),
    (
        WALL,
        "gear_efficiency: 0.75",
        "gear_efficiency: 1.75",
        "plant.drive.gear_efficiency: is 1.75; allowed is a number",
    ),
    (WALL, "gear_ratio: 50", "gear_ratio: 0", "plant.drive.gear_ratio: is 0; allowed is a number above zero"),
    (WALL, "gear_ratio: 50", "gear_ratio: .nan", "plant.drive.gear_ratio: is nan; allowed is a number above zero"),
    (WALL, "gear_ratio: 50", "gear_ratio: true", "plant.drive.gear_ratio: is true; allowed is a number above zero"),
    (WALL, "max: 20 deg", "min: 30 deg, max: 20 deg", "plant.link.stops.min: min is not below max"),
    (WALL, "max: 20 deg, ", "", "plant.link.stops: neither min nor max is given"),
    (SWING, "coulomb: 2 mN*m", "coulomb: 2 mN*m, breakaway: 1 mN*m", "dry_friction.breakaway: is below coulomb"),
    (SWING, "frequency: 0.8 Hz", "frequency: 0 Hz", "reference.position.frequency: "),
    (WALL, "gear_ratio: 50", "gear_ratio: 1e200", "plant.drive.gear_ratio: 1e+200 is no magnitude of a joint"),
    (SPRING, "lead: 4 mm", "lead: 1e-300 mm", 'transmission.lead: "1e-300 mm" is no magnitude of a joint'),
    (SPRING, "height: 3 N", "height: 1e16 N", 'load.force.height: "1e16 N" is no magnitude of a joint'),
    # times
    (WALL, "period: 1 ms", "period: 0 ms", 'control.period: "0 ms" is not allowed; allowed is a time above zero'),
    (WALL, "period: 1 ms", "period: 3 ms", "duration: is 1 s, no whole number of periods of 0.003 s; allowed is for"),
    (
        WALL,
        "duration: 1 s",
        "duration: 0.1 ms",
        "no whole number of periods of 0.001 s; allowed is for example 0.001 s",
    ),
    (WALL, "duration: 1 s", "duration: 501 s", "duration: makes 501000 samples of 0.001 s; allowed are at most 500000"),
    (
        WALL,
        "duration: 1 s",
        "duration: 1 s\nstep: 0.3 ms",
        "step: is 0.0003 s and does not divide the period of 0.001 s",
    ),
    (WALL, "duration: 1 s", "duration: 1 s\nstep: 3 ms", "allowed is for example 0.001 s"),
    (WALL, "duration: 1 s", "duration: 1 s\nstep: 1 ns", "step: makes 1e+09 steps of 1e-09 s"),
    (WALL, "period: 1 ms", "period: 1 ms\n  delay: 1.5 ms", "control.delay: is 0.0015 s; allowed is a whole number of"),
    (WALL, "period: 1 ms", "period: 1 ms\n  delay: 101", "control.delay: is 101; allowed is a whole number of periods"),
    (WALL, "period: 1 ms", "period: 1 ms\n  delay: 2 s", "control.delay: is 2 s; allowed is a whole number of periods"),
    (WALL, "period: 1 ms", "period: 1 ms\n  delay: two", "or a whole number of periods"),
    (
        WALL,
        "kind: torque\n",
        "kind: torque\n    every: 0\n",
        "control.drive.every: is 0; allowed is a whole number from 1",
    ),
    # what the joint does not have
    (
        KNEE,
        "plant:\n",
        "plant:\n  drive: {inertia: 1 kg*m^2}\n",
        "plant.drive: a roller_beam is semi-active: it has no",
    ),
    (
        KNEE,
        "  setting: {",
        "  drive: {kind: pid, proportional: 1 N*m/rad}\n  setting: {",
        "control.drive: a roller_beam",
    ),
    (KNEE, "period: 1 ms", "period: 1 ms\n  encoders: {drive: {counts: 100}}", "control.encoders.drive: a roller_beam"),
    (KNEE, "{setting: 0.3 m}", "{setting: 0.3 m, drive: 1 deg}", "start.drive: a roller_beam is semi-active"),
    (KNEE, "on: link", "on: drive", "carried_mass.on: a roller_beam is semi-active"),
    (
        KNEE,
        "  setting_drive:",
        "  deflection_stops: {max: 1 deg, stiffness: 9 N*m/rad}\n  setting_drive:",
        "give plant.link.stops",
    ),
    (WALL, "control:\n", "start: {setting: 3 mm}\ncontrol:\n", "start.setting: a series_elastic has no setting"),
    (
        WALL,
        "  storage:",
        "  setting_drive: {inertia: 1 kg*m^2}\n  storage:",
        "plant.setting_drive: a series_elastic has no",
    ),
    (
        WALL,
        "reference:\n",
        "  setting: {kind: hold, proportional: 1 N*m/rad}\nreference:\n",
        "control.setting: a series_elastic",
    ),
    (
        WALL,
        "reference:\n",
        "reference:\n  stiffness: {kind: constant, value: 1 N*m/rad}\n",
        "reference.stiffness: a series_el",
    ),
    (
        TUBE,
        "kind: hold",
        "kind: virtual_spring_damper, dead_band: 1 deg",
        "a torsion_tube has a drive; allowed: hold, pid",
    ),
    (
        TUBE,
        "  drive: {inertia: 0.01 kg*m^2, torque_limit: 20 N*m}\n",
        "",
        "control.drive: is given, but plant.drive does not",
    ),
    (TUBE, "torque_limit: 20 N*m", "motion: locked", "control.drive: is given, but plant.drive does not move"),
    (TUBE, "on: ground", "on: link", "on: link is given, but the setting of a torsion_tube slides along the axis"),
    (SPRING, "on: ground", "on: link", "on: link is given, but an antagonistic_leaves slides"),
    (
        SPRING,
        "viscous_friction: 3 N*s/m",
        "gravity: {mass: 1 kg, centre_of_mass: 1 m}",
        "give its constant weight as load.f",
    ),
    (
        SPRING,
        ", transmission: {kind: screw, lead: 4 mm}",
        "",
        "plant.drive.transmission: is missing; a motor turns, and an",
    ),
    (
        WALL,
        "gear_ratio: 50",
        "transmission: {kind: screw, lead: 1 mm}",
        "the drive of a series_elastic turns; leave it out",
    ),
    (KNEE, "kind: screw, lead: 5 mm", "kind: groove", "transmission: groove is given, but the design has none"),
    (SWING, "chain: map", "chain: exact", "control.setting.chain: exact ends in the disc angle of a slider_leaf_joint"),
    (WANG, "kind: groove", "kind: screw, lead: 9 mm", "control.setting.chain: wang_line ends in the disc angle"),
    (
        WANG,
        "{min: 15 mm, max: 25 mm, ",
        "{min: 60 mm, ",
        "setting_drive.stops.min: is a setting that the groove does not",
    ),
    (
        WANG,
        "chain: wang_line ",
        "chain: wang_line\n    stiffness_at: measured ",
        "measured is given, but only the chain map",
    ),
    (
        KNEE,
        "{setting: 0.3 m}",
        "{setting: 0.3 m, link: 2 deg}",
        "start.link: is given, but the link follows its signal",
    ),
    (KNEE, "start: {setting: 0.3 m}\n", "", "start.setting: is missing; a roller_beam needs it, or start.stiffness"),
    (KNEE, "{setting: 0.3 m}", "{setting: 2 m}", "start: the actuator has no solution at a deflection of"),
    (
        TUBE,
        "{setting: 100 mm}",
        "{stiffness: 1e6 N*m/rad}",
        "start.stiffness: is outside the design's range of settings",
    ),
    (TUBE, "{setting: 100 mm}", "{setting: 1 mm, stiffness: 50 N*m/rad}", "start.stiffness: is given beside setting"),
    (
        SWING,
        "gravity: {mass: 0.1 kg, centre_of_mass: 0.15 m}",
        "gravity: {mass: 99 kg, centre_of_mass: 9 m, rest: 90 deg}",
        "start.drive: give it: no equilibrium",
    ),
    # a quantity of another kind
    (WALL, "inertia: 0.08 kg*m^2", "inertia: 0.08", "plant.link.inertia: 0.08 has no unit"),
    (WALL, "inertia: 0.08 kg*m^2", "inertia: 0.08 kg", "is a mass; allowed is a moment of inertia"),
    (WALL, "inertia: 0.08 kg*m^2", "mass: 1 kg", "plant.link.mass: is given, but this part turns; give inertia"),
    (SPRING, "mass: 2 kg", "inertia: 2 kg*m^2", "plant.link.inertia: is given, but this part slides; give mass"),
    (WALL, "max: 20 deg", "max: 20 mm", 'plant.link.stops.max: "20 mm" is a length; allowed is an angle'),
    (WALL, "stiffness: 4000 N*m/rad", "stiffness: 4000 N/m", "plant.link.stops.stiffness: "),
    (WALL, "damping: 0.4 s/rad", "damping: 0.4 s/m", "is a time per length; allowed is a time per angle"),
    (WALL, "0.05 N*m*s/rad", "0.05 N*s/m", "is a linear damping; allowed is a rotational damping"),
    (WALL, "after: 2 N*m", "after: 2 deg", 'reference.torque.after: "2 deg" is an angle; allowed is a torque'),
    (
        WALL,
        "after: 2 N*m",
        "after: 2 J",
        'reference.torque.after: "2 J" is an energy; allowed is an angle, a length, a',
    ),
    (WALL, "capacitance: 10 F", "capacitance: 10 C", "plant.storage.capacitance: "),
    (KNEE, "{setting: 0.3 m}", "{setting: 0.3 deg}", 'start.setting: "0.3 deg" is an angle; allowed is a length'),
    (KNEE, "proportional: 1 N*m/rad", "proportional: 1 N/m", "control.setting.proportional: "),
    (TUBE, "command: 5 N*m", "command: 5 N", 'control.drive.command: "5 N" is a force; allowed is a torque'),
    (SPRING, "height: 3 N", "height: 3 N*m", 'load.force.height: "3 N*m" is a torque; allowed is a force'),
    (SPRING, "load: {force:", "load: {torque:", "load.torque: is given, but an antagonistic_leaves slides; give force"),
    (
        WALL,
        "  torque: {kind: minimum_jerk",
        "  force: {kind: minimum_jerk",
        "reference.force: is given, but a series_elastic",
    ),
    (SWING, "torque_limit: 4 N*m", "force_limit: 4 N", "plant.drive.force_limit: is given, but this drive turns"),
    (
        SPRING,
        "{resolution: 1 um}",
        "{counts: 100}",
        "control.encoders.link.counts: is given, but this coordinate slides",
    ),
    (SWING, "frequency: 0.8 Hz", "frequency: 0.8 rad/s", "is an angular rate; allowed is a frequency"),
    (
        WALL,
        "proportional: 1 ",
        "proportional: 1 N*m ",
        'control.drive.proportional: is "1 N*m"; allowed is a number of',
    ),
    # misspelt or contradicting fields
    (WALL, "name:", "nme:", 'unknown field "nme" (did you mean "name"?)'),
    (WALL, "maxon_ec_45_flat_70w_24v", "maxon_ec45_flat_70w", '(did you mean "maxon_ec_45_flat_70w_24v"?)'),
    (WALL, "kind: torque", "kind: torqe", 'control.drive.kind: unknown kind "torqe" (did you mean "torque"?)'),
    (WALL, "kind: supercapacitor", "kind: supercap", 'plant.storage.kind: unknown kind "supercap"'),
    (KNEE, "kind: screw", "kind: scrw", 'transmission.kind: unknown kind "scrw" (did you mean "screw"?)'),
    (KNEE, "virtual_spring_damper, dead", "pid, dead", 'control.setting: unknown field "dead_band"'),
    (
        WALL,
        "motor: maxon_ec_45_flat_70w_24v",
        "motor: {torque_constant: 30 mNm}",
        "plant.drive.motor.torque_constant: ",
    ),
    (
        WALL,
        "motor: maxon_ec_45_flat_70w_24v",
        "torque_limit: 3 N*m",
        "plant.drive.gear_ratio: is given without a motor",
    ),
    (WALL, "gear_ratio: 50", "torque_limit: 3 N*m", "plant.drive.torque_limit: is given beside a motor"),
    (WALL, "link: {counts: 65536}", "link: {}", "control.encoders.link: needs resolution or counts, one of them"),
    (
        WALL,
        "link: {counts: 65536}",
        "link: {resolution: 1 deg, ratio: 2}",
        "encoders.link.ratio: is given without counts",
    ),
    (KNEE, "motion: prescribed", "motion: free", "plant.link.signal: is given, but motion is free"),
    (KNEE, ", signal: {kind: gait, joint: knee, quantity: angle, scale: 0.1}", "", "plant.link.signal: is missing"),
    (
        TUBE,
        "plant:\n",
        "plant:\n  storage: {kind: supply, voltage: 9 V, regenerative: 1}\n",
        "allowed is true or false",
    ),
    (
        TUBE,
        "plant:\n",
        "plant:\n  storage: {kind: battery, capacity: 2 Ah, voltage_full: 20 V, voltage_empty: 24 V}\n",
        "plant.storage.voltage_empty: ",
    ),
    # references
    (WALL, "  torque: {kind: min", "  position: {kind: min", "reference.position.after: "),
    (
        WALL,
        "reference:\n  torque: {kind: minimum_jerk, start: 50 ms, duration: 100 ms, after: 2 N*m}\n",
        "",
        "reference.torque",
    ),
    (SWING, "  stiffness: {kind: minimum_jerk", "  torque: {kind: minimum_jerk", "reference.torque.before: "),
    (
        TUBE,
        "reference:\n",
        "reference:\n  stiffness: {kind: constant, value: 90 N*m/rad}\n",
        "reference.stiffness: no controller follows it",
    ),
    (KNEE, ", body_mass: 75 kg", "", "reference.torque.body_mass: is missing; a moment needs it"),
    (
        KNEE,
        "quantity: moment, body_mass: 75 kg",
        "quantity: angle",
        "reference.torque.quantity: angle is an angle, but",
    ),
    (SWING, SINE, "4 deg", 'reference.position: is "4 deg"; allowed is a mapping'),
    (
        SWING,
        SINE,
        "{kind: sum, parts: []}",
        "reference.position.parts: is a list; allowed is a list of 1 to 16 signals",
    ),
    (SWING, SINE, "{kind: sum, parts: [{kind: stp}]}", 'reference.position.parts.0.kind: unknown kind "stp"'),
    (SWING, SINE, "{kind: sum, parts: [{kind: step, tme: 1 s}]}", 'reference.position.parts.0: unknown field "tme"'),
    (
        SWING,
        SINE,
        f"{{kind: sum, parts: [{SINE}, {{kind: constant, value: 1 mm}}]}}",
        "reference.position.parts.1.value: ",
    ),
    # designs
    (WALL, "../series_elastic.yaml", "3", "design: is 3; allowed is text"),
    (
        WALL,
        "../series_elastic.yaml",
        "{name: x, actuator: {kind: series_elastc}}",
        "design.actuator.kind: unknown kind",
    ),
    (
        WALL,
        "../series_elastic.yaml",
        "{name: x, actuator: {kind: series_elastic, stiffness: 1 N*m, deflection: {min: -1 deg, max: 1 deg}}}",
        'design.actuator.stiffness: "1 N*m" is a torque; allowed is a rotational stiffness',
    ),
    (
        WALL,
        "../series_elastic.yaml",
        "{name: x, actuator: {kind: maccepa, spring: 1}}",
        "design.actuator: unknown field",
    ),
]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Where scenario files lie beside the example designs."""
    for design in EXAMPLES.glob("*.yaml"):
        shutil.copy(design, tmp_path)
    (tmp_path / "scenarios").mkdir()
    return tmp_path / "scenarios"


def text_of(name: str) -> str:
    return OWN[name] if name in OWN else (EXAMPLES / "scenarios" / f"{name}.yaml").read_text(encoding="utf-8")


@pytest.mark.parametrize("name, old, new, said", WRONG)
def test_a_wrong_scenario_is_one_line(folder: Path, name: str, old: str, new: str, said: str) -> None:
    text = text_of(name)
    assert old in text
    path = folder / "scenario.yaml"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load_scenario(path)
    line = str(caught.value)
    assert line.startswith(f"{path}: ")
    assert said in line
    assert line.isprintable()
    assert "pydantic" not in line
    assert "Input should" not in line
    assert len(line) < 500 + len(str(path))


@pytest.mark.parametrize("name", [KNEE, SPRING, TUBE])
def test_what_the_wrong_ones_differ_from_is_right(folder: Path, name: str) -> None:
    path = folder / "scenario.yaml"
    path.write_text(text_of(name), encoding="utf-8")
    assert load_scenario(path).name == name.capitalize()


@pytest.mark.parametrize(
    "data, file, said",
    [
        ("column: b, sign: same", "missing.csv", "cannot be read"),
        ("column: b, sign: same", "table.csv", "the column b is missing"),
        ("column: a, sign: opposite, unit: mm", "table.csv", "is a length; allowed is an angle"),
        ("column: a, sign: same", "table.csv", "column a: has no unit"),
        ("column: a, sign: same, unit: deg, periodic: true", "table.csv", "begins at 0"),
        ("column: a, sign: same, unit: deg, ends: clamped", None, "reference.position.ends: unknown choice"),
        ("column: a, sign: reversed, unit: deg", None, 'reference.position.sign: unknown choice "reversed"'),
        ("column: a, unit: deg", None, "reference.position.sign: is missing; it is required"),
        ("column: a, sign: same, body_mass: 70 kg", None, "reference.position.body_mass: is given, but only a torque"),
    ],
)
def test_a_wrong_trajectory_says_file_or_field(folder: Path, data: str, file: str | None, said: str) -> None:
    (folder / "table.csv").write_text("time [s],a\n0,0\n1,5\n2,3\n", encoding="utf-8")
    signal = f"{{kind: trajectory, file: {file or 'table.csv'}, {data}}}"
    path = folder / "scenario.yaml"
    path.write_text(text_of(SWING).replace(SINE, signal), encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load_scenario(path)
    assert str(caught.value).startswith(f"{path if file is None else folder / file}: ")
    assert said in str(caught.value)


def test_an_error_of_the_design_file_names_that_file(folder: Path) -> None:
    design = folder.parent / "series_elastic.yaml"
    design.write_text(design.read_text().replace("160 N*m/rad", "160 N*m"))
    path = folder / "scenario.yaml"
    path.write_text(text_of(WALL), encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load_scenario(path)
    assert str(caught.value).startswith(f"{folder / '../series_elastic.yaml'}: actuator.stiffness: ")


def test_several_scenarios_and_other_data_are_refused(folder: Path) -> None:
    path = folder / "scenario.yaml"
    for text, said in (
        ("name: a\n---\nname: b\n", "holds 2 scenarios (a, b); allowed is one scenario per file"),
        ("- 1\n", "is a list; allowed is a mapping with name, design, duration and plant"),
        ("name: a\n", "design: is missing; it is required (and 2 more problems)"),
    ):
        path.write_text(text)
        with pytest.raises(InputError) as caught:
            load_scenario(path)
        assert str(caught.value) == f"{path}: {said}"
    with pytest.raises(InputError, match="takes the path of a scenario file, not a int"):
        load_scenario(3)  # type: ignore[arg-type]  # what is refused


def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Paths of everything inside a document."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inside in items:
        yield (*path, key)
        yield from places(inside, (*path, key))


DOCUMENTS = [next(parse_yaml(text_of(name))) for name in (WALL, SWING, WANG, KNEE, SPRING, TUBE)]
ODD = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(max_size=20),
    st.just([]),
    st.just({}),
    st.sampled_from(["1 m", "1 deg", "1 N*m", "pid", "step", {"kind": "step"}, [{"kind": "sum"}], {"kind": ["x"]}]),
)


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(st.sampled_from(DOCUMENTS), st.data(), ODD, st.booleans())
def test_any_document_is_accepted_or_refused_in_one_line(
    document: dict[str, Any], data: st.DataObject, odd: Any, rename: bool
) -> None:
    changed = copy.deepcopy(document)
    *path, last = data.draw(st.sampled_from(list(places(changed))))
    inside: Any = changed
    for part in path:
        inside = inside[part]
    if rename and isinstance(inside, dict):
        inside["unheard_of"] = inside.pop(last)
    else:
        inside[last] = odd
    try:
        spec = validated_scenario(changed)
    except InputError as error:
        line = str(error)
        assert line.isprintable()
        assert "Input should" not in line
        assert len(line) < 700
    else:
        assert spec.duration > 0.0
        assert not rename or isinstance(inside, list)


def test_the_test_above_can_refuse() -> None:
    wrong: Callable[[], Any] = lambda: validated_scenario({**DOCUMENTS[0], "name": 3})  # noqa: E731  # used once
    with pytest.raises(InputError, match="name: is 3"):
        wrong()
