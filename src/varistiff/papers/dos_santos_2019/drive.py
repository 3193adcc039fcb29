"""Statements about the motor of the shuttle, held against Richter's law of a semi-active drive.

No motor is published. The law is scale-free: rates are taken in units of R tau/a^2, where the return changes its sign.
"""

from __future__ import annotations

import jax.numpy as jnp

from varistiff.dynamics.semi_active import best_braking_torque, regenerates, semi_active_power

MOTOR = {"resistance": 1.0, "coupling": 1.0}  # any motor, in its own units


def joule_loss() -> float:
    """Least power lost at standstill for currents of either sign, over R I^2; positive: every current costs."""
    losses = [-float(semi_active_power(jnp.asarray(sign), jnp.asarray(0.0), **MOTOR)) for sign in (-1.0, 1.0)]
    return min(losses)


def negative_work_returned() -> tuple[float, float]:
    """Power into the store over R tau^2/a^2 while a thrust brakes the shuttle, from half to twice the limiting rate."""
    low, high = (float(semi_active_power(jnp.asarray(1.0), jnp.asarray(rate), **MOTOR)) for rate in (0.5, 2.0))
    return low, high


def power_of_holding() -> float:
    """Power into the store over R tau^2/a^2 while the motor holds the shuttle of a deflected beam at rest."""
    return float(semi_active_power(jnp.asarray(1.0), jnp.asarray(0.0), **MOTOR))


def damping_by_control() -> float:
    """Least power returned by a damper tau = c w that control makes, for c up to 99 % of a^2/R, over a^2 w^2/R."""
    rate = jnp.asarray(1.0)
    best = best_braking_torque(rate, **MOTOR)
    torques = [share * 2.0 * best for share in (0.01, 0.25, 0.5, 0.75, 0.99)]
    powers = [float(semi_active_power(torque, rate, **MOTOR)) for torque in torques]
    inside = all(bool(regenerates(torque, rate, **MOTOR)) for torque in torques)
    return min(powers) if inside else -1.0
