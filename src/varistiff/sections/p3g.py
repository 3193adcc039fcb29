"""Polygon profile P3G."""

from __future__ import annotations

import math
from typing import ClassVar

from varistiff.sections.limits import check_p3g
from varistiff.sections.outline import Outline
from varistiff.sections.section import SolvedSection
from varistiff.sections.support_curve import support_curve


class P3G(SolvedSection):
    """Three-lobed polygon profile P3G of DIN 32711.

    The envelope of its tangents, with the support function h(a) = Dm/2 - e cos 3a:

        x = h cos a - h' sin a,   y = h sin a + h' cos a,   a from 0 to 2 pi

    Parameters
    ----------
    mean_diameter : Dm [m]; the profile has this width in every direction
    eccentricity : e [m], from 0 to below Dm/16, where the curvature would vanish

    >>> round(P3G(mean_diameter=0.02, eccentricity=0.0).torsion_constant * 1e9, 4)  # a circle
    15.708
    """

    shape: ClassVar[str] = "p3g"

    mean_diameter: float
    eccentricity: float

    def __check_init__(self) -> None:
        check_p3g(mean_diameter=self.mean_diameter, eccentricity=self.eccentricity)

    def outline(self) -> Outline:
        """A sixth of the profile."""
        curve = support_curve(
            mean_radius=0.5 * self.mean_diameter, eccentricity=self.eccentricity, lobes=3, end=math.pi / 3.0
        )
        return Outline(((curve,),), rotations=3, mirror=True)
