"""From the plant of a scenario file to the joint as a mechanical and electrical system."""

from __future__ import annotations

import math
from typing import NamedTuple

from varistiff.core.errors import InputError
from varistiff.design.build_scenario_drives import (
    BuiltSetting,
    build_drive,
    build_setting,
    friction,
    locked_drive,
    stops,
)
from varistiff.design.scenario_fields import ROTARY, Measures
from varistiff.design.scenario_joint import Joint, inertia_of, within
from varistiff.design.scenario_plant_spec import (
    AnyStorageSpec,
    BatterySpec,
    GravitySpec,
    LinkSpec,
    PlantSpec,
    SupplySpec,
)
from varistiff.dynamics.path import Affine
from varistiff.dynamics.plant import Gravity, Member, Plant
from varistiff.dynamics.storage import Battery, IdealSupply, Storage, Supercapacitor, Supply

_STANDARD_GRAVITY = 9.80665  # m/s^2


class BuiltPlant(NamedTuple):
    """The plant, and what the setting drive's own coordinate measures; None for a kind without a setting."""

    plant: Plant
    setting: Measures | None


def build_plant(spec: PlantSpec, joint: Joint) -> BuiltPlant:
    """Return the plant that a spec states.

    Raises
    ------
    InputError : parts that do not fit each other or the design's kind
    """
    drive = build_drive(spec.drive, joint, "plant.drive")
    setting = build_setting(spec.setting_drive, joint, "plant.setting_drive")
    still = BuiltSetting(locked_drive(), joint.link, Affine(), None) if setting is None else setting
    if spec.deflection_stops is not None and not joint.driven:
        raise InputError(
            "is given, but the deflection of a semi-active joint is its link's position; give plant.link.stops",
            field="plant.deflection_stops",
        )
    plant = Plant(
        actuator=joint.design.actuator,
        link=_link(spec.link, joint, "plant.link"),
        drive=drive.member,
        setting=still.drive.member,
        setting_path=still.path,
        carried=still.carried,
        drive_motor=drive.motor,
        setting_motor=still.drive.motor,
        storage=_storage(spec.storage),
        gravity=_gravity(spec.link.gravity, joint, "plant.link.gravity"),
        backlash=None if spec.backlash is None else spec.backlash.of(joint.link.position, "plant.backlash"),
        deflection_stop=stops(spec.deflection_stops, joint.link, "plant.deflection_stops"),
        driven=joint.driven,
        motion_unit="m" if setting is not None and setting.measures is not ROTARY else "rad",
    )
    return BuiltPlant(plant, None if setting is None else setting.measures)


def _link(spec: LinkSpec, joint: Joint, field: str) -> Member:
    measures = joint.link
    inertia = inertia_of(spec, measures, field)
    if inertia is None:
        own = "inertia" if measures is ROTARY else "mass"
        raise InputError(f"is missing; {measures.inertia.allowed('above zero')}", field=f"{field}.{own}")
    return Member(inertia, friction(spec, measures, field), stops(spec.stops, measures, f"{field}.stops"), spec.motion)


def _gravity(spec: GravitySpec | None, joint: Joint, field: str) -> Gravity | None:
    if spec is None:
        return None
    if joint.link is not ROTARY:
        raise InputError(f"is given, but {joint.name} slides; give its constant weight as load.force", field=field)
    return Gravity(
        moment=spec.mass * _STANDARD_GRAVITY * spec.centre_of_mass, rest=spec.rest, acceleration=_STANDARD_GRAVITY
    )


def _storage(spec: AnyStorageSpec | None) -> Storage:
    if spec is None:
        return IdealSupply(voltage=48.0)
    with within("plant.storage"):
        if isinstance(spec, SupplySpec):
            return Supply(
                voltage=spec.voltage,
                series_resistance=spec.series_resistance,
                converter_efficiency=spec.converter_efficiency,
                regenerative=spec.regenerative,
            )
        leakage = math.inf if spec.leakage_resistance is None else spec.leakage_resistance
        if isinstance(spec, BatterySpec):
            return Battery(
                capacity=spec.capacity,
                voltage_full=spec.voltage_full,
                voltage_empty=spec.voltage_empty,
                series_resistance=spec.series_resistance,
                leakage_resistance=leakage,
                charge_share=spec.charge_share,
                converter_efficiency=spec.converter_efficiency,
                regenerative=spec.regenerative,
            )
        return Supercapacitor(
            capacitance=spec.capacitance,
            voltage=spec.voltage,
            series_resistance=spec.series_resistance,
            leakage_resistance=leakage,
            voltage_max=spec.voltage_max,
            converter_efficiency=spec.converter_efficiency,
            regenerative=spec.regenerative,
        )
