"""Groove disc of Wang et al. (2024): disc angle against active length."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.elastic.lemniscate import circular

Field = Float[Array, "..."]


class Groove(eqx.Module):
    """Circular groove through A = (0, r_2) and C = r_1 (sin a_1, cos a_1); a slider in a radial slot rides in it.

    A disc turned by the angle a from A puts the slider at the radius l_2(a):

        l_2 = e_3 +- sqrt(e_3^2 - e_4),  e_3 = x_o sin a + y_o cos a,  e_4 = x_o^2 + y_o^2 - r_s^2

    with the sign of the branch through A and C. Two centres (x_o, y_o) fit the same arc radius; ``near`` is the one
    closer to the axis.

    Parameters
    ----------
    inner_radius : r_2, where the active length is zero [m]
    outer_radius : r_1 [m]
    outer_angle : a_1 [rad]
    arc_radius : r_s [m], at least half the distance from A to C
    centre : "near" or "far" from the axis

    Notes
    -----
    Wang et al. (2024), Eqs. (13)-(15), doi 10.3390/app14072685. In the printed (14) l_2 stands for r_1; derived
    anew from the three circle conditions.
    """

    inner_radius: float
    outer_radius: float
    outer_angle: float
    arc_radius: float
    centre: str = eqx.field(static=True, default="near")

    @property
    def centre_position(self) -> tuple[Field, Field]:
        """(x_o, y_o) [m]; NaN where no circle of this radius passes through A and C."""
        r_1, r_2, r_s = self.outer_radius, self.inner_radius, self.arc_radius
        sine, cosine = jnp.sin(self.outer_angle), jnp.cos(self.outer_angle)
        e_1 = (r_1**2 - r_2**2) / (2.0 * r_1 * sine)
        e_2 = (r_2 - r_1 * cosine) / (r_1 * sine)
        quadratic = e_2**2 + 1.0
        middle = r_2 - e_1 * e_2
        root = jnp.sqrt(middle**2 - quadratic * (e_1**2 + r_2**2 - r_s**2))
        low, high = (middle - root) / quadratic, (middle + root) / quadratic
        low_is_near = (e_1 + e_2 * low) ** 2 + low**2 <= (e_1 + e_2 * high) ** 2 + high**2
        y = jnp.where(low_is_near == (self.centre == "near"), low, high)
        return e_1 + e_2 * y, y

    def _terms(self, angle: Field) -> tuple[Field, Field, Field]:
        """e_3, its derivative, and the signed root."""
        x, y = self.centre_position
        sine, cosine = circular(angle)  # one polynomial pair: a time loop asks often
        e_3 = x * sine + y * cosine
        rate = x * cosine - y * sine
        branch = jnp.where(self.inner_radius >= y, 1.0, -1.0)  # at A: e_3 = y_o and l_2 = r_2
        square = e_3**2 - (x**2 + y**2 - self.arc_radius**2)
        return e_3, rate, branch * jnp.sqrt(jnp.maximum(square, 0.0))

    def active_length(self, angle: Field) -> Field:
        """l_1 = l_2(a) - r_2 [m]; 0 at A."""
        e_3, _, root = self._terms(angle)
        return e_3 + root - self.inner_radius

    def active_length_rate(self, angle: Field) -> Field:
        """dl_1/da [m/rad]."""
        e_3, rate, root = self._terms(angle)
        return rate * (e_3 + root) / root

    def angle(self, active_length: Field) -> Field:
        """Smallest disc angle [rad] on the groove for an active length [m]; NaN off the groove."""
        x, y = self.centre_position
        radius = self.inner_radius + active_length
        distance = jnp.hypot(x, y)
        cosine = (radius**2 + distance**2 - self.arc_radius**2) / (2.0 * radius * distance)
        swing = jnp.arccos(cosine)  # NaN where the circle has no such radius
        direction = jnp.arctan2(x, y)
        turn = 2.0 * jnp.pi
        crossings = [(direction + side * swing + jnp.pi) % turn - jnp.pi for side in (-1.0, 1.0)]
        # the disc meets the first crossing on the groove before any other
        on_groove = [jnp.where((c > 0.0) & (c <= self.outer_angle * (1.0 + 1e-9)), c, jnp.inf) for c in crossings]
        found = jnp.minimum(*on_groove)
        return jnp.where(jnp.isfinite(found), found, jnp.nan)

    def reaches(self, angle: Field) -> Array:
        """Whether the disc angle lies on the groove, beyond A and up to C (a rounding error beyond C is allowed)."""
        slack = 1e-12 * self.outer_angle
        return (angle > 0.0) & (angle <= self.outer_angle + slack)
