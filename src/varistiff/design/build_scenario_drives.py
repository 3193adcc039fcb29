"""From the drives of a scenario file to motors, kinematics and moving parts."""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp

from varistiff.actuators.slider_leaf_joint import SliderLeafJoint
from varistiff.core import quantity
from varistiff.core.errors import InputError
from varistiff.design.scenario_fields import LINEAR, PURE_NUMBER, ROTARY, Measures
from varistiff.design.scenario_joint import Joint, inertia_of, si, within
from varistiff.design.scenario_plant_spec import (
    BeltSpec,
    CarriedMassSpec,
    DirectSpec,
    DriveSpec,
    DryFrictionSpec,
    GrooveTransmissionSpec,
    LineSpec,
    LinkSpec,
    MainDriveSpec,
    MotorSpec,
    ScrewSpec,
    SettingDriveSpec,
    StopsSpec,
)
from varistiff.dynamics.carried_mass import CarriedMass
from varistiff.dynamics.control import motion_of_setting
from varistiff.dynamics.drives import Drive, Motor, TorqueSource, TwoNodeHeating, motor, motor_data
from varistiff.dynamics.friction import DryFriction, Friction
from varistiff.dynamics.path import Affine, GroovePath, Path
from varistiff.dynamics.plant import Member
from varistiff.dynamics.stop import Stop

_AXIAL = ("torsion_tube",)  # the setting slides along the axis: what it carries turns with nothing


class BuiltDrive(NamedTuple):
    """A drive: what turns a command into torque, and what it moves."""

    motor: Drive
    member: Member


class BuiltSetting(NamedTuple):
    """The setting drive, what its coordinate measures, its kinematics and the mass that it moves."""

    drive: BuiltDrive
    measures: Measures
    path: Path
    carried: CarriedMass | None


def friction(part: LinkSpec | DriveSpec, measures: Measures, field: str) -> Friction:
    """Friction of a moving part."""
    viscous = si(part.viscous_friction, measures.damping, f"{field}.viscous_friction")
    dry = part.dry_friction
    return Friction(viscous, None if dry is None else _dry_friction(dry, measures, f"{field}.dry_friction"))


def _dry_friction(spec: DryFrictionSpec, measures: Measures, field: str) -> DryFriction:
    given = {
        "breakaway": (spec.breakaway, measures.load),
        "stribeck_rate": (spec.stribeck_rate, measures.rate),
        "smoothing_rate": (spec.smoothing_rate, measures.rate),
    }
    numbers = {name: amount.of(kind, f"{field}.{name}") for name, (amount, kind) in given.items() if amount is not None}
    return DryFriction(coulomb=spec.coulomb.of(measures.load, f"{field}.coulomb"), **numbers)


def stops(spec: StopsSpec | None, measures: Measures, field: str) -> Stop | None:
    """Stops of a part, in its own coordinate."""
    if spec is None:
        return None
    return Stop(
        lower=si(spec.min, measures.position, f"{field}.min", default=-math.inf),
        upper=si(spec.max, measures.position, f"{field}.max", default=math.inf),
        stiffness=spec.stiffness.of(measures.stiffness, f"{field}.stiffness"),
        damping=si(spec.damping, measures.time_per_position, f"{field}.damping"),
    )


def locked_drive() -> BuiltDrive:
    """A drive that stays where it starts."""
    return BuiltDrive(TorqueSource(), Member(mode="locked"))


def build_drive(spec: MainDriveSpec | None, joint: Joint, field: str) -> BuiltDrive:
    """The main drive.

    Raises
    ------
    InputError : the joint has none, or the drive does not fit what it moves
    """
    joint.check_driven(spec, field)
    if spec is None:
        return locked_drive()
    measures, slide = joint.link, spec.transmission
    if slide is not None and (measures is ROTARY or spec.motor is None):
        why = f"the drive of {joint.name} turns" if measures is ROTARY else "there is no motor"
        raise InputError(f"is given, but {why}; leave it out", field=f"{field}.transmission")
    if slide is None and measures is LINEAR and spec.motor is not None:
        raise InputError(
            f"is missing; a motor turns, and {joint.name} slides: allowed: screw, belt", field=f"{field}.transmission"
        )
    ratio = 1.0 if slide is None else 1.0 / _length_per_angle(slide)
    return _drive(spec, measures, ratio, stops(spec.stops, measures, f"{field}.stops"), field, carried=False)


