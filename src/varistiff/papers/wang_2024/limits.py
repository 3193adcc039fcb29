"""What bounds the joint: leaf rotation, deflection, torque, and how good the small-deflection theory is there."""

from __future__ import annotations

import numpy as np
from scipy.optimize import brentq

from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.device import Numbers, answer, deflections, effective_lengths, joint

_HALF_DEGREE = float(np.radians(0.5))  # "about 9 degrees" is printed to a degree


def deflection_at_rotation(rotation: float, *, length: float) -> float:
    """Deflection phi [rad] at which the leaf turns by ``rotation`` [rad] at the slider (Eqs. 1 and 2)."""
    printed = joint()
    return float(
        brentq(
            lambda phi: float(answer(printed, deflection=phi, length=length).rotation) - rotation, 0.0, 0.5, xtol=1e-12
        )
    )


def limited_deflections(rotation: float = paper.ROTATION_DESIGN, *, count: int = 7) -> tuple[Numbers, Numbers]:
    """Lengths of the effective range [m], and the deflections that a leaf rotation allows there [rad]."""
    lengths = effective_lengths(count)
    return lengths, np.array([deflection_at_rotation(rotation, length=float(length)) for length in lengths])


def deflection_range() -> tuple[float, float]:
    """Deflection [rad] at 25 mm for a leaf rotation of about 9 degrees: 8.5 to 9.5."""
    low, high = (
        deflection_at_rotation(paper.ROTATION_DESIGN + side * _HALF_DEGREE, length=paper.LENGTH_MAX)
        for side in (-1.0, 1.0)
    )
    return low, high


def deflection_range_grows_with_length() -> float:
    """Least growth of the deflection that 9 degrees of rotation allow, between neighbouring lengths [rad]."""
    _, allowed = limited_deflections()
    return float(np.diff(allowed).min())


def largest_rotation() -> tuple[float, float]:
    """Largest leaf rotation [rad] that the mechanical limit leaves, over the effective range (Eq. 2).

    Low end: a limit that goes with the length, the printed 3.03 degrees being its largest. High end: one stop at 3.03
    degrees for all lengths.
    """
    rotation = answer(joint(), deflection=paper.DEFLECTION_LIMIT, length=effective_lengths()).rotation
    return float(rotation.min()), float(rotation.max())


def largest_torque(*, count: int = paper.COUNT) -> tuple[float, float]:
    """Largest torque [N m] of the printed joint over the effective range (Eq. 7).

    From where the leaf rotation of 9 degrees limits the deflection at every length, to where only the printed 3.03
    degrees do.
    """
    lengths, allowed = limited_deflections()
    by_rotation = answer(joint(count=count), deflection=allowed, length=lengths).torque.max()
    by_stop = answer(joint(count=count), deflection=paper.DEFLECTION_LIMIT, length=lengths).torque.max()
    return float(by_rotation), float(by_stop)


def torque_grows_with_count(*, count: int) -> float:
    """1e-9 less the relative error of torque(N) = N torque(1) over the effective range."""
    phi, lengths = deflections()[1:, None], effective_lengths()
    many = answer(joint(count=count), deflection=phi, length=lengths).torque
    one = answer(joint(count=1), deflection=phi, length=lengths).torque
    return float(1e-9 - np.abs(many / one / count - 1.0).max())


def assumption_holds(*, largest: float) -> tuple[float, float]:
    """``largest`` less the relative errors of the small-deflection theory at 10 degrees of leaf rotation.

    Of the stiffness and of the torque, in this order, the largest over the effective range.
    """
    lengths, allowed = limited_deflections(paper.ROTATION_ASSUMED)
    published, exact = (answer(joint(exact=exact), deflection=allowed, length=lengths) for exact in (False, True))
    stiffness = np.abs(published.stiffness / exact.stiffness - 1.0).max()
    torque = np.abs(published.torque / exact.torque - 1.0).max()
    return float(largest - stiffness), float(largest - torque)


def leaf_is_a_cantilever() -> float:
    """1e-9 less the largest relative difference of the leaf from a cantilever under the force of Eqs. (6) and (7).

    Displacement l_2 tan(phi) (Eq. 1) against F l_1^3/(3 E I), rotation against F l_1^2/(2 E I) (Eq. 2), and the stress
    at the clamp, which the paper does not give, against 6 F l_1/(b h^2).
    """
    phi, length = deflections()[1:, None], effective_lengths()
    found = answer(joint(), deflection=phi, length=length)
    radius = paper.CLAMP_RADIUS + length
    force = found.torque / (paper.COUNT * radius * np.cos(phi))
    bending = paper.YOUNGS_MODULUS * paper.WIDTH * paper.THICKNESS**3 / 12.0
    ratios = (
        force * length**3 / (3.0 * bending) / (radius * np.tan(phi)),
        found.rotation / (force * length**2 / (2.0 * bending)),
        found.stress / (6.0 * force * length / (paper.WIDTH * paper.THICKNESS**2)),
    )
    return float(1e-9 - max(np.abs(ratio - 1.0).max() for ratio in ratios))


def load_is_perceived(*, largest: float) -> float:
    """``largest`` less the error of K(l_1) phi as a measure of the load, at 9 degrees of leaf rotation, exact leaf."""
    lengths, allowed = limited_deflections()
    perceived = answer(joint(), deflection=0.0, length=lengths).stiffness * allowed
    exact = answer(joint(exact=True), deflection=allowed, length=lengths).torque
    return float(largest - np.abs(perceived / exact - 1.0).max())


def root_stress(*, length: float, rotation: float = paper.ROTATION_DESIGN) -> float:
    """Bending stress at the clamp [Pa] at a length [m] where the leaf turns by ``rotation`` [rad]; not in the paper."""
    phi = deflection_at_rotation(rotation, length=length)
    return float(answer(joint(), deflection=phi, length=length).stress)


def stress_when_short() -> float:
    """Root stress at the printed limit of deflection and 6 mm over that at 25 mm, less 1."""
    ends = np.array([paper.LENGTH_MIN, paper.LENGTH_MAX])
    short, long = answer(joint(), deflection=paper.DEFLECTION_LIMIT, length=ends).stress
    return float(short / long - 1.0)
