"""Equation (9) of Wang et al. (2024) solved for the active length."""

from __future__ import annotations

import jax.numpy as jnp

from varistiff.dynamics.control.controller import Number, Scalar, as_scalar


def active_length_from_stiffness(stiffness: Number, *, bending: Number, clamp_radius: Number) -> Scalar:
    """l_1 > 0 with the stiffness K = c (r_2 + l_1)^2/l_1^3 at rest, the only one.

    The cubic K l^3 = c (r_2 + l)^2 has a single real root. With u = c/(3 K) it is

        l = u + w + (u^2 + 2 u r)/w,    w^3 = u^3 + 3 u^2 r + 3 u r^2/2 + u r sqrt(r (u + 9 r/4))

    (Cardano), a sum of positive terms, so that nothing cancels.

    Parameters
    ----------
    stiffness : K [N m/rad], above 0
    bending : c = N E b h^3/4 = 3 N E I [N m^2]
    clamp_radius : r = r_2 [m]

    Notes
    -----
    Wang et al. (2024), Eq. (9) at phi = 0, doi 10.3390/app14072685. At rest the exact leaf has the same stiffness.

    >>> round(float(active_length_from_stiffness(206.0, bending=1.2875, clamp_radius=0.025)), 12)
    0.025
    """
    r = as_scalar(clamp_radius)
    u = as_scalar(bending) / (3.0 * as_scalar(stiffness))
    w = jnp.cbrt(u * (u**2 + 3.0 * u * r + 1.5 * r**2 + r * jnp.sqrt(r * (u + 2.25 * r))))
    return u + w + u * (u + 2.0 * r) / w
