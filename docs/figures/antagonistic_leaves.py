"""The antagonistic leaves: four leaves between one nut pair and four rollers."""

from __future__ import annotations

import numpy as np
from elastica import leaf_shape
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Wedge
from style import DRIVE, ELASTIC, MUTED, RIGID, arrow, dimension, sheet


def draw() -> Figure:
    """Draw the spring at rest, in the middle of its travel."""
    figure, axes = sheet(7.2, 3.6)
    half = leaf_shape(np.radians(32), 0.62)
    span, height = 2 * half[-1]
    gap, radius, inner = 0.5, 0.12, 0.14
    leaf = np.vstack([half, 2 * half[-1] - half[::-1]])  # point-symmetric about its middle
    roller, outer = gap / 2 + span, inner + height
    axes.plot([-roller - 0.3, roller + 0.3], [0, 0], color=MUTED, linewidth=0.8, linestyle="-.")
    axes.plot([-gap / 2, gap / 2], [0, 0], color=DRIVE, linewidth=3)
    for side in (-1, 1):
        axes.plot([side * gap / 2] * 2, [-outer, outer], color=DRIVE, linewidth=2)
        for way in (-1, 1):
            nut = (side * gap / 2, way * (outer - radius))
            toward = 0 if side > 0 else 180
            axes.add_patch(Wedge(nut, radius, toward - 90, toward + 90, facecolor="#bae6fd", edgecolor=DRIVE))
            x = np.concatenate([[gap / 2 - 0.08], gap / 2 + leaf[:, 0], [roller + 0.25]])
            y = np.concatenate([[outer], outer - leaf[:, 1], [inner]])
            axes.plot(side * x, way * y, color=ELASTIC, linewidth=2.4)
            place = (side * roller, way * (inner + radius + 0.012))
            axes.add_patch(Circle(place, radius, facecolor="white", edgecolor=RIGID, linewidth=1.8))
    dimension(axes, (-gap / 2, -0.12), (gap / 2, -0.12), r"$\delta$", offset=(0, -0.075))
    dimension(axes, (-roller, -outer - 0.15), (roller, -outer - 0.15), "$D$", offset=(0, -0.075))
    dimension(axes, (gap / 2, outer + 0.12), (roller, outer + 0.12), "$x_f$", offset=(0, 0.075))
    dimension(axes, (gap / 2 - 0.16, inner), (gap / 2 - 0.16, outer), "$y_f$", offset=(-0.08, 0))
    arrow(axes, (roller + 0.3, 0), (roller + 0.55, 0), "$d$", offset=(0.06, 0))
    return figure
