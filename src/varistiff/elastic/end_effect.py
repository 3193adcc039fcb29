"""What the ends of a torsion element add to its length."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

Field = Float[Array, "..."]


class EndEffect(eqx.Module):
    """Effective length of a torsion element whose ends disturb the torsion between them.

        effective length = x + offset + lock_offset exp(-x/decay)

    Far from the flange (beyond about three radii) the disturbances at both ends are complete and add a constant
    length; close to it they merge, and at x = 0 a finite length offset + lock_offset is left where the ideal bar is
    rigid. An engineering model: its numbers are fitted to three-dimensional results between ``shortest`` and
    ``longest``, and it says nothing outside.

    Parameters
    ----------
    offset : length that the ends add far from the flange [m]; below zero where they stiffen
    lock_offset : what they add beyond that at x = 0 [m]
    decay : length over which it fades [m], above zero
    shortest, longest : active lengths that the numbers were fitted to [m]
    """

    offset: float
    lock_offset: float
    decay: float
    shortest: float
    longest: float

    def length(self, active_length: Field) -> Field:
        """Effective length [m]; below zero it means nothing."""
        return active_length + self.offset + self.lock_offset * jnp.exp(-active_length / self.decay)

    def rate(self, active_length: Field) -> Field:
        """d(effective length)/dx."""
        return 1.0 - self.lock_offset / self.decay * jnp.exp(-active_length / self.decay)

    def covers(self, active_length: Field) -> Field:
        """Whether the numbers were fitted to this length; a millionth is left for rounding."""
        low, high = self.shortest * (1.0 - 1e-6), self.longest * (1.0 + 1e-6)
        return (active_length >= low) & (active_length <= high)
