"""Distance of a point from the deformed beam of a roller contact."""

from __future__ import annotations

import jax.numpy as jnp
from jax import lax
from jaxtyping import Array, Float

from varistiff.elastic.lemniscate import slope_terms
from varistiff.elastic.roller_contact import RollerContact

Field = Float[Array, "..."]
_SAMPLES = 32
_REFINEMENTS = 24  # the distance is stationary at the foot: its error is the square of this bracket


def beam_clearance(state: RollerContact, reach: Field, along: Field, across: Field, length: Field) -> Field:
    """Signed distance of a point from the beam's centreline [m], positive on the side the beam bends to.

    In the contact's frame (origin T, tangent, normal) the beam before the contact is
    Q(psi) = X sqrt(sin psi/sin t) (-1, offset_ratio(psi)), 0 <= psi <= t, and the free tail is straight.

    Parameters
    ----------
    state : the solved contact
    reach : X = C.t^ [m]
    along, across : the point relative to T, along the tangent and the normal there [m]
    length : of the whole beam [m]; the tail ends there
    """
    tail = jnp.maximum(length - state.arc_length, 0.0)
    beyond_end = jnp.hypot(along - tail, across)
    on_tail = jnp.where(along > tail, beyond_end, across)
    return jnp.where(along >= 0.0, on_tail, _before_contact(state, reach, along, across))


def _before_contact(state: RollerContact, reach: Field, along: Field, across: Field) -> Field:
    """Signed distance from the bent part: the foot of the perpendicular is bracketed by samples, then bisected."""

    def foot_side(fraction: Field) -> tuple[Field, Field]:
        # psi = t fraction^2 spaces the points evenly along the beam near the contact
        terms = slope_terms(state.slope * fraction * fraction)
        stretch = reach * jnp.sqrt(terms.sine / jnp.maximum(state.sine, 1e-300))
        dx, dy = along + stretch, across - stretch * terms.offset_ratio
        return dx * terms.cosine - dy * terms.sine, dx * terms.sine + dy * terms.cosine

    def scan(low: Field, index: Field) -> tuple[Field, None]:
        fraction = (index + 1.0) / _SAMPLES
        ahead, _ = foot_side(fraction + 0.0 * low)
        # ahead < 0: the point still projects behind this sample, walk on towards the clamp
        return jnp.where((ahead < 0.0) & (low == index / _SAMPLES), fraction, low), None

    low = lax.scan(scan, jnp.zeros_like(along), jnp.arange(_SAMPLES, dtype=along.dtype))[0]
    high = jnp.minimum(low + 1.0 / _SAMPLES, 1.0)

    def bisect(_: int, bounds: tuple[Field, Field]) -> tuple[Field, Field]:
        middle = 0.5 * (bounds[0] + bounds[1])
        ahead, _unused = foot_side(middle)
        return jnp.where(ahead < 0.0, middle, bounds[0]), jnp.where(ahead < 0.0, bounds[1], middle)

    low, high = lax.fori_loop(0, _REFINEMENTS, bisect, (low, high))
    ahead, distance = foot_side(0.5 * (low + high))
    # past the clamp there is no beam: the clamp itself is the nearest point
    return jnp.where(low >= 1.0, jnp.hypot(ahead, distance), distance)
