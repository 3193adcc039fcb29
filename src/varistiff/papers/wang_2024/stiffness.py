"""Stiffness of the joint: its range, and what the paper says of its course (Eq. 9; Figs. 3, 4 and 6)."""

from __future__ import annotations

import numpy as np

from varistiff.dynamics.control import active_length_from_stiffness
from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.device import Numbers, answer, deflections, effective_lengths, joint

_HALF_MILLIMETRE = 0.0005  # m: "25 mm" is printed to a millimetre


def rest_stiffness(length: float | Numbers, *, count: int = paper.COUNT) -> Numbers:
    """Stiffness at rest [N m/rad] of the printed joint at active lengths [m]."""
    return answer(joint(count=count), deflection=0.0, length=length).stiffness


def softest() -> tuple[float, float]:
    """Lower end of the stiffness range [N m/rad].

    From 29 mm, which the groove reaches, at the printed limit of deflection, to 25 mm, where the effective range ends,
    at rest.
    """
    longest = paper.OUTER_RADIUS - paper.CLAMP_RADIUS
    low = answer(joint(), deflection=paper.DEFLECTION_LIMIT, length=longest).stiffness
    return float(low), float(rest_stiffness(paper.LENGTH_MAX))


def stiffest() -> float:
    """Stiffness at rest [N m/rad] at the short end of the effective range."""
    return float(rest_stiffness(paper.LENGTH_MIN))


def growth_towards_zero() -> float:
    """How much faster than l_1^-2 the stiffness grows where l_1 goes to zero: 1 for l_1^-3; unbounded above -2."""
    short = np.array([1e-7, 1e-6])
    values = np.log(rest_stiffness(short))
    return float(-(values[1] - values[0]) / np.log(short[1] / short[0]) - 2.0)


def growth_towards_infinity() -> float:
    """Exponent of l_1 in the stiffness where l_1 goes to infinity: above 0 where the stiffness grows with it."""
    far = np.array([1e3, 1e4])
    values = np.log(rest_stiffness(far))
    return float((values[1] - values[0]) / np.log(far[1] / far[0]))


def falls_with_length() -> float:
    """Least relative fall of the stiffness per relative step of the length, over the effective range, at any phi."""
    lengths = effective_lengths()
    values = answer(joint(), deflection=deflections()[:, None], length=lengths).stiffness
    slopes = -np.diff(np.log(values), axis=1) / np.diff(np.log(lengths))
    return float(slopes.min())


def grows_towards_clamp() -> float:
    """Stiffness at rest at a tenth of the shortest effective length, over that at the longest, less 1."""
    return float(rest_stiffness(0.1 * paper.LENGTH_MIN) / rest_stiffness(paper.LENGTH_MAX) - 1.0)


def deflection_matters_less_than_length(*, exact: bool) -> float:
    """1 minus (spread of the stiffness over the deflection) / (spread over the length), as logarithms.

    Deflections from rest to the printed limit, lengths of the effective range; the spread over the deflection is the
    largest at any length.
    """
    values = answer(joint(exact=exact), deflection=deflections()[:, None], length=effective_lengths()).stiffness
    logs = np.log(values)
    return float(1.0 - np.ptp(logs, axis=0).max() / np.ptp(logs[0]))


def hardly_changes(*, exact: bool, largest: float) -> float:
    """``largest`` less the relative change of the stiffness up to the printed limit of deflection [-].

    The exact leaf is asked where the paper's own assumption of 10 degrees of leaf rotation holds, and nowhere else.
    """
    phi, lengths = deflections()[:, None], effective_lengths()
    allowed = answer(joint(), deflection=phi, length=lengths).rotation <= paper.ROTATION_ASSUMED
    values = answer(joint(exact=exact), deflection=phi, length=lengths).stiffness
    change = np.abs(values / values[0] - 1.0)
    return float(largest - (change[allowed] if exact else change).max())


def nonlinear_in_length() -> float:
    """Largest deviation of the stiffness from the straight line between its ends, over their difference [-]."""
    lengths = effective_lengths()
    values = rest_stiffness(lengths)
    line = np.interp(lengths, lengths[[0, -1]], values[[0, -1]])
    return float((np.abs(values - line) / (values[0] - values[-1])).max()) - 0.05


def slope(length: float) -> float:
    """|dK/dl_1| at rest [N m/rad per m], by a central difference."""
    step = 1e-4 * length
    low, high = rest_stiffness(np.array([length - step, length + step]))
    return float(abs(high - low) / (2.0 * step))


def dramatic_below_effective_range() -> float:
    """Average slope of the stiffness from 1 to 6 mm over that from 6 to 25 mm, less 10."""
    first, middle, last = rest_stiffness(np.array([1e-3, paper.LENGTH_MIN, paper.LENGTH_MAX]))
    below = (first - middle) / (paper.LENGTH_MIN - 1e-3)
    return float(below / ((middle - last) / (paper.LENGTH_MAX - paper.LENGTH_MIN)) - 10.0)


def resolution_below_effective_range() -> float:
    """Slope of the stiffness at 3 mm over that at 6 mm, less 10: how the resolution in l_1 goes."""
    return slope(0.5 * paper.LENGTH_MIN) / slope(paper.LENGTH_MIN) - 10.0


def slow_at_long_lengths() -> float:
    """1 minus ten times the slope of the stiffness at 25 mm over that at 6 mm."""
    return 1.0 - 10.0 * slope(paper.LENGTH_MAX) / slope(paper.LENGTH_MIN)


def range_grows_with_count(*, count: int) -> float:
    """1e-9 less the relative error of K(N) = N K(1) over the effective range."""
    lengths = effective_lengths()
    ratio = rest_stiffness(lengths, count=count) / rest_stiffness(lengths, count=1)
    return float(1e-9 - np.abs(ratio / count - 1.0).max())


def length_of(stiffness: float) -> float:
    """Active length [m] at which the printed joint has a stiffness [N m/rad] at rest."""
    printed = joint()
    bending = 3.0 * printed.count * printed.leaf.flexural_rigidity
    return float(active_length_from_stiffness(stiffness, bending=bending, clamp_radius=printed.clamp_radius))


def level_in_effective_range() -> tuple[float, float]:
    """Longest effective length, all that rounds to the printed 25 mm, minus the length of 200 N m/rad [m]."""
    left = paper.LENGTH_MAX - length_of(paper.TEST_STIFFNESS)
    return left - _HALF_MILLIMETRE, left + _HALF_MILLIMETRE


def sine_fits_range() -> float:
    """Half the width of the stiffness range from 6 to 25 mm minus the sine's amplitude [N m/rad]."""
    return 0.5 * (stiffest() - float(rest_stiffness(paper.LENGTH_MAX))) - paper.STIFFNESS_AMPLITUDE


def length_follows_from_stiffness() -> float:
    """1e-9 less the relative error of the length found from the stiffness (section 4.2), over the effective range."""
    lengths = effective_lengths(9)
    found = np.array([length_of(float(value)) for value in rest_stiffness(lengths)])
    return float(1e-9 - np.abs(found / lengths - 1.0).max())