def _length_per_angle(slide: ScrewSpec | BeltSpec) -> float:
    return slide.lead / (2.0 * math.pi) if isinstance(slide, ScrewSpec) else slide.pulley_radius


def _drive(
    spec: DriveSpec, measures: Measures, ratio: float, stop: Stop | None, field: str, *, carried: bool
) -> BuiltDrive:
    """A drive whose gear's output turns ``ratio`` as far as the coordinate."""
    source = _source(spec, measures, ratio, field)
    inertia = inertia_of(spec, measures, field) or 0.0
    if spec.motion == "free" and not carried and inertia + source.reflected_inertia <= 0.0:
        own = "inertia" if measures is ROTARY else "mass"
        raise InputError(
            f"is missing; a drive that moves needs it, or a motor; {measures.inertia.allowed('above zero')}",
            field=f"{field}.{own}",
        )
    return BuiltDrive(source, Member(inertia, friction(spec, measures, field), stop, spec.motion))


def _source(spec: DriveSpec, measures: Measures, ratio: float, field: str) -> Drive:
    own, other = ("torque_limit", "force_limit") if measures is ROTARY else ("force_limit", "torque_limit")
    if getattr(spec, other) is not None:
        raise InputError(f"is given, but this drive {measures.word}; give {own} instead", field=f"{field}.{other}")
    if spec.motor is None:
        return TorqueSource(limit=si(getattr(spec, own), measures.load, f"{field}.{own}", default=math.inf))
    gear_ratio = ratio * (1.0 if spec.gear_ratio is None else spec.gear_ratio)
    efficiency = 1.0 if spec.gear_efficiency is None else spec.gear_efficiency
    gear_inertia = spec.gear_inertia or 0.0
    if isinstance(spec.motor, MotorSpec):
        return _own_motor(spec.motor, spec, gear_ratio, efficiency, gear_inertia)
    with within(f"{field}.motor"):
        motor_data(spec.motor)
    return motor(
        spec.motor,
        gear_ratio=gear_ratio,
        gear_efficiency=efficiency,
        gear_inertia=gear_inertia,
        current_limit=spec.current_limit,
        voltage_limit=spec.voltage_limit,
    )


def _own_motor(data: MotorSpec, spec: DriveSpec, gear_ratio: float, efficiency: float, gear_inertia: float) -> Motor:
    heating = data.heating
    return Motor(
        torque_constant=data.torque_constant,
        resistance=data.resistance,
        rotor_inertia=data.rotor_inertia,
        gear_ratio=gear_ratio,
        gear_efficiency=efficiency,
        gear_inertia=gear_inertia,
        current_limit=math.inf if spec.current_limit is None else spec.current_limit,
        voltage_limit=math.inf if spec.voltage_limit is None else spec.voltage_limit,
        friction_torque=data.torque_constant * data.no_load_current,
        viscous_friction=data.viscous_friction,
        resistance_coefficient=data.resistance_coefficient,
        thermal=None
        if heating is None
        else TwoNodeHeating(
            winding_resistance=heating.winding_resistance,
            housing_resistance=heating.housing_resistance,
            winding_time=heating.winding_time,
            motor_time=heating.motor_time,
            rise_limit=heating.rise_limit,
        ),
    )


def build_setting(spec: SettingDriveSpec | None, joint: Joint, field: str) -> BuiltSetting | None:
    """The setting drive with its kinematics; locked where there is no spec, None for a kind without a setting.

    Raises
    ------
    InputError : the kind has no setting, or parts do not fit together
    """
    joint.check_setting(spec, field)
    setting = joint.setting
    if setting is None:
        return None
    if spec is None:
        return BuiltSetting(locked_drive(), setting, Affine(), None)
    measures, path = _path(spec, joint, setting, f"{field}.transmission")
    if spec.motor is not None and measures is LINEAR:
        raise InputError(
            "is missing; a motor turns, and this setting is a length: allowed: screw, belt, line, groove",
            field=f"{field}.transmission",
        )
    carried = None if spec.carried_mass is None else _carried(spec.carried_mass, joint, path, f"{field}.carried_mass")
    stop = _setting_stops(spec.stops, setting, measures, path, f"{field}.stops")
    # a mass that the groove moves has no inertia where the groove runs along a circle
    moves_mass = carried is not None and isinstance(carried.radius, Affine)
    return BuiltSetting(_drive(spec, measures, 1.0, stop, field, carried=moves_mass), measures, path, carried)


