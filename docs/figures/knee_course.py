"""The roller's course over a step of level walking, and the moment that the beam gives on it."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
from matplotlib.figure import Figure
from style import DRIVE, ELASTIC, MUTED

from varistiff.actuators import RollerBeam
from varistiff.actuators.rollers import SwivellingPair
from varistiff.characteristic.evaluate import evaluate
from varistiff.dynamics.gait import knee_gait
from varistiff.dynamics.gait.knee_trajectory import knee_trajectory
from varistiff.dynamics.signals import Samples
from varistiff.elastic.leaf import Leaf

BODY_MASS = 80.0  # kg
COURSE = Path(__file__).parents[2] / "examples" / "scenarios" / "knee_roller.csv"


@cache
def beam() -> RollerBeam:
    """Return the beam of examples/scenarios/knee_beam.yaml."""
    leaf = Leaf(youngs_modulus=126e9, width=0.12, thickness=1.6e-3, length=0.5, yield_strength=1480e6)
    return RollerBeam(leaf, SwivellingPair(offset=0.1, clearance=1e-4), mounting_angle=-math.pi / 3.0)


def draw() -> Figure:
    """Draw moments above and the roller's place below, over the share of the cycle."""
    gait = knee_gait()
    static = knee_trajectory(beam(), gait, body_mass=BODY_MASS, setting_min=0.06, setting_max=0.4, samples=200)
    instants, places = np.loadtxt(COURSE, delimiter=",", skiprows=1, unpack=True)
    instants[-1] = gait.cycle_duration
    course = Samples.through(list(instants), list(1e-3 * places), periodic=True)
    place = np.asarray(jax.vmap(lambda now: course.at(now).value)(jnp.asarray(static.time)))
    share = 100.0 * static.time / gait.cycle_duration
    figure = Figure(figsize=(7.2, 5.2), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True)
    above.plot(share, static.wanted, color=DRIVE, linewidth=2.0, label="knee, 80 kg")
    above.plot(share, evaluate(beam(), static.angle, place).load, color=ELASTIC, label="beam on the course")
    above.axhline(0.0, color=MUTED, linewidth=0.8)
    above.set(ylabel="extensor moment [N m]")
    above.legend(frameon=False)
    below.plot(share, 1e3 * place, color=ELASTIC, label="course")
    exact = np.where(static.followed, static.setting, np.nan)
    below.plot(share, 1e3 * exact, ".", color=DRIVE, markersize=4, label="exact moment")
    nearest = np.where(static.followed, np.nan, static.setting)
    below.plot(share, 1e3 * nearest, ".", color=MUTED, markersize=4, label="nearest to it")
    below.set(xlabel="gait cycle [%]", ylabel="roller [mm]")
    below.legend(frameon=False)
    return figure
