"""The paper's prototype with the project's device, under each theory of its leaves."""

from __future__ import annotations

from functools import cache
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from varistiff.actuators.antagonistic_leaves import AntagonisticLeaves, aspect_ratio
from varistiff.characteristic.evaluate import Points, evaluate
from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import LeafLaw
from varistiff.elastic.sliding_leaf import SlidingLeaf
from varistiff.elastic.wrapped_leaf import WrappedLeaf
from varistiff.papers.chacon_2011.leaf_variants import LinearBeam
from varistiff.papers.chacon_2011.paper_values import (
    ASPECT_RATIO_SOFT,
    ASPECT_RATIO_STIFF,
    CLAMP_HEIGHT,
    LEAF_THICKNESS,
    LEAF_WIDTH,
    PROTECTING_RADIUS,
    ROLLER_DISTANCE,
    YIELD_STRENGTH,
    YOUNGS_MODULUS,
)

Theory = Literal["guided", "sliding", "wrapped", "linear"]
THEORIES: tuple[Theory, ...] = ("guided", "sliding", "wrapped", "linear")


@cache
def leaf() -> Leaf:
    """Return the prototype's leaf, of unlimited length (its length is unpublished)."""
    return Leaf(
        youngs_modulus=YOUNGS_MODULUS, width=LEAF_WIDTH, thickness=LEAF_THICKNESS, yield_strength=YIELD_STRENGTH
    )


def law(theory: Theory, *, protecting_radius: float = PROTECTING_RADIUS) -> LeafLaw:
    """Leaf law by name: the paper's model, the exact leaf, the exact leaf on cylinders [m], linear beam theory."""
    if theory == "wrapped":
        return WrappedLeaf(protecting_radius)
    if theory == "guided":
        return GuidedLeaf()
    return SlidingLeaf() if theory == "sliding" else LinearBeam()


def device(leaves: LeafLaw) -> AntagonisticLeaves:
    """Return the prototype with these leaves; Chacon et al. (2011), section 4."""
    return AntagonisticLeaves(leaf=leaf(), law=leaves, roller_distance=ROLLER_DISTANCE, clamp_height=CLAMP_HEIGHT)


def nut_distance(ratio: ArrayLike) -> np.ndarray:
    """Nut distance delta [m] of an aspect ratio at rest: Eq. (4) solved for it.

    The aspect ratio is linear in the nut distance, so two points of the device's own function fix it.

    >>> round(float(nut_distance(3.5)), 6)
    0.0615
    """
    zero, one = (
        aspect_ratio(setting, roller_distance=ROLLER_DISTANCE, clamp_height=CLAMP_HEIGHT) for setting in (0.0, 1.0)
    )
    return (np.asarray(ratio, float) - zero) / (one - zero)


def states(leaves: LeafLaw | Theory, deflection: ArrayLike, ratio: ArrayLike) -> Points:
    """Response of the prototype at displacements d [m] and aspect ratios of its leaves at rest."""
    chosen = law(leaves) if isinstance(leaves, str) else leaves
    return evaluate(device(chosen), deflection, nut_distance(ratio))


def aspect_ratios(count: int = 61) -> np.ndarray:
    """Evenly spaced aspect ratios over the prototype's range, softest first."""
    return np.linspace(ASPECT_RATIO_SOFT, ASPECT_RATIO_STIFF, count)


def ends() -> np.ndarray:
    """Both ends of the prototype's range of aspect ratios, softest first."""
    return np.array([ASPECT_RATIO_SOFT, ASPECT_RATIO_STIFF])