def _path(spec: SettingDriveSpec, joint: Joint, setting: Measures, field: str) -> tuple[Measures, Path]:
    """What the setting drive's own coordinate measures, and the setting over it."""
    way = spec.transmission
    if way is None or isinstance(way, DirectSpec):
        return setting, Affine()
    if isinstance(way, LineSpec):
        slope_kind = quantity.LENGTH_PER_ANGLE if setting is LINEAR else PURE_NUMBER
        start = way.start.of(setting.position, f"{field}.start")
        return ROTARY, Affine(start, way.slope.of(slope_kind, f"{field}.slope"))
    if setting is ROTARY:
        raise InputError(f"{way.kind} moves a length, and this setting is an angle; allowed: direct, line", field=field)
    if isinstance(way, GrooveTransmissionSpec):
        actuator = joint.design.actuator
        if not isinstance(actuator, SliderLeafJoint) or actuator.groove is None:
            raise InputError(
                "groove is given, but the design has none; allowed: direct, screw, belt, line", field=field
            )
        return ROTARY, GroovePath(actuator.groove)
    return ROTARY, Affine(0.0, _length_per_angle(way))


def _carried(spec: CarriedMassSpec, joint: Joint, path: Path, field: str) -> CarriedMass:
    if spec.on == "drive":
        joint.check_driven(spec, f"{field}.on")
    if spec.on != "ground" and joint.link is LINEAR:
        raise InputError(
            f"{spec.on} is given, but {joint.name} slides: add the mass to it, and choose ground here",
            field=f"{field}.on",
        )
    if spec.on != "ground" and joint.kind in _AXIAL:
        raise InputError(
            f"{spec.on} is given, but the setting of {joint.name} slides along the axis; allowed: ground",
            field=f"{field}.on",
        )
    actuator = joint.design.actuator
    slider = actuator if isinstance(actuator, SliderLeafJoint) else None
    offset = spec.radius_offset
    if offset is None:
        offset = 0.0 if slider is None else slider.clamp_radius
    if slider is not None and slider.driven_by == "disc":
        if slider.groove is None or not isinstance(path, Affine) or (path.start, path.ratio) != (0.0, 1.0):
            raise InputError("needs a direct drive where the setting is the disc angle", field=field)
        return CarriedMass(spec.mass, GroovePath(slider.groove, offset), spec.on)
    if isinstance(path, GroovePath):
        return CarriedMass(spec.mass, GroovePath(path.groove, offset), spec.on)
    if not isinstance(path, Affine):
        raise AssertionError(f"no mass is carried along a {type(path).__name__}")
    return CarriedMass(spec.mass, Affine(path.start + offset, path.ratio), spec.on)


def _setting_stops(
    spec: StopsSpec | None, setting: Measures, measures: Measures, path: Path, field: str
) -> Stop | None:
    """Stops of the setting drive: ends that are no angle are settings, and become ends of its own coordinate."""
    if spec is None or setting is measures:
        return stops(spec, measures, field)
    given = [end for end in (spec.min, spec.max) if end is not None]
    if any(end.kind is measures.position for end in given):
        return stops(spec, measures, field)
    ends = [
        (name, float(motion_of_setting(path, end.of(setting.position, f"{field}.{name}"))))
        for name, end in (("min", spec.min), ("max", spec.max))
        if end is not None
    ]
    for name, end in ends:
        if math.isnan(end):
            raise InputError("is a setting that the groove does not have", field=f"{field}.{name}")
    falling = float(path.at(jnp.asarray(ends[0][1])).slope) < 0.0
    low, high = ("max", "min") if falling else ("min", "max")
    found = dict(ends)
    return Stop(
        lower=found.get(low, -math.inf),
        upper=found.get(high, math.inf),
        stiffness=spec.stiffness.of(measures.stiffness, f"{field}.stiffness"),
        damping=si(spec.damping, measures.time_per_position, f"{field}.damping"),
    )
