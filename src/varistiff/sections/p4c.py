"""Polygon profile P4C."""

from __future__ import annotations

import math
from typing import ClassVar

from varistiff.sections.limits import p4c_cut
from varistiff.sections.outline import Arc, Outline
from varistiff.sections.section import SolvedSection
from varistiff.sections.support_curve import support_curve


class P4C(SolvedSection):
    """Four-sided polygon profile P4C of DIN 32712: the curve of P3G with 4 for 3, cut by a circle.

    The support function is h(a) = Dm/2 - e cos 4a with Dm/2 = inner_diameter/2 + e; the circle of the outer diameter
    cuts the curve before the loops that it makes outside.

    Parameters
    ----------
    inner_diameter : distance of opposite flats [m]
    outer_diameter : of the cutting circle [m]
    eccentricity : e [m]

    >>> round(P4C(inner_diameter=0.021, outer_diameter=0.025, eccentricity=0.0035).area * 1e6, 1)
    410.1
    """

    shape: ClassVar[str] = "p4c"

    inner_diameter: float
    outer_diameter: float
    eccentricity: float

    def __check_init__(self) -> None:
        self._cut()

    def _cut(self) -> tuple[float, float]:
        return p4c_cut(
            inner_diameter=self.inner_diameter,
            outer_diameter=self.outer_diameter,
            eccentricity=self.eccentricity,
        )

    def outline(self) -> Outline:
        """An eighth of the profile: half a flat and half an arc."""
        end, angle = self._cut()
        flat = support_curve(
            mean_radius=0.5 * self.inner_diameter + self.eccentricity,
            eccentricity=self.eccentricity,
            lobes=4,
            end=end,
        )
        arc = Arc((0.0, 0.0), 0.5 * self.outer_diameter, angle, 0.25 * math.pi - angle)
        return Outline(((flat, arc),), rotations=4, mirror=True)
