"""Equations of motion and of the energy account."""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.actuators.actuator import Response
from varistiff.dynamics.drives import DriveFlows, TorqueSource
from varistiff.dynamics.ledger import LOSSES, Ledger, Powers
from varistiff.dynamics.plant import Inertias, Member, Plant
from varistiff.dynamics.signals import Sample
from varistiff.dynamics.state import Command, Motion, State
from varistiff.dynamics.stop import StopForce, push
from varistiff.dynamics.storage import IdealSupply, StorageFlows, Supply

Scalar = Float[Array, ""]


class Outside(NamedTuple):
    """What acts from outside at an instant: load torque against +q, and the motion of a prescribed link."""

    torque: Scalar
    link: Sample


class Flows(NamedTuple):
    """Forces and powers at an instant."""

    response: Response
    drive: DriveFlows
    setting: DriveFlows
    storage: StorageFlows
    external_torque: Scalar
    link_acceleration: Scalar
    drive_acceleration: Scalar
    motion_acceleration: Scalar
    losses: Powers
    inflows: Powers
    turned: Scalar


class _Loads(NamedTuple):
    """Generalized forces on link, drive and setting without those from outside and of inertia, and stop powers."""

    link: Scalar
    drive: Scalar
    setting: Scalar
    stops: tuple[StopForce, ...]
    elastic_power: Scalar
    gravity_power: Scalar


def _loads(plant: Plant, motion: Motion, response: Response, drives: tuple[DriveFlows, DriveFlows]) -> _Loads:
    place = plant.setting_path.at(motion.motion)
    fall, slide = plant.weight(motion)
    stops = (
        push(plant.link.stop, motion.link, motion.link_rate),
        push(plant.drive.stop, motion.drive, motion.drive_rate),
        push(plant.setting.stop, motion.motion, motion.motion_rate),
        push(plant.deflection_stop, plant.deflection(motion), plant.deflection_rate(motion)),
    )
    between = response.load - stops[3].force  # the pair of forces between drive and link
    # a kind without a setting has no adjusting load, which is NaN
    adjusting = 0.0 * place.slope if plant.actuator.setting_unit is None else response.adjusting_load * place.slope
    link, drive, setting = plant.link.friction, plant.drive.friction, plant.setting.friction
    return _Loads(
        link=(between if plant.driven else -between) + fall + stops[0].force - link.force(motion.link_rate),
        drive=drives[0].torque - between + stops[1].force - drive.force(motion.drive_rate),
        setting=drives[1].torque - adjusting + slide + stops[2].force - setting.force(motion.motion_rate),
        stops=stops,
        elastic_power=response.load * plant.deflection_rate(motion) + adjusting * motion.motion_rate,
        gravity_power=-fall * motion.link_rate - slide * motion.motion_rate,
    )


def _accelerations(
    plant: Plant, motion: Motion, inertia: Inertias, loads: _Loads, outside: Outside
) -> tuple[Scalar, Scalar, Scalar, Scalar]:
    """Accelerations of link, drive and setting, and the torque from outside against the link."""
    own = motion.motion_rate
    coriolis_link, coriolis_drive = inertia.link_rate * own, inertia.drive_rate * own
    still = 0.0 * own
    torque = outside.torque
    if plant.link.mode == "prescribed":
        link = outside.link.acceleration
        torque = loads.link - inertia.link * link - coriolis_link * motion.link_rate
    elif plant.link.mode == "locked":
        link = still
    else:
        link = (loads.link - torque - coriolis_link * motion.link_rate) / inertia.link
    drive = still
    if plant.driven and plant.drive.mode == "free":
        drive = (loads.drive - coriolis_drive * motion.drive_rate) / inertia.drive
    setting = still
    if plant.setting.mode == "free":
        centrifugal = inertia.link_rate * motion.link_rate**2 + inertia.drive_rate * motion.drive_rate**2
        setting = (loads.setting + 0.5 * (centrifugal - inertia.setting_rate * own**2)) / inertia.setting
    return link, drive, setting, torque


