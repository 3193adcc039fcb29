"""The ideal hollow cylinder of polyethylene, section II.A, and the limits of the analytic model."""

from __future__ import annotations

from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.core.status import Status
from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013 import table_one
from varistiff.papers.schuy_2013.device import bare_tube, length_of_stiffness, respond, stiffness


def outer_radius() -> float:
    """Return R for the largest stiffness at the shortest length [m]; Eq. (4)."""
    return table_one.radius(ratio=paper.HOLLOW_RATIO, shear_modulus=paper.POLYETHYLENE)


def cylinder() -> TorsionTube:
    """Return the device with the printed radius."""
    return bare_tube(shear_modulus=paper.POLYETHYLENE, bore_ratio=paper.HOLLOW_RATIO, outer_radius=paper.IDEAL_RADIUS)


def length_of_softest() -> float:
    """Return the active length at which it has the smallest stiffness asked for [m]: the least x_max."""
    return length_of_stiffness(cylinder(), wanted=paper.STIFFNESS_MIN)


def independent_stiffness_margin() -> float:
    """Return 1e-9 minus the relative change of the tangent stiffness over 0.3 rad of twist: x alone sets it."""
    found = [float(respond(cylinder(), twist=twist, active_length=paper.LENGTH_MIN).stiffness) for twist in (0.0, 0.3)]
    return 1e-9 - abs(found[1] / found[0] - 1.0)


def singular_at_clamp_margin() -> float:
    """Return 1e-9 minus the deviation of the stiffness from 1/x over six decades towards the clamp.

    Growing like 1/x it has no limit; at x = 0 the device says that there is no solution.
    """
    tube = cylinder()
    if int(respond(tube, twist=1e-3, active_length=0.0).status) != Status.NO_SOLUTION:
        return -1.0
    products = [x * stiffness(tube, active_length=x) for x in (1e-1, 1e-4, 1e-7)]
    return 1e-9 - (max(products) / min(products) - 1.0)
