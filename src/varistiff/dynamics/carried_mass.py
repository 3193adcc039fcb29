"""A mass that the setting moves, riding on a turning body."""

from __future__ import annotations

from typing import Literal, NamedTuple

import equinox as eqx
from jaxtyping import Array, Float

from varistiff.dynamics.path import Affine, Path

Scalar = Float[Array, ""]
Body = Literal["link", "drive", "ground"]


class Carried(NamedTuple):
    """What the mass adds at one coordinate z: to the body's inertia, to the setting's, and their rates with z."""

    body_inertia: Scalar
    body_rate: Scalar
    own_inertia: Scalar
    own_rate: Scalar


class CarriedMass(eqx.Module):
    """Mass m at the radius rho(z) of the body that carries it.

    Its kinetic energy m/2 (rho'^2 z'^2 + rho^2 w^2) gives, by Lagrange, the inertia m rho^2 with the Coriolis torque
    2 m rho rho' z' w on the body, and the inertia m rho'^2 with the centrifugal force -m rho rho' w^2 on the setting.

    Parameters
    ----------
    mass : m [kg], all sliders together
    radius : rho(z) [m]
    body : "link", "drive", or "ground" for one that turns with neither (a nut, a slider along the axis)
    """

    mass: float = 0.0
    radius: Path = Affine()
    body: Body = eqx.field(static=True, default="ground")

    def at(self, motion: Scalar) -> Carried:
        """Inertias and their rates with the coordinate."""
        rho = self.radius.at(motion)
        return Carried(
            body_inertia=self.mass * rho.value**2,
            body_rate=2.0 * self.mass * rho.value * rho.slope,
            own_inertia=self.mass * rho.slope**2,
            own_rate=2.0 * self.mass * rho.slope * rho.curvature,
        )
