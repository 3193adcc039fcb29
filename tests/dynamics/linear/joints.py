"""Joints whose linear behaviour is known in closed form."""

from __future__ import annotations

import math
from typing import Any

import jax.numpy as jnp

from varistiff.actuators import Maccepa, SeriesElastic
from varistiff.dynamics.control_loop import ControlLoop, Inputs
from varistiff.dynamics.friction import Friction
from varistiff.dynamics.path import Affine
from varistiff.dynamics.plant import Gravity, Member, Plant
from varistiff.dynamics.program import Case
from varistiff.dynamics.signals import Constant
from varistiff.dynamics.state import Motion

STIFFNESS, LINK, DRIVE = 160.0, 0.1, 0.025  # N m/rad, kg m^2, kg m^2
SPRING_RATE, LEVER, ANCHOR = 394.0, 0.036, 0.135  # of the MACCEPA: N/m, m, m
SCREW = 0.003  # m/rad: 19 mm a turn
PERIOD = 1e-3  # s


def two_mass(*, link_damping: float = 0.0, drive_damping: float = 0.0, weight: float = 0.0, **changes: Any) -> Plant:
    """Two inertias and a linear spring, the link a pendulum if it has a weight m g l [N m]."""
    parts: dict[str, Any] = {
        "link": Member(LINK, Friction(link_damping)),
        "drive": Member(DRIVE, Friction(drive_damping)),
        "gravity": Gravity(weight) if weight else None,
    }
    return Plant(SeriesElastic(stiffness=STIFFNESS), **{**parts, **changes})


def maccepa(**changes: Any) -> Plant:
    """A joint with a setting: the pretension, wound by a screw."""
    parts: dict[str, Any] = {
        "link": Member(LINK),
        "drive": Member(DRIVE),
        "setting": Member(2e-4),
        "setting_path": Affine(start=0.002, ratio=SCREW),
    }
    device = Maccepa(spring_rate=SPRING_RATE, lever_length=LEVER, anchor_distance=ANCHOR)
    return Plant(device, **{**parts, **changes})


def maccepa_stiffness(pretension: float, deflection: float = 0.0) -> float:
    """k (A'^2 + e A''), at rest k P B C/|C - B|; docs/theory/series_elastic_and_maccepa.md."""
    product = LEVER * ANCHOR
    length = math.sqrt(LEVER**2 + ANCHOR**2 - 2.0 * product * math.cos(deflection))
    slope = product * math.sin(deflection) / length
    bend = (product * math.cos(deflection) - slope**2) / length
    return SPRING_RATE * (slope**2 + (length + pretension - (ANCHOR - LEVER)) * bend)


def moving(link: float = 0.0, drive: float = 0.0, motion: float = 0.0, rates: tuple[float, float, float] = (0, 0, 0)):
    """Positions and rates of link, drive and setting drive."""
    values = (link, rates[0], drive, rates[1], motion, rates[2])
    return Motion(*(jnp.asarray(float(value)) for value in values))


def case(plant: Plant, motion: Motion | None = None, *, load: float = 0.0, loop: ControlLoop | None = None) -> Case:
    """A case of a plant with a constant external torque."""
    inputs = Inputs(load=Constant(load))
    return Case(plant, loop or ControlLoop(), inputs, moving() if motion is None else motion, PERIOD)
