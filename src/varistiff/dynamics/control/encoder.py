"""Encoders: positions in counts."""

from __future__ import annotations

import math

import equinox as eqx
import jax
import jax.numpy as jnp

from varistiff.dynamics.control.checks import check_number
from varistiff.dynamics.control.controller import Number, Scalar, as_scalar


class Encoder(eqx.Module):
    """Reading of a position in whole steps: step round(position/step).

    The error is at most half a step and repeats with the position. Derivatives pass as if there were no steps: the
    true derivative of a staircase is 0 almost everywhere and tells nothing.

    Parameters
    ----------
    step : of the measured coordinate [rad] or [m]; 0 for an ideal encoder. ``rotary_encoder`` computes it

    Raises
    ------
    InputError : the step is negative or not finite
    """

    step: Number = 0.0

    def __check_init__(self) -> None:
        check_number("step", self.step, least=0.0)

    def read(self, position: Number) -> Scalar:
        """Reading [rad] or [m] at a position [rad] or [m].

        >>> float(Encoder(step=0.25).read(0.40))
        0.5
        """
        x = as_scalar(position)
        step = jnp.where(jnp.asarray(self.step) > 0.0, self.step, 1.0)
        rounded = jnp.where(jnp.asarray(self.step) > 0.0, step * jnp.round(x / step), x)
        return x + jax.lax.stop_gradient(rounded - x)


def rotary_encoder(counts_per_turn: float, ratio: float = 1.0) -> Encoder:
    """Encoder on a shaft that turns ``ratio`` times as far as the measured coordinate.

    Parameters
    ----------
    counts_per_turn : counts of the encoder in one turn of its own shaft, after quadrature; infinite for an ideal one
    ratio : encoder angle per coordinate: 1 on the joint's disc itself, the belt ratio on the drive motor behind a
        timing belt, the reducer's ratio at the tail of the setting motor; [rad/m] for a linear coordinate

    Raises
    ------
    InputError : a number is not positive

    >>> round(1e6 * rotary_encoder(4096, ratio=3.0).step, 3)
    511.327
    """
    check_number("counts_per_turn", counts_per_turn, above=0.0, infinite=True)
    check_number("ratio", ratio, above=0.0)
    return Encoder(2.0 * math.pi / (counts_per_turn * ratio))
