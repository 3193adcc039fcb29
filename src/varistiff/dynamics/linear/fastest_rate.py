"""The fastest motion that a plant is capable of: what an integration step has to resolve."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator

import jax.numpy as jnp
import numpy as np

from varistiff.dynamics.drives import Drive, Motor
from varistiff.dynamics.linear.matrices import free_states, plant_matrices
from varistiff.dynamics.linear.state_at import Scalar, first_load, motion_of, standing, start_of
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.program import Case
from varistiff.dynamics.state import Command, Motion
from varistiff.dynamics.stop import Stop

_TRAVEL = 7  # points over the travel of a setting or deflection between its stops
_CONTACT = (0.01, 0.03, 0.1, 0.3)  # deflections [rad] at which an element that is free at rest may bear
_VISITED = 48  # states of a run that are looked at
_NO_VOLTAGE = 1e-9  # [V]
_PRESSED = 1e-9  # depth [rad or m] in a stop at which its spring counts


def fastest_rate(case: Case, *, visited: Motion | None = None, duration: float = 0.0, stops: bool = True) -> float:
    """Largest magnitude of an eigenvalue of the plant [1/s].

    Looked at are the start, moving and at rest (where dry friction is steepest), the travel of setting and deflection
    between their stops, deflections beyond a play and where a loose element bears, and a prescribed link along its
    motion; each with every stop in contact at once, with motors at their current limit, and with motors shorted, as the
    voltage limit does. Points off the map are passed over. Control is no part of it: it is sampled.

    A step h of the classical Runge-Kutta method is stable for a rate times h up to 2.6, and errs by (rate h)^5/120 a
    step, which is 3e-6 at 0.2.

    Parameters
    ----------
    visited : motions that a run went through, arrays of one shape; they are looked at too
    duration : of the motion of a prescribed link [s]
    stops : whether the springs of the stops count; without them the rate is that of motions that reach none

    Returns
    -------
    0 where nothing is free, or no point is on the map.

    Notes
    -----
    Hairer and Wanner (1996), Solving Ordinary Differential Equations II, IV.2, doi 10.1007/978-3-642-05221-7.
    """
    if not free_states(case.plant):
        return 0.0
    fastest, load = 0.0, first_load(case)
    for motion in _points(case, visited, duration):
        for plant, command in _variants(case.plant, motion, stops=stops):
            a = plant_matrices(plant, motion, command=command, external_torque=load).a
            if np.isfinite(a).all():
                fastest = max(fastest, float(np.max(np.abs(np.linalg.eigvals(a)))))
    return fastest


def _points(case: Case, visited: Motion | None, duration: float) -> Iterator[Motion]:
    plant = case.plant
    start = start_of(case)
    still = standing(float(start.link), float(start.drive), float(start.motion))
    yield from (start, still)
    if plant.link.mode == "prescribed" and duration > 0.0:
        link = case.inputs.link_sample(jnp.linspace(0.0, duration, _VISITED))
        for position, rate in zip(link.value, link.rate, strict=True):
            yield start._replace(link=position, link_rate=rate)
    for z in _travel(plant.setting.stop):
        yield still._replace(motion=jnp.asarray(z))
    deflections = _travel(plant.deflection_stop)
    if plant.actuator.loses_contact:
        deflections += [sign * value for value in _CONTACT for sign in (1.0, -1.0)]
    if plant.backlash is not None:
        deflections += [sign * (0.5 * plant.backlash + _PRESSED) for sign in (1.0, -1.0)]
    for deflection in deflections:
        yield _deflected(plant, still, deflection)
    if visited is not None:
        rows = np.stack([np.ravel(values) for values in visited])
        chosen = np.unique(np.linspace(0, rows.shape[1] - 1, _VISITED).astype(int))
        yield from (motion_of(rows[:, index]) for index in chosen)


def _travel(stop: Stop | None) -> list[float]:
    if stop is None or not (math.isfinite(stop.lower) and math.isfinite(stop.upper)):
        return []
    inset = _PRESSED * (stop.upper - stop.lower)  # at the very end half the stop's stiffness would count
    return [float(value) for value in np.linspace(stop.lower + inset, stop.upper - inset, _TRAVEL)]


def _deflected(plant: Plant, motion: Motion, deflection: float) -> Motion:
    """The same with another deflection: the drive gives way, or the link of a semi-active joint."""
    if plant.driven:
        return motion._replace(drive=motion.link + deflection)
    return motion._replace(link=jnp.asarray(deflection))


def _variants(plant: Plant, motion: Motion, *, stops: bool) -> Iterator[tuple[Plant, Command]]:
    """The plant on each branch of its equations that this point could be on."""
    nothing = Command(jnp.asarray(0.0), jnp.asarray(0.0))
    yield plant, nothing
    pressed = plant
    parts = (plant.link.stop, plant.drive.stop, plant.setting.stop, plant.deflection_stop)
    if stops and any(stop is not None for stop in parts):
        pressed = _pressed(plant, motion)
        yield pressed, nothing
    motors = plant.drive_motor, plant.setting_motor
    if any(isinstance(motor, Motor) for motor in motors):
        most = Command(*(jnp.asarray(_most(motor)) for motor in motors))
        yield pressed, most
        drive, setting = (_shorted(motor) for motor in motors)
        yield dataclasses.replace(pressed, drive_motor=drive, setting_motor=setting), most


def _most(motor: Drive) -> float:
    """A command just inside the current limit, where gear losses are steepest; 1 N m or N without a limit."""
    limit = float(motor.torque_limit)
    return (1.0 - 1e-6) * limit if math.isfinite(limit) else 1.0


def _shorted(motor: Drive) -> Drive:
    """The same motor with next to no voltage: any command then leaves only the braking by its back-EMF."""
    return dataclasses.replace(motor, voltage_limit=_NO_VOLTAGE) if isinstance(motor, Motor) else motor


def _pressed(plant: Plant, motion: Motion) -> Plant:
    """The same plant with every stop moved to where it just bears."""

    def at(stop: Stop | None, position: Scalar) -> Stop | None:
        return None if stop is None else dataclasses.replace(stop, lower=-math.inf, upper=float(position) - _PRESSED)

    return dataclasses.replace(
        plant,
        link=dataclasses.replace(plant.link, stop=at(plant.link.stop, motion.link)),
        drive=dataclasses.replace(plant.drive, stop=at(plant.drive.stop, motion.drive)),
        setting=dataclasses.replace(plant.setting, stop=at(plant.setting.stop, motion.motion)),
        deflection_stop=at(plant.deflection_stop, plant.deflection(motion)),
    )
