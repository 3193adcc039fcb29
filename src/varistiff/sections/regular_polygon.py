"""Regular polygons: one solution of the torsion problem each, scaled."""

from __future__ import annotations

import math
from functools import cache

from varistiff.sections.outline import Line, Outline
from varistiff.sections.properties import SectionProperties
from varistiff.sections.solved import solved_properties


def regular_polygon(sides: int, across: float) -> Outline:
    """Outline of a regular polygon with an inscribed circle of diameter ``across``; a flat faces the x axis."""
    a = 0.5 * across
    return Outline(((Line((a, 0.0), (a, a * math.tan(math.pi / sides))),),), rotations=sides, mirror=True)


@cache
def unit_polygon(sides: int) -> SectionProperties:
    """Properties of the regular polygon whose inscribed circle has the diameter 1."""
    return solved_properties(regular_polygon(sides, 1.0))


def scaled_polygon(sides: int, across: float) -> SectionProperties:
    """Properties of a regular polygon of any size, from the one of size 1."""
    unit = unit_polygon(sides)
    return SectionProperties(
        area=unit.area * across**2,
        centroid=(0.0, 0.0),
        second_moments=(unit.second_moments[0] * across**4, unit.second_moments[1] * across**4, 0.0),
        torsion_constant=unit.torsion_constant * across**4,
        torsion_modulus=unit.torsion_modulus * across**3,
        stress_points=tuple((x * across, y * across) for x, y in unit.stress_points),
        shear_centre=(0.0, 0.0),
        error=unit.error,
        method=unit.method,
    )
