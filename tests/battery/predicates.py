"""Where a status begins, decided without the package: geometry, quadrature, and a boundary-value rod."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from scipy.integrate import quad
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import minimize_scalar

from independent.references.rod_bvp import Shape, roller_contact

Vector = tuple[float, float]


@lru_cache
def end_of_unit_rod(slope: float) -> Vector:
    """(a, b) of dos Santos and Richter's Eqs. (4) and (5) with lambda = 0, up to one factor.

    With theta = slope - u^2 the integrands cos(theta)/sqrt(sin(slope - theta)) lose their singular end.
    """

    def density(u: float) -> float:
        return 2.0 if u == 0 else 2 * u / math.sqrt(math.sin(u * u))

    end = math.sqrt(slope)
    a = quad(lambda u: density(u) * math.cos(slope - u * u), 0, end, epsabs=1e-12, limit=200)[0]
    b = quad(lambda u: density(u) * math.sin(slope - u * u), 0, end, epsabs=1e-12, limit=200)[0]
    return float(a), float(b)


def polar_angle(slope: float, ratio: float) -> float:
    """Polar angle of a lower roller's centre whose contact has this slope; ratio = r/|C|.

    The end T = C + r n scales with the unit rod: |factor (a, b) - ratio n| = 1.
    """
    a, b = end_of_unit_rod(slope)
    n = (-math.sin(slope), math.cos(slope))
    square, mixed = a * a + b * b, a * n[0] + b * n[1]
    factor = (ratio * mixed + math.sqrt((ratio * mixed) ** 2 - square * (ratio**2 - 1))) / square
    return math.atan2(factor * b - ratio * n[1], factor * a - ratio * n[0])


@lru_cache
def fold_angle(ratio: float) -> float:
    """Largest polar angle that any slope reaches: beyond it the rod slips off."""
    found = minimize_scalar(
        lambda slope: -polar_angle(slope, ratio), bounds=(2.0, 3.12), method="bounded", options={"xatol": 1e-7}
    )
    return -float(found.fun)


def distance_to_rod(shape: Shape, length: float, point: Vector) -> float:
    """Distance of a point from a rod with its straight tail, from its nodes by cubic splines."""
    fine = np.linspace(0, shape.length, 20001)
    x = CubicHermiteSpline(shape.s, shape.x, np.cos(shape.slope))(fine)
    y = CubicHermiteSpline(shape.s, shape.y, np.sin(shape.slope))(fine)
    tail = np.linspace(0, max(length - shape.length, 0), 20001)
    x = np.append(x, x[-1] + tail * math.cos(shape.end_slope))
    y = np.append(y, y[-1] + tail * math.sin(shape.end_slope))
    return float(np.hypot(x - point[0], y - point[1]).min())


@lru_cache
def rod(centre: Vector, radius: float, rigidity: float) -> Shape:
    """Deformed rod under a lower roller."""
    return roller_contact(centre, radius=radius, flexural_rigidity=rigidity)
