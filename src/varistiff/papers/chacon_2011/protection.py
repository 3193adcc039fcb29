"""The protection of the leaves: section 2, Eqs. (1) to (3)."""

from __future__ import annotations

import numpy as np

from varistiff.actuators.antagonistic_leaves import protecting_radius
from varistiff.core.status import Status
from varistiff.papers.chacon_2011.devices import aspect_ratios, leaf, states
from varistiff.papers.chacon_2011.paper_values import CLAMP_HEIGHT


def radius() -> float:
    """Radius [m] to which the leaf bends without yielding, R = E t/(2 sigma_y); Eq. (3)."""
    return protecting_radius(leaf())


def largest_stress() -> float:
    """Largest bending stress [Pa] of leaves that wrap on cylinders of 35 mm, over all states of the range.

    Displacements run until the arcs on both cylinders meet.
    """
    displacement = np.linspace(0.0, CLAMP_HEIGHT, 41)
    found = states("wrapped", displacement[:, None], aspect_ratios(31))
    return float(np.max(found.stress[found.status != Status.NO_SOLUTION]))
