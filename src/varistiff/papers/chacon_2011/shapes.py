"""Shape, energy and length of one leaf: section 3, figures 5 and 6."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from varistiff.characteristic.evaluate import Points
from varistiff.papers.chacon_2011.devices import Theory, aspect_ratios, ends, law, leaf, states
from varistiff.papers.chacon_2011.paper_values import (
    CLAMP_HEIGHT,
    LEAF_THICKNESS,
    LEAF_WIDTH,
    YOUNGS_MODULUS,
)


def leaf_energy(found: Points) -> np.ndarray:
    """Energy of one of four equal leaves [J]."""
    return found.energy / 4.0


def end_curvature(found: Points) -> np.ndarray:
    """Largest curvature of a leaf [1/m], from the stress in its outer fibre."""
    return found.stress / (0.5 * YOUNGS_MODULUS * LEAF_THICKNESS)


def longitudinal_margin(*, theory: Theory) -> float:
    """Margin of "the rollers do not compress the leaves along the screw" [N]: minus the largest such force at rest.

    A leaf presses with -dU/dx_f on roller and clamp. Two leaves press on each nut and the nut distance shares its
    change among both sides, so the adjusting load is twice that of one leaf.
    """
    return -float(np.max(states(theory, 0.0, aspect_ratios()).adjusting_load)) / 2.0


def bending_margin(*, allowed: float) -> float:
    """Margin of "the leaves work in bending only" [-]: allowed share minus that of stretching and shear.

    The model's internal force is the transverse P = 2 a EI = 2 EI kappa_end/x_f everywhere. Stretching stores at most
    P^2 L/(2 E A), shear at most (6/5) P^2 L/(2 G A) with G >= E/3 for every isotropic material.
    """
    found, span = states("guided", 0.0, aspect_ratios()), CLAMP_HEIGHT * aspect_ratios()
    force = 2.0 * leaf().flexural_rigidity * end_curvature(found) / span
    stretched = force**2 * found.details["leaf_length_needed"] / (2.0 * YOUNGS_MODULUS * LEAF_WIDTH * LEAF_THICKNESS)
    return allowed - float(np.max((1.0 + 3.0 * 6.0 / 5.0) * stretched / leaf_energy(found)))


def minimum_margin() -> float:
    """Margin of "the shape is that of least energy" [-].

    Least relative excess of the free elastica's energy over the paper's shape at the same span and rise: both are
    horizontal at both ends, so both compete.
    """
    exact, paper = (states(theory, 0.0, aspect_ratios()).energy for theory in ("sliding", "guided"))
    return float(np.min(exact / paper - 1.0))


def uniqueness_margin(*, loop_radius: float) -> float:
    """Margin of "the shape is the only minimum" [J]: energy of a looped leaf minus the least of the paper's shapes.

    The looped leaf runs straight from the roller over the span, turns back on a half circle of the given radius
    [m] and forward again on one that is smaller by half the rise: the same ends, horizontal both.
    """
    smaller = loop_radius - 0.5 * CLAMP_HEIGHT
    looped = 0.5 * leaf().flexural_rigidity * math.pi * (1.0 / loop_radius + 1.0 / smaller)
    return looped - float(np.min(leaf_energy(states("guided", 0.0, aspect_ratios()))))


def free_length() -> tuple[float, float]:
    """Arc length from clamp to roller [m] at rest: at the stiffest and the softest aspect ratio, by the model."""
    long, short = states("guided", 0.0, ends()).details["leaf_length_needed"]
    return float(short), float(long)


def length_margin() -> float:
    """Least change of the arc length between neighbours of 61 aspect ratios of the range, softest first [m]."""
    length = states("guided", 0.0, aspect_ratios()).details["leaf_length_needed"]
    return float(np.min(length[:-1] - length[1:]))


def steepest_slopes() -> tuple[float, float]:
    """Slope in the middle of the leaf [rad] at the softest and the stiffest aspect ratio, by the model.

    sin(theta) = a x_f^2/4 there, with the end curvature a x_f.
    """
    curvature = end_curvature(states("guided", 0.0, ends()))
    soft, stiff = np.arcsin(curvature * CLAMP_HEIGHT * ends() / 4.0)
    return float(soft), float(stiff)


def energy_ratio() -> float:
    """Energy of a leaf at the stiffest aspect ratio over that at the softest [-], by the model."""
    soft, stiff = leaf_energy(states("guided", 0.0, ends()))
    return float(stiff / soft)


@cache
def difference(*, theory: Theory) -> float:
    """Largest vertical distance [m] of a theory's shape from the paper's, over the prototype's range at rest."""
    largest = 0.0
    for aspect_ratio in aspect_ratios(7):
        span = float(aspect_ratio) * CLAMP_HEIGHT
        paper, other = (law(name).centreline(leaf(), span, CLAMP_HEIGHT, 1001) for name in ("guided", theory))
        height = np.interp(paper[:, 0], other[:, 0], other[:, 1])
        largest = max(largest, float(np.max(np.abs(height - paper[:, 1]))))
    return largest


def similarity_margin(*, allowed: float) -> float:
    """Margin of "a leaf measures like the model" [m]: allowed distance minus that of the exact free leaf."""
    return allowed - difference(theory="sliding")
