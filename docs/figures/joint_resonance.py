"""Resonance and antiresonance of a slider leaf joint over its active length; the inertias are examples."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np
from matplotlib.figure import Figure

from varistiff.actuators import SliderLeafJoint
from varistiff.dynamics.control_loop import ControlLoop, Inputs
from varistiff.dynamics.friction import Friction
from varistiff.dynamics.linear import resonance_over_settings
from varistiff.dynamics.plant import Member, Plant
from varistiff.dynamics.program import Case
from varistiff.dynamics.state import Motion
from varistiff.elastic.leaf import Leaf
from varistiff.report.simulation_linear import draw_resonance

LINK, DRIVE = 0.05, 0.02  # kg m^2; the paper publishes none


def joint() -> Case:
    """Return the joint of Wang et al. at rest, its setting the active length itself."""
    leaf = Leaf(youngs_modulus=206e9, width=0.025, thickness=0.001)
    device = SliderLeafJoint(leaf=leaf, count=1, clamp_radius=0.025)
    plant = Plant(device, link=Member(LINK, Friction(0.2)), drive=Member(DRIVE, Friction(0.1)))
    zero = jnp.asarray(0.0)
    return Case(plant, ControlLoop(), Inputs(), Motion(zero, zero, zero, zero, jnp.asarray(0.02), zero), 1e-3)


def draw() -> Figure:
    """Draw both over active lengths from 6 mm to 25 mm."""
    return draw_resonance(resonance_over_settings(joint(), np.linspace(0.006, 0.025, 96))).figure
