"""Solid regular hexagon."""

from __future__ import annotations

import math
from typing import ClassVar

from varistiff.sections.outline import Outline
from varistiff.sections.properties import SectionProperties
from varistiff.sections.regular_polygon import regular_polygon, scaled_polygon, unit_polygon
from varistiff.sections.section import Section


class Hexagon(Section):
    """Solid regular hexagon of the distance b between parallel sides [m]: J = 0.11505 b^4, W = 0.18767 b^3.

    Solved once for b = 1 and scaled.

    >>> round(Hexagon(across_flats=1.0).torsion_constant, 5)
    0.11505
    """

    shape: ClassVar[str] = "hexagon"

    across_flats: float

    def outline(self) -> Outline:
        """One half side."""
        return regular_polygon(6, self.across_flats)

    @property
    def area(self) -> float:
        """Area [m^2]."""
        return 6.0 * math.tan(math.pi / 6.0) * (self.across_flats) ** 2 / 4.0

    @property
    def torsion_constant(self) -> float:
        """J [m^4]."""
        return unit_polygon(6).torsion_constant * (self.across_flats) ** 4

    @property
    def torsion_modulus(self) -> float:
        """W [m^3]; the largest stress sits amid the sides."""
        return unit_polygon(6).torsion_modulus * (self.across_flats) ** 3

    def properties(self) -> SectionProperties:
        """See ``Section.properties``."""
        return scaled_polygon(6, float(self.across_flats))
