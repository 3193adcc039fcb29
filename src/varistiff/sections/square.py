"""Solid square."""

from __future__ import annotations

from typing import ClassVar

from varistiff.sections.outline import Line, Outline
from varistiff.sections.properties import SectionProperties
from varistiff.sections.rectangle import Rectangle
from varistiff.sections.section import Section


class Square(Section):
    """Solid square of the distance b between parallel sides [m]: J = 0.14058 b^4, W = 0.20817 b^3.

    >>> round(Square(across_flats=1.0).torsion_modulus, 6)
    0.208165
    """

    shape: ClassVar[str] = "square"

    across_flats: float

    def outline(self) -> Outline:
        """An eighth of the square."""
        half = 0.5 * self.across_flats
        return Outline(((Line((half, 0.0), (half, half)),),), rotations=4, mirror=True)

    @property
    def _rectangle(self) -> Rectangle:
        return Rectangle(width=self.across_flats, height=self.across_flats)

    @property
    def area(self) -> float:
        """Area b^2 [m^2]."""
        return self._rectangle.area

    @property
    def torsion_constant(self) -> float:
        """J [m^4], the series of the rectangle."""
        return self._rectangle.torsion_constant

    @property
    def torsion_modulus(self) -> float:
        """W [m^3]; the largest stress sits amid the four sides."""
        return self._rectangle.torsion_modulus

    def properties(self) -> SectionProperties:
        """See ``Section.properties``."""
        return self._rectangle.properties()
