"""Solid circle."""

from __future__ import annotations

import math
from typing import ClassVar

from varistiff.sections.outline import Arc, Outline
from varistiff.sections.properties import SectionProperties
from varistiff.sections.section import Section, centred


class Circle(Section):
    """Solid circle of radius R [m].

    >>> round(Circle(radius=0.009).torsion_constant * 1e9, 3)
    10.306
    """

    shape: ClassVar[str] = "circle"

    radius: float

    def outline(self) -> Outline:
        """A twelfth of the circle; every sector is the same."""
        return Outline(((Arc((0.0, 0.0), self.radius, 0.0, math.pi / 6.0),),), rotations=6, mirror=True)

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

    def properties(self) -> SectionProperties:
        """See ``Section.properties``."""
        return centred(
            area=self.area,
            second_moments=(self.second_moment, self.second_moment),
            torsion_constant=self.torsion_constant,
            torsion_modulus=self.torsion_modulus,
            stress_points=((float(self.radius), 0.0),),  # and the whole rim
        )
