"""Variable torsion stiffness (VTS) of Schuy et al. (2013): a torsion element of variable active length."""

from __future__ import annotations

import math
from typing import ClassVar

import jax.numpy as jnp

from varistiff.actuators.actuator import Actuator, Constant, Field, Response, blank, first_status
from varistiff.elastic.end_effect import EndEffect
from varistiff.elastic.torsion_bar import TorsionBar
from varistiff.sections.section import Section


class TorsionTube(Actuator):
    """Elastic element twisted between its flange and a counter bearing at the active length x.

        torque = k(x) deflection,   1/k = x/(G J) + 1/k_series,   V = k deflection^2/2

    Deflection is the twist [rad] over the whole drive train, setting the active length x [m]. The stress is the
    largest shear stress torque/W in the element, which yields at yield_strength/sqrt(3) (von Mises).

    Parameters
    ----------
    shear_modulus : G [Pa]
    section : cross-section with torsion constant J and torsion modulus W, which are taken from it once
    length : of the element [m]
    series_stiffness : of everything else in the drive train [N m/rad]
    yield_strength : tensile [Pa]
    end_effect : what the ends add to x, fitted to three-dimensional results; None for the ideal bar

    Notes
    -----
    Saint-Venant torsion, free warping, linear material. Statuses: ``no_solution`` for x <= 0 (a rigid lock and no
    point of the map), ``element_too_short`` for x > length, ``outside_validity`` where the end effect was not fitted,
    ``yielded``. At a sharp re-entrant corner (W = 0) the ideal stress is infinite under load and never sets
    ``yielded``. Schuy et al. (2013), Eqs. (1)-(5); Eq. (6) there carries a factor 2 that Eq. (5) does not.
    """

    kind: ClassVar[str] = "torsion_tube"
    deflection_unit: ClassVar[str] = "rad"
    references: ClassVar[tuple[str, ...]] = ("schuy_2013",)
    broken_assumption: ClassVar[str] = "the end model was not fitted to this active length"

    shear_modulus: float
    section: Section
    torsion_constant: float
    torsion_modulus: float
    length: float
    series_stiffness: float
    yield_strength: float
    end_effect: EndEffect | None

    def __init__(
        self,
        *,
        shear_modulus: float,
        section: Section,
        length: float = math.inf,
        series_stiffness: float = math.inf,
        yield_strength: float = math.inf,
        end_effect: EndEffect | None = None,
    ) -> None:
        self.shear_modulus = shear_modulus
        self.section = section
        self.torsion_constant = section.torsion_constant  # a solved section gives numbers, no traced functions
        self.torsion_modulus = section.torsion_modulus
        self.length = length
        self.series_stiffness = series_stiffness
        self.yield_strength = yield_strength
        self.end_effect = end_effect

    @property
    def setting_unit(self) -> str | None:
        """The setting is the active length."""
        return "m"

    @property
    def strength(self) -> float:
        """Shear stress at yield, yield_strength/sqrt(3) after von Mises [Pa]."""
        return self.yield_strength / math.sqrt(3.0)

    @property
    def constants(self) -> dict[str, Constant]:
        """What the section is; see ``varistiff.sections``."""
        from varistiff.actuators.section_constants import section_constants

        return section_constants(self.section)

    @property
    def bar(self) -> TorsionBar:
        """The elastic law of this device."""
        return TorsionBar(self.shear_modulus * self.torsion_constant, 1.0 / self.series_stiffness)

    def effective_length(self, setting: Field) -> Field:
        """Length of an ideal bar with the same twist [m]: the active length itself without an end effect."""
        return setting if self.end_effect is None else self.end_effect.length(setting)

    def energy(self, deflection: Field, setting: Field) -> Field:
        """V [J]; NaN where no solution exists."""
        length = self.effective_length(setting)
        exists = (setting > 0.0) & (length > 0.0)
        return jnp.where(exists, self.bar.energy(deflection, jnp.where(exists, length, 1.0)), jnp.nan)

    def respond(self, deflection: Field, setting: Field) -> tuple[Response, dict[str, Field]]:
        """Closed forms of the torsion bar; see ``Actuator.respond``."""
        length = self.effective_length(setting)
        exists = (setting > 0.0) & (length > 0.0)
        length = jnp.where(exists, length, 1.0)
        rate = 1.0 if self.end_effect is None else self.end_effect.rate(setting)
        bar = self.bar
        stiffness = bar.stiffness(length) + 0.0 * deflection
        torque = stiffness * deflection
        # W = 0 says that the ideal stress has no bound
        bounded = self.torsion_modulus > 0.0
        unbounded = jnp.where(torque == 0.0, 0.0, jnp.inf)
        stress = jnp.where(bounded, jnp.abs(torque) / jnp.where(bounded, self.torsion_modulus, 1.0), unbounded)
        never = jnp.zeros_like(stress, dtype=bool)
        status = first_status(
            no_solution=jnp.logical_not(exists) | never,
            element_too_short=(setting > self.length) | never,
            no_contact=never,
            outside_validity=never
            if self.end_effect is None
            else jnp.logical_not(self.end_effect.covers(setting)) | never,
            yielded=bounded & (stress > self.strength),
        )
        numbers = (
            bar.energy(deflection, length),
            torque,
            stiffness,
            bar.length_force(deflection, length) * rate + 0.0,  # no negative zero at rest
            stress,
        )
        return Response(status, *(blank(status, value) for value in numbers)), {}
