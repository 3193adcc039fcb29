"""A fixed series elastic actuator: one linear torsion spring, no setting."""

from __future__ import annotations

from typing import ClassVar

import jax.numpy as jnp

from varistiff.actuators.actuator import Actuator, Field, Response
from varistiff.actuators.from_energy import respond_from_energy


class SeriesElastic(Actuator):
    """V = k deflection^2/2 (Pratt and Williamson 1995), stated by its energy alone.

    Parameters
    ----------
    stiffness : k [N m/rad]

    Notes
    -----
    Valid wherever the spring is linear; the status is always ``ok``. Without a setting the adjusting load has no
    meaning and is NaN, and so is the stress of an unspecified spring.
    """

    kind: ClassVar[str] = "series_elastic"
    deflection_unit: ClassVar[str] = "rad"
    references: ClassVar[tuple[str, ...]] = ("pratt_1995",)

    stiffness: float

    @property
    def setting_unit(self) -> str | None:
        """No setting."""
        return None

    @property
    def strength(self) -> None:
        """An unspecified spring has no stress."""
        return None

    def energy(self, deflection: Field, setting: Field) -> Field:
        """V [J]."""
        del setting
        return 0.5 * self.stiffness * deflection**2

    def respond(self, deflection: Field, setting: Field) -> tuple[Response, dict[str, Field]]:
        """Derivatives of the energy; see ``Actuator.respond``."""
        response = respond_from_energy(self.energy, deflection, setting)
        return response._replace(adjusting_load=jnp.full_like(response.load, jnp.nan)), {}
