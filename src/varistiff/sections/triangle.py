"""Solid equilateral triangle."""

from __future__ import annotations

import math
from typing import ClassVar

from varistiff.sections.outline import Outline
from varistiff.sections.properties import SectionProperties
from varistiff.sections.regular_polygon import regular_polygon
from varistiff.sections.section import Section, centred


class Triangle(Section):
    """Solid equilateral triangle of side a [m].

    Closed form of Saint-Venant: J = sqrt(3) a^4/80, W = a^3/20, the largest stress amid the sides.

    >>> round(Triangle(side=0.01).torsion_modulus * 1e9, 6)
    50.0
    """

    shape: ClassVar[str] = "triangle"

    side: float

    def outline(self) -> Outline:
        """One half side; the origin is the centroid."""
        return regular_polygon(3, self.side / math.sqrt(3.0))

    @property
    def area(self) -> float:
        """Area sqrt(3) a^2/4 [m^2]."""
        return math.sqrt(3.0) / 4.0 * self.side**2

    @property
    def torsion_constant(self) -> float:
        """J = sqrt(3) a^4/80 [m^4]."""
        return math.sqrt(3.0) / 80.0 * self.side**4

    @property
    def torsion_modulus(self) -> float:
        """W = a^3/20 [m^3]."""
        return self.side**3 / 20.0

    def properties(self) -> SectionProperties:
        """See ``Section.properties``."""
        a = float(self.side)
        reach, moment = a / (2.0 * math.sqrt(3.0)), math.sqrt(3.0) / 96.0 * a**4
        angles = (0.0, 2.0 * math.pi / 3.0, -2.0 * math.pi / 3.0)
        return centred(
            area=self.area,
            second_moments=(moment, moment),
            torsion_constant=self.torsion_constant,
            torsion_modulus=self.torsion_modulus,
            stress_points=tuple((reach * math.cos(angle), reach * math.sin(angle)) for angle in angles),
        )
