"""The slider leaf joint: a leaf on the output disc, a slider on the input disc, a groove that moves it."""

from __future__ import annotations

import numpy as np
from elastica import leaf_shape
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from style import DRIVE, ELASTIC, MUTED, RIGID, angle, arrow, dimension, joint, sheet


def draw() -> Figure:
    """Draw one leaf, its slider and the two radii, the deflection enlarged."""
    figure, axes = sheet(7.2, 3.2)
    slope = np.radians(30)
    clamp_radius = 0.55
    leaf = leaf_shape(slope, 0.5)
    contact = leaf[-1] + [clamp_radius, 0]
    turn = np.arctan2(contact[1], contact[0])
    reach = np.hypot(*contact)
    tangent = np.array([np.cos(slope), np.sin(slope)])
    normal = np.array([-tangent[1], tangent[0]])
    axes.plot([0, 1.5], [0, 0], color=MUTED, linewidth=0.8, linestyle="--")
    axes.plot(*np.transpose([(0, 0), 1.22 * contact]), color=MUTED, linewidth=0.8, linestyle="--")
    axes.add_patch(Circle((0, 0), clamp_radius, fill=False, edgecolor=RIGID, linewidth=1.2))
    axes.plot([clamp_radius - 0.1, clamp_radius], [0, 0], color=RIGID, linewidth=7)
    curve = np.vstack([leaf + [clamp_radius, 0], contact + 0.22 * tangent])
    axes.plot(*curve.T, color=ELASTIC, linewidth=2.6)
    axes.add_patch(Circle(contact - 0.03 * normal, 0.028, facecolor=DRIVE, edgecolor=DRIVE, zorder=4))
    joint(axes, (0, 0), 0.03)
    arrow(axes, contact, contact + 0.24 * normal, "$F$", offset=(-0.03, 0.03))
    angle(axes, (0, 0), 0.34, 0, turn, r"$\varphi$", reach=1.14)
    dimension(axes, (0, -0.09), (clamp_radius, -0.09), "$r_2$", offset=(0, -0.06))
    lift = 0.26 * np.array([-np.sin(turn), np.cos(turn)])
    dimension(axes, lift, contact + lift, "$l_2$", offset=lift * 0.24)
    end = reach * np.array([1, 0])
    dimension(axes, (clamp_radius, -0.09), (end[0], -0.09), "$l_1$", offset=(0, -0.06))
    axes.set_ylim(-0.62, 0.75)
    return figure
