"""What the paper says of its mechanism, whatever springs are in it."""

from __future__ import annotations

import equinox as eqx
import numpy as np

from varistiff.characteristic.evaluate import evaluate
from varistiff.elastic.leaf import Leaf
from varistiff.papers.chacon_2011.devices import aspect_ratios, device, ends, law, nut_distance, states
from varistiff.papers.chacon_2011.leaf_variants import PowerSpring
from varistiff.papers.chacon_2011.paper_values import (
    CLAMP_HEIGHT,
    LEAF_THICKNESS,
    LEAF_WIDTH,
    ROLLER_DISTANCE,
    YOUNGS_MODULUS,
)

_ROUNDING = 1e-9  # relative: what counts as equal


def nut_distances() -> tuple[float, float]:
    """Nut distances delta [m] of the prototype's range, by Eq. (4)."""
    low, high = nut_distance(ends())
    return float(low), float(high)


def adjusting_margin() -> float:
    """Least relative step of the stiffness at rest between neighbours of 61 nut distances of the range [-]."""
    stiffness = states("guided", 0.0, aspect_ratios()).stiffness
    return float(np.min(np.diff(stiffness) / np.abs(stiffness[:-1])))


def decoupling_margin() -> float:
    """Margin of "quadratic springs decouple stiffness and deflection" [-].

    Rounding minus the largest relative change of the stiffness over the displacement, in the paper's device with
    springs of a quadratic characteristic in the place of the leaves.
    """
    stiffness = _with_springs(exponent=3.0)
    return _ROUNDING - float(np.max(np.abs(stiffness / stiffness[:1] - 1.0)))


def linear_spring_margin() -> float:
    """Margin of "the stiffness varies only with nonlinear springs" [-].

    Rounding minus the largest relative change of the stiffness over nut distance and displacement with linear
    springs in the place of the leaves.
    """
    stiffness = _with_springs(exponent=2.0)
    return _ROUNDING - float(np.max(np.abs(stiffness / stiffness[0, 0] - 1.0)))


def _with_springs(*, exponent: float) -> np.ndarray:
    springs = PowerSpring(rate=1.0e4, exponent=exponent, free_span=0.5 * ROLLER_DISTANCE)
    displacement = np.linspace(0.0, 0.5 * min(nut_distances()), 9)  # so small that all springs stay compressed
    return states(springs, 0.9 * displacement[:, None], aspect_ratios(9)).stiffness


def equilibrium_margin() -> float:
    """Margin of "the equilibrium stays at d = 0 at every nut distance" [N].

    Least force back to d = 0 from a micrometre to either side of it: positive if a stable equilibrium lies between.
    """
    there, back = states("guided", np.array([[1e-6], [-1e-6]]), aspect_ratios()).load
    return float(min(there.min(), (-back).min()))


def displacement_margin() -> float:
    """Margin of "the same force displaces less at a larger nut distance" (figure 3) [m].

    Least decrease of the displacement from one of 21 nut distances of the range to the next, under 20 forces up to
    that of the softest setting at a displacement of half the rise.
    """
    displacement = np.linspace(0.0, 0.5 * CLAMP_HEIGHT, 401)
    load = states("guided", displacement[:, None], aspect_ratios(21)).load
    forces = load[-1, 0] * np.linspace(0.05, 1.0, 20)
    reached = np.array([np.interp(forces, column, displacement) for column in load.T])
    return float(np.min(reached[:-1] - reached[1:]))


def scaling_margin() -> float:
    """Margin of "the spring can be scaled to loads of any size" [-].

    Rounding minus the largest relative change of stiffness over stiffness at rest, when the leaves' width goes from a
    thousandth to thousandfold: loads follow the flexural rigidity, the shape of the curves does not change.
    """
    displacement = np.linspace(0.0, 0.3 * CLAMP_HEIGHT, 7)[:, None]
    curves = []
    for factor in (1e-3, 1.0, 1e3):
        spring = device(law("guided"))
        wide = Leaf(youngs_modulus=YOUNGS_MODULUS, width=factor * LEAF_WIDTH, thickness=LEAF_THICKNESS)
        scaled = eqx.tree_at(lambda one: one.leaf, spring, wide)
        stiffness = evaluate(scaled, displacement, nut_distance(aspect_ratios(7))).stiffness
        curves.append(stiffness / stiffness[0, 0])
    return _ROUNDING - float(max(np.max(np.abs(curve / curves[1] - 1.0)) for curve in curves))
