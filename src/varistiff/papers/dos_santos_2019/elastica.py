"""Equations (2) to (5), (12) and (15): the load of a cantilever whose tip force stays normal to it.

With the contact's lambda = 0 and n = tan(theta_0), the integrand's root is sqrt(sin(theta_0 - theta)/cos(theta_0)).
The paper's load parameter is alpha_0 = sqrt(2 P L^2/(E I)), by its Eqs. (3) and (15).
"""

from __future__ import annotations

import math
from functools import cache

import jax
import jax.numpy as jnp
import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq, minimize_scalar

from varistiff.elastic.lemniscate import slope_terms

_slope_terms = jax.jit(slope_terms)  # one by one, its operations take a millisecond each


def load_parameter(slope: float) -> float:
    """alpha_0 of the contact slope theta_0 [rad] by Eq. (3) without its 1/sqrt(2): I_1(theta_0) sqrt(cos theta_0).

    Below 90 degrees, where n = tan(theta_0) exists.

    >>> round(load_parameter(0.01), 6)
    0.199995
    """
    terms = _slope_terms(jnp.asarray(slope))
    return 2.0 * math.sqrt(float(terms.sine) * float(terms.cosine)) * float(terms.length_ratio)


def contact_place(slope: float) -> tuple[float, float]:
    """a/L and b/L of the contact slope [rad] by Eqs. (4) and (5) with the factor of Eq. (15)."""
    s, c, h, _, length = (float(term) for term in _slope_terms(jnp.asarray(slope)))
    return (c + h * s) / length, (s - h * c) / length


@cache
def load_limit() -> tuple[float, float]:
    """Largest alpha_0 of any equilibrium, and its slope [rad]: beyond it, alpha_0 falls again to zero at 90 degrees."""
    found = minimize_scalar(lambda slope: -load_parameter(slope), bounds=(0.5, 1.5), method="bounded")
    return -float(found.fun), float(found.x)


def slope_of(alpha: float) -> float:
    """Contact slope [rad] of a load parameter, on the branch that starts at rest.

    Raises
    ------
    ValueError : no equilibrium has such a load
    """
    limit, at = load_limit()
    if not 0.0 < alpha < limit:
        raise ValueError(f"no contact slope has the load parameter {alpha:g}; the largest is {limit:.4f}")
    return float(brentq(lambda slope: load_parameter(slope) - alpha, 1e-9, at, xtol=1e-14))


def printed_integral(slope: float, weight: str = "one") -> float:
    """The integral of Eq. (3), (4) or (5) from 0 to theta_0, by quadrature: no formula of the toolkit is used.

    Parameters
    ----------
    slope : theta_0 below 90 degrees [rad]
    weight : ``one``, ``cos`` or ``sin``, what stands over the root

    Notes
    -----
    theta = theta_0 - u^2 takes the root's zero at the contact out of the integrand.
    """
    over = {"one": lambda angle: 1.0, "cos": math.cos, "sin": math.sin}[weight]

    def integrand(u: float) -> float:
        gap = u * u
        root = math.sqrt(math.sin(gap) / gap / math.cos(slope)) if gap > 0.0 else 1.0 / math.sqrt(math.cos(slope))
        return 2.0 * over(slope - gap) / root

    return float(quad(integrand, 0.0, math.sqrt(slope), epsabs=1e-13, epsrel=1e-13)[0])


def printed_load_parameter(slope: float) -> float:
    """alpha_0 as Eq. (3) prints it: the integral over sqrt(2), which its own definition has absorbed already."""
    return printed_integral(slope) / math.sqrt(2.0)


def defined_force(alpha: float, *, active_length: float, flexural_rigidity: float) -> float:
    """P [N] of Eq. (15), (alpha_0/L)^2 E I/2; lengths in m, E I in N m^2."""
    return (alpha / active_length) ** 2 * flexural_rigidity / 2.0


def defined_load(force: float, *, active_length: float, flexural_rigidity: float) -> float:
    """alpha_0 of a transverse force P [N], the inverse of Eq. (15)."""
    return active_length * math.sqrt(2.0 * force / flexural_rigidity)


def printed_roots(ratio: float, *, points: int = 4000) -> int:
    """How many slopes below 90 degrees solve Eq. (12), b/a of theta_0 alone, for a given b/a."""
    slopes = np.linspace(0.0, 0.5 * math.pi, points + 2)[1:-1]
    terms = _slope_terms(jnp.asarray(slopes))
    s, c, h = np.asarray(terms.sine), np.asarray(terms.cosine), np.asarray(terms.offset_ratio)
    above = (s - h * c) / (c + h * s) > ratio
    return int(np.count_nonzero(above[1:] != above[:-1]))
