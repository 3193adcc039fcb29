"""Everything that follows from an energy alone."""

from __future__ import annotations

from collections.abc import Callable

import jax
import jax.numpy as jnp

from varistiff.actuators.actuator import Field, Response


def respond_from_energy(energy: Callable[[Field, Field], Field], deflection: Field, setting: Field) -> Response:
    """Load, stiffness and adjusting load by differentiating V(deflection, setting); status ok, stress NaN.

    The energy must be smooth and act elementwise: forward derivatives along one direction then serve every point
    at once, at the price of a few evaluations.
    """
    ones = jnp.ones_like(deflection)

    def along_deflection(value: Field) -> tuple[Field, Field]:
        return jax.jvp(lambda d: energy(d, setting), (value,), (ones,))

    (stored, load), (_, stiffness) = jax.jvp(along_deflection, (deflection,), (ones,))
    adjusting = jax.jvp(lambda s: energy(deflection, s), (setting,), (ones,))[1]
    return Response(
        status=jnp.zeros(jnp.shape(deflection), jnp.int8),
        energy=stored,
        load=load,
        stiffness=stiffness,
        adjusting_load=adjusting,
        stress=jnp.full_like(load, jnp.nan),
    )
