"""Circular tube."""

from __future__ import annotations

import math

import equinox as eqx


class HollowCircle(eqx.Module):
    """Tube with outer radius R and inner radius r [m], r < R.

    >>> round(HollowCircle(outer_radius=0.011, inner_radius=0.0087).torsion_constant * 1e9, 3)
    13.999
    """

    outer_radius: float
    inner_radius: float

    @property
    def area(self) -> float:
        """Area pi (R^2 - r^2) [m^2]."""
        return math.pi * (self.outer_radius**2 - self.inner_radius**2)

    @property
    def second_moment(self) -> float:
        """Second moment of area about a diameter, pi (R^4 - r^4)/4 [m^4]."""
        return 0.5 * self.torsion_constant

    @property
    def torsion_constant(self) -> float:
        """J = pi (R^4 - r^4)/2 [m^4]."""
        return 0.5 * math.pi * (self.outer_radius**4 - self.inner_radius**4)

    @property
    def torsion_modulus(self) -> float:
        """W = J/R [m^3]: the largest shear stress is torque/W, at the outer radius."""
        return self.torsion_constant / self.outer_radius
