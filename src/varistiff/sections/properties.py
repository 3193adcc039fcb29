"""Everything that a designer asks of a cross-section."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SectionProperties:
    """Properties of a cross-section in its own coordinates, SI units.

    Parameters
    ----------
    area : [m^2]
    centroid : [m]
    second_moments : about the centroid: integrals of x^2, y^2 and x y over the area [m^4]
    torsion_constant : J [m^4]: torque = G J twist per length
    torsion_modulus : W [m^3]: the largest shear stress is torque/W; 0 where a re-entrant corner makes it unbounded
    stress_points : where that stress sits [m], with its images by symmetry; the corners where it is unbounded
    shear_centre : [m]
    error : relative error of J: 0 for a closed form or series, else the difference from a coarser solution. Of a
        solved torsion modulus it says nothing; that was found good to 1e-6 where the boundary is smooth
    method : "closed form", "series" or "boundary integral"
    """

    area: float
    centroid: tuple[float, float]
    second_moments: tuple[float, float, float]
    torsion_constant: float
    torsion_modulus: float
    stress_points: tuple[tuple[float, float], ...]
    shear_centre: tuple[float, float]
    error: float
    method: str
