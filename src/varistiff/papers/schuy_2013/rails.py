"""The prototype's rails, whose size is not printed: what they can do to the torsion constant."""

from __future__ import annotations

from functools import cache

from scipy.optimize import brentq

from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.sections import HollowCircle, SplinedTube

BORE_RADIUS = 0.0087  # m; the round length that gives the printed ratio 0.791 (see corrected_reading)
FILLET = 0.0005  # m, assumed
SMALLEST, LARGEST = (0.003, 0.001), (0.009, 0.0035)  # width and height [m] between which the rails may be, assumed


def bare_section() -> HollowCircle:
    """Return the prototype's tube without rails."""
    return HollowCircle(outer_radius=paper.OUTER_RADIUS, inner_radius=BORE_RADIUS)


def splined_section(*, width: float, height: float, fillet: float = FILLET) -> SplinedTube:
    """Return the prototype's tube with six rails of a width and a height [m]."""
    return SplinedTube(
        outer_radius=paper.OUTER_RADIUS,
        inner_radius=BORE_RADIUS,
        rails=paper.RAILS,
        rail_width=width,
        rail_height=height,
        root_fillet=fillet,
    )


def section_factor(*, width: float, height: float) -> float:
    """Return J of the tube with rails over J of the tube without."""
    return splined_section(width=width, height=height).torsion_constant / bare_section().torsion_constant


@cache
def height_of_factor(*, width: float, factor: float) -> float:
    """Return the height [m] at which rails of a width [m] raise J by a factor.

    A larger section has a larger J, so there is one height at most.

    Raises
    ------
    ValueError : none between 0.55 and 8 mm does
    """
    low, high = 1.1 * FILLET, 0.008
    found, state = brentq(
        lambda height: section_factor(width=width, height=height) - factor, low, high, xtol=1e-9, full_output=True
    )
    if not state.converged:
        raise ValueError(f"no height between {low} and {high} m gives rails of {width} m the factor {factor}")
    return float(found)


def stiffening() -> tuple[float, float]:
    """Return the excess of J over the bare tube's with the smallest and with the largest assumed rails."""
    low, high = (section_factor(width=width, height=height) - 1.0 for width, height in (SMALLEST, LARGEST))
    return low, high
