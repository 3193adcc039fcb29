"""Active length over radius for the ends of a stiffness range, for real plastics (Fig. 4 of the paper)."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from plastics import legend, plastics, smallest_radius

from varistiff.report.style import INK, WIDTH, styled

STIFFNESSES = (350.0, 50.0)  # N m/rad
TORQUE = 10.0  # N m


def draw() -> Figure:
    """Draw the length that each end of the range needs, side by side on one scale."""
    with styled():
        figure = Figure(figsize=(WIDTH, 4.3))
        for number, stiffness in enumerate(STIFFNESSES):
            axes = figure.add_axes((0.1 + 0.355 * number, 0.145, 0.32, 0.76))
            _lines(axes, stiffness)
            axes.set_title(f"{stiffness:.0f} N·m/rad")
            axes.set_xlabel("Radius [mm]")
            if number:
                axes.tick_params(labelleft=False)
            else:
                axes.set_ylabel("Active length [mm]")
        legend(figure, x=0.80)
    return figure


def _lines(axes: Axes, stiffness: float) -> None:
    radius = np.linspace(5.0, 25.0, 161)
    axes.set(yscale="log", xlim=(5.0, 25.0), ylim=(1.0, 1000.0))
    axes.set_yticks([1, 10, 100, 1000], ["1", "10", "100", "1000"])
    axes.minorticks_off()
    for plastic in plastics():
        length = plastic.shear_modulus * 0.5 * math.pi * (1e-3 * radius) ** 4 / stiffness * 1e3
        axes.plot(radius, length, color=plastic.colour, linestyle=plastic.dashes)
        least = 1e3 * smallest_radius(TORQUE, plastic.allowed)
        if 5.0 < least < 25.0:
            at = np.interp(least, radius, length)
            if at > 1.0:
                axes.plot(least, at, "o", color=plastic.colour, markersize=7.0, markeredgecolor=INK, zorder=5.0)
