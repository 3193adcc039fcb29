"""Solid ellipse."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from varistiff.sections.limits import check_ellipse
from varistiff.sections.outline import Curve, Outline, Points
from varistiff.sections.properties import SectionProperties
from varistiff.sections.section import Section, centred


class Ellipse(Section):
    """Solid ellipse with semi-axes a along x and b along y [m]; "major" is the longer one.

    Closed form of Saint-Venant: J = pi a^3 b^3/(a^2 + b^2), the largest stress at the ends of the shorter axis.

    >>> round(Ellipse(semi_major=0.010, semi_minor=0.006).torsion_modulus * 1e9, 3)
    565.487
    """

    shape: ClassVar[str] = "ellipse"

    semi_major: float
    semi_minor: float

    def __check_init__(self) -> None:
        check_ellipse(semi_major=self.semi_major, semi_minor=self.semi_minor)

    def outline(self) -> Outline:
        """A quarter of the ellipse, by its eccentric angle."""
        a, b, quarter = self.semi_major, self.semi_minor, 0.5 * math.pi

        def curve(t: Points) -> tuple[Points, Points]:
            c, s = np.cos(quarter * t), np.sin(quarter * t)
            return np.stack([a * c, b * s], axis=1), quarter * np.stack([-a * s, b * c], axis=1)

        return Outline(((Curve(curve),),), rotations=2, mirror=True)

    @property
    def area(self) -> float:
        """Area pi a b [m^2]."""
        return math.pi * self.semi_major * self.semi_minor

    @property
    def torsion_constant(self) -> float:
        """J = pi a^3 b^3/(a^2 + b^2) [m^4]."""
        a, b = self.semi_major, self.semi_minor
        return math.pi * a**3 * b**3 / (a**2 + b**2)

    @property
    def torsion_modulus(self) -> float:
        """W = pi a b^2/2 [m^3], b the shorter semi-axis."""
        return 0.5 * math.pi * self.semi_major * self.semi_minor**2

    def properties(self) -> SectionProperties:
        """See ``Section.properties``."""
        a, b = self.semi_major, self.semi_minor
        return centred(
            area=self.area,
            second_moments=(0.25 * math.pi * a**3 * b, 0.25 * math.pi * a * b**3),
            torsion_constant=self.torsion_constant,
            torsion_modulus=self.torsion_modulus,
            stress_points=((0.0, float(b)), (0.0, -float(b))),
        )
