"""Smallest radius of a solid cylinder over the torque that it carries, for real plastics (Fig. 3 of the paper)."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from plastics import legend, plastics, smallest_radius

from varistiff.report.style import canvas, styled


def draw() -> Figure:
    """Draw one line per plastic."""
    torque = np.geomspace(0.5, 50.0, 121)
    with styled():
        figure, axes = canvas(height=4.2, right=0.78)
        for plastic in plastics():
            radius = [1e3 * smallest_radius(one, plastic.allowed) for one in torque]
            axes.plot(torque, radius, color=plastic.colour, linestyle=plastic.dashes)
        axes.set(xscale="log", yscale="log", xlim=(0.5, 50.0), ylim=(1.8, 40.0))
        axes.set_xticks([0.5, 1, 2, 5, 10, 20, 50], ["0.5", "1", "2", "5", "10", "20", "50"])
        axes.set_yticks([2, 5, 10, 20, 40], ["2", "5", "10", "20", "40"])
        axes.minorticks_off()
        axes.set(xlabel="Torque [N·m]", ylabel="Smallest radius [mm]")
        legend(figure, x=0.81)
    return figure
