"""Dimensioning by strength, section II.C with Figs. 3 and 4: radius, length, material, stiffness range."""

from __future__ import annotations

import math
from dataclasses import dataclass

from scipy.optimize import brentq

from varistiff.materials.table import builtin_materials
from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013.device import length_of_stiffness, tube_of
from varistiff.sections import Circle

SAFETY = 2.0  # assumed: the paper's factor against failure is not printed
TORQUE = 10.0  # N m, assumed
PLASTICS = ("pe", "pa2200", "pom", "peek", "tpu")  # assumed: those of Figs. 3 and 4 can only be read from the picture


@dataclass(frozen=True)
class Plastic:
    """Key in the material table, shear modulus [Pa], and allowed shear stress [Pa]."""

    key: str
    shear_modulus: float
    allowed: float


def plastic(key: str) -> Plastic:
    """Return a plastic, allowed up to yield_strength/sqrt(3) over the factor of safety.

    Raises
    ------
    ValueError : the material table gives no modulus or no strength
    """
    material = builtin_materials()[key]
    if material.shear_modulus is None or material.yield_strength is None:
        raise ValueError(f"the material table gives no modulus or no strength of {key}")
    allowed = material.yield_strength.value / math.sqrt(3.0) / SAFETY
    return Plastic(key, material.shear_modulus.value, allowed)


def smallest_radius(*, torque: float, allowed: float) -> float:
    """Return the radius [m] of a solid cylinder that carries a torque [N m] at the allowed shear stress [Pa]."""

    def miss(radius: float) -> float:
        return float(Circle(radius=radius).torsion_modulus) * allowed / torque - 1.0

    return float(brentq(miss, 1e-4, 1.0, xtol=1e-16, rtol=1e-14))


def active_length(*, radius: float, stiffness: float, shear_modulus: float) -> float:
    """Return the length [m] at which a solid cylinder has a stiffness [N m/rad]; Eq. (3) for x."""
    return length_of_stiffness(tube_of(shear_modulus=shear_modulus, section=Circle(radius=radius)), wanted=stiffness)


def radius_range() -> tuple[float, float]:
    """Return the smallest and the largest of the radii that carry ``TORQUE``, over the plastics [m]."""
    radii = [smallest_radius(torque=TORQUE, allowed=plastic(key).allowed) for key in PLASTICS]
    return min(radii), max(radii)


def radius_depends_margin() -> float:
    """Return how much of a change of torque or strength the radius takes at least: powers 1/3 and -1/3.

    The smaller of log R(8 torque)/R over log 8, and log R(strength/8)/R over log 8.
    """
    base = plastic("pa2200").allowed
    radius = smallest_radius(torque=TORQUE, allowed=base)
    more = smallest_radius(torque=8.0 * TORQUE, allowed=base)
    weaker = smallest_radius(torque=TORQUE, allowed=base / 8.0)
    return min(math.log(more / radius), math.log(weaker / radius)) / math.log(8.0)


def lengths_follow_margin() -> float:
    """Return 1e-9 minus the relative error of longest/shortest length = stiffest/softest, over the plastics."""
    worst = 0.0
    for key in PLASTICS:
        one = plastic(key)
        radius = smallest_radius(torque=TORQUE, allowed=one.allowed)
        near, far = (
            active_length(radius=radius, stiffness=k, shear_modulus=one.shear_modulus)
            for k in (paper.STIFFNESS_MAX, paper.STIFFNESS_MIN)
        )
        worst = max(worst, abs(far / near * paper.STIFFNESS_MIN / paper.STIFFNESS_MAX - 1.0))
    return 1e-9 - worst


def polyurethane_margin() -> float:
    """Return by how much polyurethane's elastic shear strain exceeds that of sintered polyamide, as a ratio less 1.

    Strain at yield is strength over stiffness: what a spring of given strength can twist.
    """
    soft, stiff = plastic("tpu"), plastic("pa2200")
    return soft.allowed / soft.shear_modulus / (stiff.allowed / stiff.shear_modulus) - 1.0