def flows(plant: Plant, state: State, command: Command, outside: Outside) -> Flows:
    """Forces, accelerations and powers at an instant; every power from its own law."""
    motion, charge = state.motion, state.charge
    setting = plant.setting_path.at(motion.motion).value
    response, _ = plant.actuator.respond(plant.stretch(motion), setting)
    voltage = plant.storage.open_voltage(charge)
    drive = plant.drive_motor.flows(command.drive, motion.drive_rate, voltage, state.drive_heat.winding)
    adjust = plant.setting_motor.flows(command.setting, motion.motion_rate, voltage, state.setting_heat.winding)
    storage = plant.storage.flows(charge, drive.electrical_power + adjust.electrical_power)
    inertia = plant.inertias(motion)
    loads = _loads(plant, motion, response, (drive, adjust))
    link_a, drive_a, motion_a, torque = _accelerations(plant, motion, inertia, loads, outside)
    losses = _losses(plant, motion, loads, (drive, adjust), storage)
    inflows = {"external_work": -torque * motion.link_rate, "supplied": storage.supplied_power}
    kinetic = _kinetic_power(plant, motion, loads, torque)
    powers = (
        *losses.values(),
        *inflows.values(),
        loads.elastic_power,
        loads.gravity_power,
        storage.stored_power,
        kinetic,
    )
    turned = 0.5 * jnp.asarray(sum(abs(power) for power in powers))
    return Flows(response, drive, adjust, storage, torque, link_a, drive_a, motion_a, losses, inflows, turned)


def _kinetic_power(plant: Plant, motion: Motion, loads: _Loads, torque: Scalar) -> Scalar:
    """Magnitude of what the forces feed into the motion of each part, for the energy turned over only."""
    link = jnp.abs((loads.link - torque) * motion.link_rate)
    return link + jnp.abs(loads.drive * motion.drive_rate) + jnp.abs(loads.setting * motion.motion_rate)


def _losses(
    plant: Plant, motion: Motion, loads: _Loads, drives: tuple[DriveFlows, DriveFlows], storage: StorageFlows
) -> Powers:
    def rubbed(member: Member, rate: Scalar) -> Scalar:
        return member.friction.force(rate) * rate

    powers = {
        "copper_drive": drives[0].copper_power,
        "copper_setting": drives[1].copper_power,
        "gear_drive": drives[0].gear_power,
        "gear_setting": drives[1].gear_power,
        "friction_link": rubbed(plant.link, motion.link_rate),
        "friction_drive": rubbed(plant.drive, motion.drive_rate),
        "friction_setting": rubbed(plant.setting, motion.motion_rate),
        "stop_loss": loads.stops[0].loss + loads.stops[1].loss + loads.stops[2].loss + loads.stops[3].loss,
        "series_loss": storage.series_power,
        "leakage": storage.leakage_power,
        "converter_loss": storage.converter_power,
    }
    return {name: powers[name] for name in losses_of(plant)}


def losses_of(plant: Plant) -> tuple[str, ...]:
    """Names of the losses that this plant can have; what is zero by the kinds of its parts is not integrated."""
    stops = (plant.link.stop, plant.drive.stop, plant.setting.stop, plant.deflection_stop)
    never = {
        *({"copper_drive", "gear_drive"} if isinstance(plant.drive_motor, TorqueSource) else ()),
        *({"copper_setting", "gear_setting"} if isinstance(plant.setting_motor, TorqueSource) else ()),
        *({"friction_drive"} if not plant.driven or plant.drive.mode == "locked" else ()),
        *({"friction_setting"} if plant.setting.mode == "locked" else ()),
        *({"stop_loss"} if all(stop is None for stop in stops) else ()),
        *({"leakage"} if isinstance(plant.storage, Supply | IdealSupply) else ()),
        *({"series_loss", "converter_loss"} if isinstance(plant.storage, IdealSupply) else ()),
    }
    return tuple(name for name in LOSSES if name not in never)


def rates(plant: Plant, state: State, command: Command, outside: Outside) -> State:
    """Time derivative of the whole state."""
    motion = state.motion
    now = flows(plant, state, command, outside)
    return State(
        motion=Motion(
            motion.link_rate,
            now.link_acceleration,
            motion.drive_rate,
            now.drive_acceleration,
            motion.motion_rate,
            now.motion_acceleration,
        ),
        charge=now.storage.charge_rate,
        drive_heat=plant.drive_motor.heat_rates(state.drive_heat, now.drive.copper_power),
        setting_heat=plant.setting_motor.heat_rates(state.setting_heat, now.setting.copper_power),
        ledger=Ledger(losses=now.losses, inflows=now.inflows, turnover=now.turned),
    )
