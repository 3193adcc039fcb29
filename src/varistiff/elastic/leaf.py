"""A straight leaf of rectangular cross-section."""

from __future__ import annotations

import math

import equinox as eqx
from jaxtyping import Array, Float


class Leaf(eqx.Module):
    """A straight, uniform, inextensible leaf that bends about its thickness.

    Parameters
    ----------
    youngs_modulus : E [Pa]
    width : b [m], across the plane of bending
    thickness : h [m], in the plane of bending
    length : free length [m]; infinite where the design does not limit it
    yield_strength : tensile yield strength [Pa]; infinite where the design gives none

    >>> round(Leaf(youngs_modulus=194e9, width=0.02545, thickness=0.00316).flexural_rigidity, 4)
    12.9828
    """

    youngs_modulus: float
    width: float
    thickness: float
    length: float = math.inf
    yield_strength: float = math.inf

    @property
    def second_moment(self) -> float:
        """Second moment of area I = b h^3/12 [m^4]."""
        return self.width * self.thickness**3 / 12.0

    @property
    def flexural_rigidity(self) -> float:
        """E I [N m^2]."""
        return self.youngs_modulus * self.second_moment

    def bending_stress(self, curvature: Float[Array, "..."]) -> Float[Array, "..."]:
        """Stress in the outer fibre E h |kappa|/2 [Pa] at a curvature [1/m]."""
        return 0.5 * self.youngs_modulus * self.thickness * abs(curvature)
