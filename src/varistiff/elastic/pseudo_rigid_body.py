"""Pseudo-rigid-body model of a cantilever under a roller: one pivot, one torsion spring."""

from __future__ import annotations

import jax.numpy as jnp
from jaxtyping import Array, Float

CHARACTERISTIC_RADIUS = 0.8517  # gamma for a transverse tip force, Howell and Midha (1995)
STIFFNESS_COEFFICIENT = 2.67617  # K_Theta for the same

Field = Float[Array, "..."]


def pseudo_rigid_body_energy(
    tip_x: Field, tip_y: Field, flexural_rigidity: Field, *, coefficient: float = STIFFNESS_COEFFICIENT
) -> Field:
    """V = gamma K_Theta E I Theta^2/(2 L) [J] of a beam whose free length L slides past a point roller.

    The rigid link of length gamma L turns by Theta about a pivot at (1 - gamma) L; both unknowns follow from the
    tip's position, Theta = beta + asin((1/gamma - 1) sin beta) with beta the tip's polar angle.

    Parameters
    ----------
    tip_x, tip_y : contact in the clamp's frame [m]
    flexural_rigidity : E I [N m^2]
    coefficient : K_Theta; 3 gamma makes the model exact at small deflections

    Notes
    -----
    Howell and Midha (1995), doi 10.1115/1.2826101, fitted the constants for a fixed length and a transverse force up
    to large angles; at small ones K_Theta/gamma = 3.142 stands for the exact 3, so it is 4.7 % stiff there.
    """
    beta = jnp.arctan2(tip_y, tip_x)
    gamma = CHARACTERISTIC_RADIUS
    turn = beta + jnp.arcsin((1.0 / gamma - 1.0) * jnp.sin(beta))
    length = jnp.hypot(tip_x, tip_y) / jnp.hypot(1.0 - gamma + gamma * jnp.cos(turn), gamma * jnp.sin(turn))
    return 0.5 * gamma * coefficient * flexural_rigidity * turn**2 / length
