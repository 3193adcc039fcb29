"""Circular tube."""

from __future__ import annotations

import math
from typing import ClassVar

from varistiff.sections.outline import Arc, Outline
from varistiff.sections.properties import SectionProperties
from varistiff.sections.section import Section, centred


class HollowCircle(Section):
    """Tube with outer radius R and inner radius r [m], r < R.

    >>> round(HollowCircle(outer_radius=0.011, inner_radius=0.0087).torsion_constant * 1e9, 3)
    13.999
    """

    shape: ClassVar[str] = "hollow_circle"

    outer_radius: float
    inner_radius: float

    def outline(self) -> Outline:
        """A twelfth of the tube; every sector is the same."""
        outer = (Arc((0.0, 0.0), self.outer_radius, 0.0, math.pi / 6.0),)
        bore = (Arc((0.0, 0.0), self.inner_radius, math.pi / 6.0, -math.pi / 6.0),)
        return Outline((outer, bore) if self.inner_radius > 0.0 else (outer,), rotations=6, mirror=True)

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

    def properties(self) -> SectionProperties:
        """See ``Section.properties``."""
        return centred(
            area=self.area,
            second_moments=(self.second_moment, self.second_moment),
            torsion_constant=self.torsion_constant,
            torsion_modulus=self.torsion_modulus,
            stress_points=((float(self.outer_radius), 0.0),),  # and the whole rim
        )
