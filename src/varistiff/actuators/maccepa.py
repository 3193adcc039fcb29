"""MACCEPA: a lever, a cable and one preloaded spring (Van Ham et al. 2007)."""

from __future__ import annotations

from typing import ClassVar

import jax.numpy as jnp

from varistiff.actuators.actuator import Actuator, Field, Response, blank, first_status
from varistiff.actuators.from_energy import respond_from_energy

_SLACK_TOLERANCE = 1e-12  # an elongation [m] up to this counts as a slack cable


class Maccepa(Actuator):
    """V = k e^2/2 with the elongation e = A + P - |C - B| and A^2 = B^2 + C^2 - 2 B C cos(deflection).

    Stated by its energy alone. The setting is the pretension P [m], the spring's elongation at rest.

    Parameters
    ----------
    spring_rate : k [N/m]
    lever_length : B [m]
    anchor_distance : C [m], from the joint to the anchor of the cable; different from B

    Notes
    -----
    Valid for an inextensible cable without friction. A cable only pulls: with a negative pretension it hangs slack
    around rest, which is ``no_contact``. doi 10.1016/j.robot.2007.03.001.
    """

    kind: ClassVar[str] = "maccepa"
    deflection_unit: ClassVar[str] = "rad"
    loses_contact: ClassVar[bool] = True
    references: ClassVar[tuple[str, ...]] = ("van_ham_2007",)

    spring_rate: float
    lever_length: float
    anchor_distance: float

    @property
    def setting_unit(self) -> str | None:
        """The setting is a pretension, an elongation of the spring."""
        return "m"

    @property
    def strength(self) -> None:
        """An unspecified spring has no stress."""
        return None

    def elongation(self, deflection: Field, setting: Field) -> Field:
        """e [m]; negative where the cable is slack."""
        lever, distance = self.lever_length, self.anchor_distance
        # B^2 + C^2 - 2 B C cos(phi) without cancellation at small angles
        gap = (distance - lever) ** 2 + 4.0 * lever * distance * jnp.sin(0.5 * deflection) ** 2
        return jnp.sqrt(gap) + setting - jnp.abs(jnp.asarray(distance - lever))

    def energy(self, deflection: Field, setting: Field) -> Field:
        """V [J]."""
        return 0.5 * self.spring_rate * jnp.maximum(self.elongation(deflection, setting), 0.0) ** 2

    def respond(self, deflection: Field, setting: Field) -> tuple[Response, dict[str, Field]]:
        """Derivatives of the energy; see ``Actuator.respond``."""
        raw = respond_from_energy(self.energy, deflection, setting)
        slack = self.elongation(deflection, setting) <= _SLACK_TOLERANCE
        never = jnp.zeros_like(slack)
        status = first_status(
            no_solution=never,
            element_too_short=never,
            no_contact=slack,
            outside_validity=never,
            yielded=never,
        )
        energy, load, stiffness, adjusting = (
            blank(status, value) for value in (raw.energy, raw.load, raw.stiffness, raw.adjusting_load)
        )
        return Response(status, energy, load, stiffness, adjusting, raw.stress), {}
