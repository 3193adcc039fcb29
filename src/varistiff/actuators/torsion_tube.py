"""Variable torsion stiffness (VTS) of Schuy et al. (2013): a torsion element of variable active length."""

from __future__ import annotations

import math
from typing import ClassVar

import jax.numpy as jnp

from varistiff.actuators.actuator import Actuator, Field, Response, blank, first_status
from varistiff.elastic.torsion_bar import TorsionBar
from varistiff.sections import Circle, HollowCircle


class TorsionTube(Actuator):
    """Elastic element twisted between its flange and a counter bearing at the active length x.

        torque = k(x) deflection,   1/k = x/(G J) + 1/k_series,   V = k deflection^2/2

    Deflection is the twist [rad] over the whole drive train, setting the active length x [m]. The stress is the
    largest shear stress torque/W in the element, which yields at yield_strength/sqrt(3) (von Mises).

    Parameters
    ----------
    shear_modulus : G [Pa]
    section : cross-section with torsion_constant J and torsion_modulus W
    length : of the element [m]
    series_stiffness : of everything else in the drive train [N m/rad]
    yield_strength : tensile [Pa]

    Notes
    -----
    Saint-Venant torsion, free warping, linear material. Statuses: ``no_solution`` for x <= 0 (a rigid lock and no
    point of the map), ``element_too_short`` for x > length, ``yielded``. Schuy et al. (2013), Eqs. (1)-(5); Eq. (6)
    there carries a factor 2 that Eq. (5) does not.
    """

    kind: ClassVar[str] = "torsion_tube"
    deflection_unit: ClassVar[str] = "rad"
    references: ClassVar[tuple[str, ...]] = ("schuy_2013",)

    shear_modulus: float
    section: Circle | HollowCircle
    length: float = math.inf
    series_stiffness: float = math.inf
    yield_strength: float = math.inf

    @property
    def setting_unit(self) -> str | None:
        """The setting is the active length."""
        return "m"

    @property
    def strength(self) -> float:
        """Shear stress at yield, yield_strength/sqrt(3) after von Mises [Pa]."""
        return self.yield_strength / math.sqrt(3.0)

    @property
    def bar(self) -> TorsionBar:
        """The elastic law of this device."""
        return TorsionBar(self.shear_modulus * self.section.torsion_constant, 1.0 / self.series_stiffness)

    def energy(self, deflection: Field, setting: Field) -> Field:
        """V [J]; NaN where no solution exists."""
        return jnp.where(setting > 0.0, self.bar.energy(deflection, jnp.where(setting > 0.0, setting, 1.0)), jnp.nan)

    def respond(self, deflection: Field, setting: Field) -> tuple[Response, dict[str, Field]]:
        """Closed forms of the torsion bar; see ``Actuator.respond``."""
        length = jnp.where(setting > 0.0, setting, 1.0)
        bar = self.bar
        stiffness = bar.stiffness(length) + 0.0 * deflection
        torque = stiffness * deflection
        stress = jnp.abs(torque) / self.section.torsion_modulus
        never = jnp.zeros_like(stress, dtype=bool)
        status = first_status(
            no_solution=(setting <= 0.0) | never,
            element_too_short=(setting > self.length) | never,
            no_contact=never,
            outside_validity=never,
            yielded=stress > self.strength,
        )
        numbers = (
            bar.energy(deflection, length),
            torque,
            stiffness,
            bar.length_force(deflection, length),
            stress,
        )
        return Response(status, *(blank(status, value) for value in numbers)), {}
