"""Moment of the regenerative knee's beam over flexion at several places of the roller, and the moment of walking."""

from __future__ import annotations

import jax
import jax.numpy as jnp
import numpy as np
from knee_course import BODY_MASS, beam
from matplotlib.figure import Figure
from style import DRIVE, ELASTIC, MUTED

from varistiff.characteristic.evaluate import evaluate
from varistiff.dynamics.gait import knee_gait

PLACES = (0.065, 0.08, 0.1, 0.14, 0.2, 0.4)


def draw() -> Figure:
    """Draw the loads and the loop of the knee over flexion."""
    figure = Figure(figsize=(7.2, 4.2), layout="constrained")
    axes = figure.add_subplot()
    flexion = np.radians(np.linspace(0.0, 66.0, 133))
    for place in PLACES:
        load = evaluate(beam(), flexion, place).load
        shown = np.abs(load) < 70.0
        axes.plot(np.degrees(flexion[shown]), load[shown], color=ELASTIC, linewidth=1.2)
        last = int(np.flatnonzero(shown)[-1])
        axes.annotate(f" {1e3 * place:.0f} mm", (np.degrees(flexion[last]), load[last]), fontsize=8, color=ELASTIC)
    gait = knee_gait()
    time = jnp.linspace(0.0, gait.cycle_duration, 401)
    angle = np.degrees(np.asarray(jax.vmap(gait.angle.at)(time).value))
    moment = np.asarray(jax.vmap(gait.moment(BODY_MASS).at)(time).value)
    axes.plot(angle, moment, color=DRIVE, linewidth=2.0)
    axes.axhline(0.0, color=MUTED, linewidth=0.8)
    axes.set(xlabel="flexion [deg]", ylabel="extensor moment [N m]", xlim=(-2.0, 73.0), ylim=(-50.0, 78.0))
    return figure
