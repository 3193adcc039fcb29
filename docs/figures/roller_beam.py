"""The roller beam: a clamped beam pushed by a roller on the other link."""

from __future__ import annotations

import numpy as np
from elastica import leaf_shape
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from style import DRIVE, ELASTIC, MUTED, RIGID, angle, arrow, dimension, ground, joint, sheet


def draw() -> Figure:
    """Draw the mechanism with a lower roller and the symbols of the theory page."""
    figure, axes = sheet(7.2, 4.3)
    slope, radius = np.radians(38), 0.06
    beam = leaf_shape(slope, 0.62)
    contact = beam[-1]
    tangent = np.array([np.cos(slope), np.sin(slope)])
    normal = np.array([-np.sin(slope), np.cos(slope)])
    hinge = np.array([-0.12, -0.16])
    centre = contact - radius * normal
    offset = 0.10
    reach = np.linalg.norm(centre - hinge)
    turn = np.arctan2(*(centre - hinge)[::-1]) - np.arcsin(offset / reach)
    link = np.array([np.cos(turn), np.sin(turn)])
    across = np.array([-np.sin(turn), np.cos(turn)])

    ground(axes, (0, -0.1), (0, 0.1), depth=0.03)
    axes.plot([0, 1.35], [0, 0], color=MUTED, linewidth=0.8, linestyle="--")
    tail = contact + 0.32 * tangent
    axes.plot(*np.vstack([beam, tail]).T, color=ELASTIC, linewidth=3)
    axes.plot(*np.transpose([hinge, hinge + 1.3 * link]), color=RIGID, linewidth=2)
    axes.plot([hinge[0], hinge[0] + 0.45], [hinge[1]] * 2, color=MUTED, linewidth=0.8, linestyle="--")
    foot = centre - offset * across
    axes.plot(*np.transpose([foot, centre]), color=DRIVE, linewidth=2)
    axes.add_patch(Circle(centre, 0.85 * radius, facecolor="white", edgecolor=DRIVE, linewidth=2, zorder=4))
    joint(axes, hinge, 0.025)

    arrow(axes, contact, contact + 0.28 * normal, "$F$", offset=(0.03, 0.03))
    dimension(axes, hinge - 0.06 * across, foot - 0.06 * across, "$x_r$", offset=0.06 * -across)
    axes.text(*(foot - 0.03 * across + 0.06 * link), "$d_r$", ha="center", va="center", fontsize=11)
    angle(axes, hinge, 0.36, 0, turn, r"$A$", reach=1.12)
    axes.plot(*np.transpose([contact, contact + [0.3, 0]]), color=MUTED, linewidth=0.8, linestyle="--")
    angle(axes, contact, 0.2, 0, slope, r"$t_0$", reach=1.25)
    arrow(axes, (0, 0), (0.16, 0), "$u_b$", color=MUTED, offset=(0.0, -0.045))
    arrow(axes, (0, 0), (0, 0.2), "$v_b$", color=MUTED, offset=(0.045, 0))
    axes.text(*(contact + [-0.04, 0.055]), "$T$", fontsize=11)
    axes.text(*(centre + [0.065, -0.045]), "$C$", fontsize=11, color=DRIVE)
    return figure
