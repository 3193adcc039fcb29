"""Tube with rails."""

from __future__ import annotations

import math
from typing import ClassVar

from varistiff.sections.limits import check_splined_tube
from varistiff.sections.outline import Arc, Line, Outline, Segment
from varistiff.sections.section import SolvedSection


class SplinedTube(SolvedSection):
    """Tube with evenly spaced rails outside, the elastic element of Schuy et al. (2013), Figs. 2 E and 5.

    A circular bore, a circle of the outer radius, and rails with parallel sides at +-rail_width/2 and a flat top at
    outer_radius + rail_height from the axis; rail 0 lies on the x axis.

    Parameters
    ----------
    outer_radius, inner_radius : of the tube without rails [m]; an inner radius of 0 leaves no bore
    rails : how many
    rail_width, rail_height : [m]
    root_fillet : radius between a rail's side and the tube [m]; 0 leaves a sharp root, where the ideal stress is
        unbounded and ``torsion_modulus`` is 0

    >>> tube = SplinedTube(
    ...     outer_radius=0.011, inner_radius=0.0087, rails=6, rail_width=0.004, rail_height=0.0025, root_fillet=0.0
    ... )
    >>> round(tube.torsion_constant * 1e9, 4), tube.torsion_modulus
    (16.4582, 0.0)
    """

    shape: ClassVar[str] = "splined_tube"

    outer_radius: float
    inner_radius: float
    rails: int
    rail_width: float
    rail_height: float
    root_fillet: float = 0.0

    def __check_init__(self) -> None:
        check_splined_tube(
            outer_radius=self.outer_radius,
            inner_radius=self.inner_radius,
            rails=self.rails,
            rail_width=self.rail_width,
            rail_height=self.rail_height,
            root_fillet=self.root_fillet,
        )

    def outline(self) -> Outline:
        """Half a rail with half the gap beside it."""
        side, top = 0.5 * self.rail_width, self.outer_radius + self.rail_height
        sector = math.pi / self.rails
        root, start, fillet = self._root(side)
        outer: list[Segment] = [Line((top, 0.0), (top, side))]
        if root < top:
            outer.append(Line((top, side), (root, side)))
        outer += fillet
        if start < sector:
            outer.append(Arc((0.0, 0.0), self.outer_radius, start, sector - start))
        bore = (Arc((0.0, 0.0), self.inner_radius, sector, -sector),)
        pieces = (tuple(outer), bore) if self.inner_radius > 0.0 else (tuple(outer),)
        return Outline(pieces, rotations=self.rails, mirror=True)

    def _root(self, side: float) -> tuple[float, float, list[Segment]]:
        """Where the straight side ends, at what angle the tube begins, and the fillet between them."""
        if self.root_fillet == 0.0:
            angle = math.asin(side / self.outer_radius)
            return self.outer_radius * math.cos(angle), angle, []
        reach, y = self.outer_radius + self.root_fillet, side + self.root_fillet
        x = math.sqrt(reach**2 - y**2)
        angle = math.atan2(y, x)
        return x, angle, [Arc((x, y), self.root_fillet, -0.5 * math.pi, angle - 0.5 * math.pi)]
