"""Arrangements of the rollers that bend the beam of a roller beam actuator.

Each answers which roller acts and where its centre sits. ``side`` is +1 for the lower roller, which pushes the beam
to +y, and -1 for the upper one, which is its mirror image.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from typing import NamedTuple

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

Field = Float[Array, "..."]
Place = Callable[[Field], tuple[Field, Field]]


class Bearing(NamedTuple):
    """The acting roller; one shape for all fields."""

    side: Field
    offset: Field  # of its centre from the link's axis [m]
    radius: Field  # from its centre to the beam's centreline [m]


class Rollers(eqx.Module):
    """One or two rollers on a shuttle."""

    @abstractmethod
    def acting(self, place: Place, thickness: float) -> Bearing:
        """Roller that bears; ``place(offset)`` is the centre (x, y) in the clamp's frame [m]."""

    def partner(self, bearing: Bearing, thickness: float) -> Field | None:
        """Offset of the roller that must stay clear of the beam [m], None where there is none."""
        del bearing, thickness
        return None


class SingleLower(Rollers):
    """One roller below the beam, its centre ``offset`` from the link's axis; sizes in m."""

    offset: float
    radius: float

    def acting(self, place: Place, thickness: float) -> Bearing:
        """The only roller."""
        one = jnp.ones_like(place(jnp.asarray(self.offset))[1])
        return Bearing(one, self.offset * one, (self.radius + 0.5 * thickness) * one)


class SingleUpper(Rollers):
    """One roller above the beam, its centre ``offset`` from the link's axis; sizes in m."""

    offset: float
    radius: float

    def acting(self, place: Place, thickness: float) -> Bearing:
        """The only roller, seen in the mirror."""
        one = jnp.ones_like(place(jnp.asarray(self.offset))[1])
        return Bearing(-one, self.offset * one, (self.radius + 0.5 * thickness) * one)


class FixedPair(Rollers):
    """Two rollers fixed to the shuttle on both sides of the beam, each ``clearance`` from it at rest; sizes in m."""

    offset: float
    radius: float
    clearance: float

    def acting(self, place: Place, thickness: float) -> Bearing:
        """The roller that overlaps the undeformed beam more, which keeps the device mirror-symmetric."""
        radius = self.radius + 0.5 * thickness
        spread = radius + self.clearance
        low = place(jnp.asarray(self.offset - spread))[1]
        high = place(jnp.asarray(self.offset + spread))[1]
        side = jnp.where(low + high < 0.0, -1.0, 1.0)
        return Bearing(side, self.offset - side * spread, radius + 0.0 * side)

    def partner(self, bearing: Bearing, thickness: float) -> Field | None:
        """The roller on the other side."""
        return self.offset + bearing.side * (self.radius + 0.5 * thickness + self.clearance)


class SwivellingPair(Rollers):
    """Two rollers on a pivot that turns with the beam, ``clearance`` of play at rest; the paper's shuttle.

    The pair aligns itself with the beam, so its radius drops out: the contact lies beyond the pivot by the clearance.
    """

    offset: float
    clearance: float

    def acting(self, place: Place, thickness: float) -> Bearing:
        """Lower roller for a pivot above the undeformed beam, upper one below."""
        del thickness
        height = place(jnp.asarray(self.offset))[1]
        side = jnp.where(height < 0.0, -1.0, 1.0)
        return Bearing(side, self.offset + 0.0 * side, -self.clearance + 0.0 * side)
