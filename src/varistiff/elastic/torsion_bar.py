"""A straight bar in Saint-Venant torsion, with a compliance in series."""

from __future__ import annotations

import equinox as eqx
from jaxtyping import Array, Float

Field = Float[Array, "..."]


class TorsionBar(eqx.Module):
    """Bar of torsional rigidity G J whose length varies, in series with everything else.

    Parameters
    ----------
    rigidity : G J [N m^2]
    series_compliance : of the rest of the drive train [rad/(N m)]; 0 for a rigid one
    """

    rigidity: float
    series_compliance: float

    def stiffness(self, length: Field) -> Field:
        """k = 1/(length/(G J) + 1/k_series) [N m/rad]."""
        return self.rigidity / (length + self.rigidity * self.series_compliance)

    def energy(self, twist: Field, length: Field) -> Field:
        """V = k twist^2/2 [J], of the bar and what is in series with it."""
        return 0.5 * self.stiffness(length) * twist**2

    def length_force(self, twist: Field, length: Field) -> Field:
        """dV/d(length) = -torque^2/(2 G J) [N]: only the bar's own compliance depends on its length."""
        return -((self.stiffness(length) * twist) ** 2) / (2.0 * self.rigidity)
