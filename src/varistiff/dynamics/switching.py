"""Switching functions of a plant: their signs tell the branch of the equations."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.core.status import Status
from varistiff.dynamics.control_loop import Inputs
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.state import Motion, State

Scalar = Float[Array, ""]
Switch = Callable[[Plant, Scalar, State], Scalar]


def switch_names(plant: Plant, inputs: Inputs, duration: float) -> tuple[str, ...]:
    """Which switchings the equations of this plant have; decided once, from its parameters.

    Names are ``link_lower``, ``link_upper`` (and so on for drive, setting, deflection), ``backlash_lower``,
    ``backlash_upper``, ``contact`` and ``break <seconds>`` for jumps of the inputs.
    """
    names = []
    stops = {
        "link": plant.link.stop,
        "drive": plant.drive.stop,
        "setting": plant.setting.stop,
        "deflection": plant.deflection_stop,
    }
    for part, stop in stops.items():
        if stop is not None:
            names += [f"{part}_lower"] if math.isfinite(stop.lower) else []
            names += [f"{part}_upper"] if math.isfinite(stop.upper) else []
    if plant.backlash is not None:
        names += ["backlash_lower", "backlash_upper"]
    if plant.actuator.loses_contact:
        names.append("contact")
    names += [f"break {instant!r}" for instant in inputs.breaks if 0.0 < instant < duration]
    return tuple(names)


def switch_values(names: tuple[str, ...], plant: Plant, time: Scalar, state: State) -> tuple[Scalar, ...]:
    """Value of each switching function; zero counts as positive."""
    return tuple(_value(name, plant, time, state.motion) for name in names)


def _value(name: str, plant: Plant, time: Scalar, motion: Motion) -> Scalar:
    if name.startswith("break "):
        return time - float(name.removeprefix("break "))
    if name == "contact":
        setting = plant.setting_path.at(motion.motion).value
        status = plant.actuator.respond(plant.stretch(motion), setting)[0].status
        return jnp.where(status == Status.NO_CONTACT, -1.0, 1.0)
    part, end = name.rsplit("_", 1)
    position, stop = _travel(part, plant, motion)
    lower, upper = stop
    return position - lower if end == "lower" else upper - position


def _travel(part: str, plant: Plant, motion: Motion) -> tuple[Scalar, tuple[Any, Any]]:
    if part == "backlash":
        assert plant.backlash is not None
        return plant.deflection(motion), (-0.5 * plant.backlash, 0.5 * plant.backlash)
    position, stop = {
        "link": (motion.link, plant.link.stop),
        "drive": (motion.drive, plant.drive.stop),
        "setting": (motion.motion, plant.setting.stop),
        "deflection": (plant.deflection(motion), plant.deflection_stop),
    }[part]
    assert stop is not None
    return position, (stop.lower, stop.upper)
