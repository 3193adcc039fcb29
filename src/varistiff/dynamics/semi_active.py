"""Richter's law of a semi-active drive: what a motor on a store returns while it brakes."""

from __future__ import annotations

import jax.numpy as jnp
from jaxtyping import Array, Bool, Float

Scalar = Float[Array, ""]


def semi_active_power(braking_torque: Scalar, rate: Scalar, *, resistance: float, coupling: float) -> Scalar:
    """Power into the store [W]: dE/dt = tau_v w - R tau_v^2/a^2.

    Parameters
    ----------
    braking_torque : tau_v, against a positive rate [N m] or [N]: the drive puts -tau_v on the joint
    rate : w of the output [rad/s] or [m/s]
    resistance : R of the winding [ohm]
    coupling : a, torque of the output per current [N m/A] or [N/A]: gear ratio times torque constant

    Notes
    -----
    An ideal gear and converter, no inductance, no leakage. Khalaf and Richter (2018), doi 10.1115/1.4037653.

    >>> float(semi_active_power(2.0, 3.0, resistance=0.5, coupling=1.0))
    4.0
    """
    return braking_torque * rate - resistance * braking_torque**2 / coupling**2


def best_braking_torque(rate: Scalar, *, resistance: float, coupling: float) -> Scalar:
    """The torque [N m] or [N] that returns most, a^2 w/(2 R): half of where the return ends.

    The power is then a^2 w^2/(4 R): the motor delivers as much as it heats its winding.

    Parameters
    ----------
    rate, resistance, coupling : see ``semi_active_power``

    >>> float(best_braking_torque(3.0, resistance=0.5, coupling=1.0))
    3.0
    """
    return 0.5 * coupling**2 * rate / resistance


def regenerates(braking_torque: Scalar, rate: Scalar, *, resistance: float, coupling: float) -> Bool[Array, ""]:
    """Whether power flows into the store: 0 < tau_v sign(w) < a^2 |w|/R.

    Parameters
    ----------
    braking_torque, rate, resistance, coupling : see ``semi_active_power``

    >>> [bool(regenerates(torque, 3.0, resistance=0.5, coupling=1.0)) for torque in (2.0, -2.0)]
    [True, False]
    """
    along = braking_torque * jnp.sign(rate)
    return (along > 0.0) & (along < coupling**2 * jnp.abs(rate) / resistance)
