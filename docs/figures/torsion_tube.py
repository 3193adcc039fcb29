"""The torsion tube: a counter bearing slides along a tube clamped at the drive side."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse, Rectangle
from style import DRIVE, ELASTIC, LABEL, MUTED, RIGID, arrow, dimension, ground, sheet


def draw() -> Figure:
    """Draw the tube from the side, a straight line on it turned by the twist."""
    figure, axes = sheet(7.2, 2.7)
    radius, length, active = 0.11, 1.6, 1.0
    ground(axes, (0, -0.26), (0, 0.26), depth=0.04)
    axes.add_patch(Rectangle((0, -radius), length, 2 * radius, facecolor="#fed7aa", edgecolor=ELASTIC, linewidth=1.6))
    axes.plot([0, length], [0, 0], color=MUTED, linewidth=0.8, linestyle="-.")
    along = np.linspace(0, active, 60)
    for start in (-0.75, 0.0, 0.75):
        twist = start + 0.7 * along / active
        axes.plot(along, radius * np.sin(twist), color=ELASTIC, linewidth=1.2)
        axes.plot([active, length], [radius * np.sin(start + 0.7)] * 2, color=ELASTIC, linewidth=1.2)
    axes.add_patch(Rectangle((active, radius), 0.1, 0.1, facecolor=DRIVE))
    axes.add_patch(Rectangle((active, -radius - 0.1), 0.1, 0.1, facecolor=DRIVE))
    axes.plot([active + 0.1, length + 0.18], [radius + 0.07] * 2, color=RIGID, linewidth=2)
    axes.plot([active + 0.1, length + 0.18], [-radius - 0.07] * 2, color=RIGID, linewidth=2)
    axes.add_patch(Ellipse((length, 0), 0.05, 2 * radius, facecolor="white", edgecolor=ELASTIC, linewidth=1.6))
    dimension(axes, (0, -0.27), (active, -0.27), "$x$", offset=(0, -0.06))
    arrow(axes, (active + 0.05, 0.32), (active + 0.28, 0.32), "setting", color=DRIVE, offset=(0.12, 0))
    axes.text(-0.07, 0, "drive", ha="right", va="center", rotation=90, **LABEL)
    axes.text(length + 0.2, 0, "link", ha="left", va="center", rotation=90, **LABEL)
    return figure
