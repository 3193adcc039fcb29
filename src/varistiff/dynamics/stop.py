"""Mechanical stops at both ends of a travel."""

from __future__ import annotations

import math
from typing import NamedTuple

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

Scalar = Float[Array, ""]


class StopForce(NamedTuple):
    """Force of the stops on the part in its positive direction, its elastic energy and what it dissipates."""

    force: Scalar
    energy: Scalar
    loss: Scalar


class Stop(eqx.Module):
    """Compliant stops: a spring that pushes only, with the damping of Hunt and Crossley.

    With the depth p >= 0 and its rate p' the stop pushes with

        F = max(0, k p (1 + c p'))

    so force and loss start and end at zero, and nothing sticks. For a hard stop choose k large: the contact lasts
    about pi sqrt(m/k), which the step must resolve.

    Parameters
    ----------
    lower, upper : ends of the free travel [rad] or [m]; infinite where one end is open
    stiffness : k [N m/rad] or [N/m]
    damping : c [s/rad] or [s/m]; for a light impact at speed v the restitution is about 1 - 2 c v/3

    Notes
    -----
    Hunt and Crossley (1975), doi 10.1115/1.3423596.
    """

    lower: float = -math.inf
    upper: float = math.inf
    stiffness: float = 1e4
    damping: float = 0.0

    def gaps(self, position: Scalar) -> tuple[Scalar, Scalar]:
        """Distance to each end, negative in contact."""
        return position - self.lower, self.upper - position

    def push(self, position: Scalar, rate: Scalar) -> StopForce:
        """Force on the part, energy stored in the stop and power that it dissipates."""
        below, above = self.gaps(position)
        low, low_energy, low_loss = self._end(-below, -rate)
        high, high_energy, high_loss = self._end(-above, rate)
        return StopForce(low - high, low_energy + high_energy, low_loss + high_loss)

    def _end(self, depth: Scalar, closing: Scalar) -> tuple[Scalar, Scalar, Scalar]:
        inside = jnp.maximum(depth, 0.0)
        elastic = self.stiffness * inside
        force = elastic * jnp.maximum(0.0, 1.0 + self.damping * closing)
        return force, 0.5 * elastic * inside, (force - elastic) * closing


def push(stop: Stop | None, position: Scalar, rate: Scalar) -> StopForce:
    """What a stop does, or nothing where there is none."""
    if stop is None:
        still = 0.0 * position
        return StopForce(still, still, still)
    return stop.push(position, rate)
