"""The four-quadrant converter between the storage and the drives."""

from __future__ import annotations

import jax.numpy as jnp
from jaxtyping import Array, Float

Scalar = Float[Array, ""]


def converter_loss(power: Scalar, *, efficiency: float, regenerative: bool) -> Scalar:
    """Loss [W] at a power [W] on the drives' side; never below zero, 0 at rest.

        drawn, power > 0:      loss = (1/efficiency - 1) power
        returned, power < 0:   loss = (1 - efficiency) |power|, or all of it in a brake resistor

    Parameters
    ----------
    power : of the drives, below zero where they return it
    efficiency : of the converter, above 0 and up to 1, the same both ways
    regenerative : False for a drive that burns what comes back

    Notes
    -----
    Continuous, with a kink at 0. A converter at rest takes something too; that is left out.

    >>> float(converter_loss(80.0, efficiency=0.8, regenerative=True))
    20.0
    >>> float(converter_loss(-80.0, efficiency=0.8, regenerative=False))
    80.0
    """
    kept = 1.0 - efficiency if regenerative else 1.0
    return (1.0 / efficiency - 1.0) * jnp.maximum(power, 0.0) + kept * jnp.maximum(-power, 0.0)
