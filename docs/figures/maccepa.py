"""MACCEPA: a lever, an anchor on the link and a preloaded spring in the cable between them."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from style import DRIVE, ELASTIC, LABEL, MUTED, RIGID, angle, dimension, joint, sheet


def draw() -> Figure:
    """Draw the triangle of lever, anchor distance and cable."""
    figure, axes = sheet(7.2, 2.7)
    turn, lever, anchor = np.radians(48), 0.5, 1.5
    tip = lever * np.array([np.cos(turn), np.sin(turn)])
    hook = np.array([anchor, 0.0])
    axes.plot([0, anchor + 0.45], [0, 0], color=RIGID, linewidth=3, solid_capstyle="round")
    axes.plot(*np.transpose([(0, 0), tip]), color=DRIVE, linewidth=3, solid_capstyle="round")
    axes.plot(*np.transpose([tip, hook]), color=MUTED, linewidth=1.4)
    along = np.linspace(0.05, 0.38, 120)
    axes.plot(anchor + along, 0.07 + 0.035 * np.sin(np.linspace(0, 18 * np.pi, 120)), color=ELASTIC, linewidth=1.4)
    axes.plot([anchor, anchor + 0.05], [0.0, 0.07], color=MUTED, linewidth=1.4)
    joint(axes, (0, 0), 0.035)
    joint(axes, tip, 0.02)
    joint(axes, hook, 0.02)
    angle(axes, (0, 0), 0.24, 0, turn, r"$\varphi$", reach=1.25)
    axes.text(*(tip / 2 + [-0.06, 0.05]), "$B$", ha="center", va="center", **LABEL)
    axes.text(*((tip + hook) / 2 + [0.03, 0.06]), "$A$", ha="center", va="center", **LABEL)
    dimension(axes, (0, -0.12), (anchor, -0.12), "$C$", offset=(0, -0.07))
    return figure
