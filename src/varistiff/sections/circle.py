"""Solid circle."""

from __future__ import annotations

import math

import equinox as eqx


class Circle(eqx.Module):
    """Solid circle of radius R [m].

    >>> round(Circle(radius=0.009).torsion_constant * 1e9, 3)
    10.306
    """

    radius: float

    @property
    def area(self) -> float:
        """Area pi R^2 [m^2]."""
        return math.pi * self.radius**2

    @property
    def second_moment(self) -> float:
        """Second moment of area about a diameter, pi R^4/4 [m^4]."""
        return 0.25 * math.pi * self.radius**4

    @property
    def torsion_constant(self) -> float:
        """J = pi R^4/2 [m^4]."""
        return 0.5 * math.pi * self.radius**4

    @property
    def torsion_modulus(self) -> float:
        """W = J/R [m^3]: the largest shear stress is torque/W, at the rim."""
        return self.torsion_constant / self.radius
