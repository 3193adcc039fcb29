"""Saint-Venant's series for a sector of the unit circle, as in Timoshenko and Goodier, 3rd ed., art. 110."""

from __future__ import annotations

import math


def sector_torsion_constant(angle: float) -> float:
    """J of a sector with this opening angle [rad]; not for a right angle nor three, where two terms cancel.

    The terms fall with n^-5; what 4000 of them leave out is below 1e-14 of J.
    """
    total = 0.0
    for n in range(1, 8000, 2):
        order = n * math.pi / angle
        total += 1.0 / (order**2 * (order**2 - 4.0) * (order + 2.0))
    return 0.25 * (math.tan(angle) - angle) - 32.0 / angle * total


# load through the shear centre of a semicircle at Poisson's ratio 0, from the middle of the diameter over the radius:
# 8/(15 pi) (3 + 4 nu)/(1 + nu), Timoshenko and Goodier, 3rd ed., art. 126
SEMICIRCLE_SHEAR_CENTRE = 8.0 / (5.0 * math.pi)
