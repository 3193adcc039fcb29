"""The two special functions of an elastica under a normal tip force, without their square roots.

With I1(t) = int_0^t dpsi/sqrt(sin psi) and I2(t) = int_0^t sqrt(sin psi) dpsi, the ratios

    length_ratio(t) = I1(t)/(2 sqrt(sin t)),    offset_ratio(t) = I2(t)/(2 sqrt(sin t))

are analytic on |t| < pi. Up to t = pi/2 each is a polynomial in t^2 (its nearest singularity is t^2 = pi^2, so 15
terms reach 1e-17); beyond, I1(t) = 2 c - I1(pi - t) and I2(t) = 2 pi/c - I2(pi - t) with the lemniscate constant c
reflect them. The coefficients are written by ``tools/contact_coefficients.py``.
"""

from __future__ import annotations

import json
import math
from importlib.resources import files
from typing import NamedTuple

import jax.numpy as jnp
from jax import lax
from jaxtyping import Array, Float

from varistiff.elastic.polynomial import estrin

LEMNISCATE_CONSTANT = 2.6220575542921198105
_PI_REST = 1.2246467991473532e-16  # pi less its nearest double: near the fold it is not negligible

COEFFICIENTS = json.loads(files("varistiff.elastic").joinpath("contact_coefficients.json").read_text("utf-8"))

Field = Float[Array, "..."]


class SlopeTerms(NamedTuple):
    """Everything that a contact slope t in [0, pi) enters through; all shapes equal that of ``slope``."""

    sine: Field  # sin t
    cosine: Field  # cos t
    offset_ratio: Field  # I2/(2 sqrt(sin t)), about t/3
    offset_over_sine: Field  # the same divided by sin t, 1/3 at t = 0
    length_ratio: Field  # I1/(2 sqrt(sin t)), 1 at t = 0


def slope_terms(slope: Field) -> SlopeTerms:
    """Sine, cosine and both ratios at once, for 0 <= slope < pi; relative error about 1e-15."""
    beyond = slope > 0.5 * math.pi
    folded = jnp.where(beyond, (math.pi - slope) + _PI_REST, slope)
    square = folded * folded
    sine_ratio = estrin(COEFFICIENTS["sine"], square)
    sine = folded * sine_ratio
    cosine = jnp.where(beyond, -1.0, 1.0) * estrin(COEFFICIENTS["cosine"], square)
    near_offset = estrin(COEFFICIENTS["offset"], square)
    near_length = estrin(COEFFICIENTS["length"], square)
    # the guard keeps derivatives finite at slope 0, where the reflected branch is not taken
    inverse_root = lax.rsqrt(jnp.where(beyond, sine, 1.0))
    offset = jnp.where(
        beyond, (math.pi / LEMNISCATE_CONSTANT) * inverse_root - folded * near_offset, folded * near_offset
    )
    length = jnp.where(beyond, LEMNISCATE_CONSTANT * inverse_root - near_length, near_length)
    offset_over_sine = jnp.where(beyond, offset * inverse_root * inverse_root, near_offset / sine_ratio)
    return SlopeTerms(sine, cosine, offset, offset_over_sine, length)


def length_ratio(slope: Field) -> Field:
    """I1(t)/(2 sqrt(sin t)): arc length over the distance of the contact along its own tangent.

    >>> round(float(length_ratio(jnp.asarray(1.0))), 12)
    1.109106615831
    """
    return slope_terms(jnp.asarray(slope)).length_ratio


def offset_ratio(slope: Field) -> Field:
    """I2(t)/(2 sqrt(sin t)): distance of the clamp across the contact's tangent over that along it.

    >>> round(float(offset_ratio(jnp.asarray(1.0))), 12)
    0.350466328007
    """
    return slope_terms(jnp.asarray(slope)).offset_ratio


def circular(angle: Field) -> tuple[Field, Field]:
    """Sine and cosine of any moderate angle (|angle| < 1e5 rad), error below 1e-15.

    One polynomial pair for both; on a CPU about five times faster than two library calls.
    """
    quadrant = jnp.round(angle * (2.0 / math.pi))
    # two-part pi/2: the product with a small integer is exact in the first part
    rest = (angle - quadrant * 1.5707963267341256) - quadrant * 6.077100506506192e-11
    square = rest * rest
    sine = rest * estrin(COEFFICIENTS["sine"], square)
    cosine = estrin(COEFFICIENTS["cosine"], square)
    turn = quadrant - 4.0 * jnp.floor(0.25 * quadrant)
    odd = (turn == 1.0) | (turn == 3.0)
    return (
        jnp.where(turn >= 2.0, -1.0, 1.0) * jnp.where(odd, cosine, sine),
        jnp.where((turn == 1.0) | (turn == 2.0), -1.0, 1.0) * jnp.where(odd, sine, cosine),
    )
