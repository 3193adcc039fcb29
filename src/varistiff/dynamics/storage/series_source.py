"""A voltage behind a resistance, asked for a power."""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
from jaxtyping import Array, Float

Scalar = Float[Array, ""]


class Drawn(NamedTuple):
    """Current [A] out of the source, the power that arrives [W], and what was asked beyond it [W]."""

    current: Scalar
    delivered: Scalar
    shortfall: Scalar


def draw(power: Scalar, *, voltage: Scalar, resistance: float) -> Drawn:
    """Current of a source V behind R that delivers a power P: the smaller root of R i^2 - V i + P = 0.

        i = 2 P/(V + sqrt(V^2 - 4 R P)),   P at most V^2/(4 R), where i = V/(2 R)

    Parameters
    ----------
    power : asked at the terminals [W]; below zero charges the source
    voltage : V [V]
    resistance : R [ohm], not below zero

    Notes
    -----
    What is asked beyond V^2/(4 R) is the shortfall. A source that is empty, V <= 0, gives nothing; without a
    resistance it takes nothing either, and the shortfall is below zero. At the largest power the current's derivative
    is unbounded.

    >>> [round(float(x), 6) for x in draw(16.0, voltage=10.0, resistance=1.0)]
    [2.0, 16.0, 0.0]
    >>> [round(float(x), 6) for x in draw(30.0, voltage=10.0, resistance=1.0)]
    [5.0, 25.0, 5.0]
    """
    room = voltage**2 - 4.0 * resistance * power
    # each where keeps the branch that is not taken finite, for the gradient
    most = 0.25 * voltage**2 / jnp.where(room < 0.0, resistance, 1.0)
    delivered = jnp.where(room < 0.0, most, power)
    root = jnp.where(room > 0.0, jnp.sqrt(jnp.where(room > 0.0, room, 1.0)), 0.0)
    bottom = voltage + root
    able = bottom > 0.0  # an empty source gives nothing
    delivered = jnp.where(able, delivered, 0.0)
    current = jnp.where(able, 2.0 * delivered / jnp.where(able, bottom, 1.0), 0.0)
    return Drawn(current, delivered, power - delivered)
